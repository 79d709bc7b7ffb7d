#include "rtserver/walk/recording.h"

#include <cmath>
#include <utility>

namespace rtserver {

namespace {

float between(float from, float to, double fraction) {
    if (from == to) return to;
    const double a = std::log(static_cast<double>(from)), b = std::log(static_cast<double>(to));
    return static_cast<float>(std::exp(a + (b - a) * fraction));
}

} // namespace

Recording::Recording(const std::filesystem::path& list, double framesPerSecond)
    : recorder_(list), interval_(1 / framesPerSecond) {}

void Recording::add(rtcore::CameraFile camera) {
    camera.time = static_cast<double>(taken_) * interval_.count();
    waiting_.push_back(std::move(camera));
    ++taken_;
    next_ = std::chrono::duration_cast<std::chrono::nanoseconds>(static_cast<double>(taken_) * interval_);
}

void Recording::settle(float exposure) {
    const std::vector<rtcore::CameraFile> cameras = std::exchange(waiting_, {});
    const float before = exposure_ > 0 ? exposure_ : exposure;
    exposure_ = exposure;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        rtcore::CameraFile camera = cameras[i];
        const double fraction = static_cast<double>(i + 1) / static_cast<double>(cameras.size());
        camera.exposure = between(before, exposure, fraction);
        recorder_.add(camera);
    }
}

void Recording::finish() {
    if (!waiting_.empty()) settle(exposure_ > 0 ? exposure_ : 1);
    recorder_.finish();
}

} // namespace rtserver

#include "rtserver/frames/gradual_image.h"

#include <optional>
#include <utility>

namespace rtserver {

namespace {

using namespace std::chrono_literals;

// Steps in which little changes, and not more of them than can be seen.
constexpr double kStepPart = 1.0 / 48; ///< of the pixels
constexpr auto kMinWait = 16ms, kMaxWait = 250ms;

} // namespace

void GradualImage::begin(const rtcore::Frame& before, const rtcore::RenderSettings& settings, float exposure,
                         int threads, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    finished_.clear();
    waiting_.clear();
    pixels_ = static_cast<double>(settings.width) * settings.height;
    exposure_ = exposure;
    brightened_ = brightening_ = 1;
    transition_.begin(before, settings, threads);
    shown_ = now;
    active_ = true;
    developed_ = false;
}

void GradualImage::showBy(const rtcore::FalseColours* falseColours) {
    const std::lock_guard lock(mutex_);
    transition_.showBy(falseColours != nullptr ? std::optional(*falseColours) : std::nullopt);
}

void GradualImage::beginAgain(const rtcore::Frame& better, const rtcore::RenderSettings& settings,
                              int threads) {
    const std::lock_guard lock(mutex_);
    transition_.step(finished_.take(), better.radiance);
    transition_.step({}, better.radiance); // the other half of them
    brightened_ *= transition_.brightening();
    brightening_ = brightened_;
    finished_.clear();
    waiting_.clear();
    transition_.begin(better, settings, threads);
    developed_ = false;
}

void GradualImage::end() {
    const std::lock_guard lock(mutex_);
    active_ = false;
}

void GradualImage::drop() {
    const std::lock_guard lock(mutex_);
    transition_ = {};
    waiting_ = {};
}

/// Whether anything changes by it.
bool GradualImage::expose(float exposure) {
    if (std::exchange(exposure_, exposure) == exposure && developed_) return false;
    developed_ = true;
    transition_.expose(exposure_);
    return true;
}

const rtcore::LdrImage* GradualImage::step(const rtcore::HdrImage& radiance,
                                           const std::function<float(float)>& exposure,
                                           Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (!active_ || now - shown_ < kMinWait) return nullptr;
    const std::vector<rtcore::PixelArea> finished = finished_.take();
    waiting_.insert(waiting_.end(), finished.begin(), finished.end());
    const bool exposed = expose(exposure(brightening_));
    const bool enough = pixelsOf(waiting_) >= kStepPart * pixels_ || now - shown_ >= kMaxWait;
    if (enough) {
        transition_.step(std::exchange(waiting_, {}), radiance);
        brightening_ = brightened_ * transition_.brightening();
    }
    if (!enough && !exposed) return nullptr;
    shown_ = now;
    return &transition_.image();
}

} // namespace rtserver

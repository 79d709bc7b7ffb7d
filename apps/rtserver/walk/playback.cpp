#include "rtserver/walk/playback.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

constexpr std::chrono::duration<double> kCameraInterval{1.0 / 30};

} // namespace

Playback::Playback(const std::filesystem::path& list, const rtcore::LocalOrigin& zero) {
    const std::vector<std::filesystem::path> files = rtcore::readCameraList(list);
    if (files.empty())
        throw rtcore::FileError(rtcore::FailureKind::BadData, list.string(), "the list names no camera");
    for (const std::filesystem::path& file : files) {
        std::error_code unknown;
        if (!std::filesystem::exists(file, unknown))
            throw rtcore::FileError(rtcore::FailureKind::NoInput, list.string(),
                                    rtcore::say("it names {0}, which is not there", file.string()));
    }
    shots_ = files.size();
    read_ = [files, zero](std::size_t i) { return Shot{rtcore::readCameraFile(files[i], zero), files[i]}; };
    readNext();
}

Playback::Playback(const rtcore::FlightCourse& course, double from) {
    constexpr double kPerSecond = 60;
    const double left = std::max(0.0, course.seconds() - from);
    shots_ = static_cast<std::size_t>(std::ceil(left * kPerSecond)) + 1; // the last one is its end
    read_ = [course, from, left](std::size_t i) {
        const double time = std::min(static_cast<double>(i) / kPerSecond, left);
        const rtcore::FlightView view = course.at(from + time);
        rtcore::CameraFile file;
        file.camera = view.camera;
        file.exposure = view.exposure;
        file.time = time;
        return Shot{file, {}};
    };
    readNext();
}

void Playback::readNext() {
    next_.reset();
    if (following_ == shots_) return;
    const bool first = following_ == 0;
    next_ = read_(following_++);
    const std::optional<double> time = next_->camera.time;
    if (first) firstTime_ = time;
    const std::chrono::duration<double> usual = first ? due_ : due_ + kCameraInterval;
    due_ = time && firstTime_ ? std::max(due_, std::chrono::duration<double>(*time - *firstTime_)) : usual;
}

std::optional<Playback::Shot> Playback::advance(std::chrono::nanoseconds time) {
    now_ += time;
    std::optional<Shot> shot;
    while (next_ && due_ <= now_) {
        shot = std::exchange(next_, std::nullopt);
        readNext();
    }
    return shot;
}

bool Playback::ended() const { return !next_ && now_ >= due_ + kCameraInterval; }

std::chrono::nanoseconds Playback::untilNext() const {
    const auto until = (next_ ? due_ : due_ + kCameraInterval) - now_;
    return std::max(std::chrono::nanoseconds(0), std::chrono::duration_cast<std::chrono::nanoseconds>(until));
}

} // namespace rtserver

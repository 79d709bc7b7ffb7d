#include "rtserver/walk/playback.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace rtserver {

namespace {

constexpr std::chrono::duration<double> kCameraInterval{1.0 / 30};

} // namespace

Playback::Playback(const std::filesystem::path& list, const rtcore::LocalOrigin& zero)
    : files_(rtcore::readCameraList(list)), zero_(zero) {
    if (files_.empty())
        throw rtcore::FileError(rtcore::FailureKind::BadData, list.string(), "the list names no camera");
    for (const std::filesystem::path& file : files_) {
        std::error_code unknown;
        if (!std::filesystem::exists(file, unknown))
            throw rtcore::FileError(rtcore::FailureKind::NoInput, list.string(),
                                    rtcore::say("it names {0}, which is not there", file.string()));
    }
    readNext();
}

void Playback::readNext() {
    next_.reset();
    if (following_ == files_.size()) return;
    const bool first = following_ == 0;
    const std::filesystem::path& path = files_[following_];
    next_ = Shot{rtcore::readCameraFile(path, zero_), path};
    ++following_;
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

/// Tells movements of the camera that another client brings about from those that the bridge's own keys,
/// turns and requests have caused, by the server's status alone. Pure.
#pragma once

#include "ipc/layout/status.h"

#include <algorithm>
#include <array>

namespace bridge {

/// One thread. Input given to the server takes effect some frames later, and however long these last: own
/// movement is over after a count of frames, not after a time. While walking it goes on without keys (falls,
/// jumps), so that there the server must have come to rest, too, unless the view turns, which nothing does by
/// itself. Then, and as long as nothing of one's own is given, all movement is another's.
class CameraWatch {
  public:
    /// Something is given to the server that may move the camera, or is still being given: keys that are
    /// held, a request without an answer. Seconds of any clock.
    void acted(double now) {
        own_ = true;
        frames_ = 0;
        acted_ = now;
    }

    /// A status of the server: true when another client has moved the camera since the one before.
    bool moved(const ipc::Status& status, double now) {
        const bool first = !known_;
        // Without a frame for long the server rests: what was given moved nothing, or little.
        if (!first && last_.idle != 0 && now - std::max(acted_, looked_) >= quietSeconds()) own_ = false;
        const bool turned = !std::ranges::equal(status.forward, last_.forward);
        const bool went = !std::ranges::equal(status.eye, last_.eye);
        const bool settled = frames_ >= kFrames;
        const bool others = own_ ? settled && (turned || (went && status.mode == kFlying)) : turned || went;
        if (status.frameSeconds != last_.frameSeconds) ++frames_;
        if (status.idle != 0 && frames_ >= kFrames) own_ = false;
        known_ = true;
        last_ = status;
        looked_ = now;
        return others && !first;
    }

    /// Another server, whose camera begins elsewhere.
    void restart(double now) {
        known_ = false;
        acted(now);
    }

  private:
    /// One that was under way, one with half of a turn, one with the rest of it, and the same of a status
    /// that is looked at between a frame and its status.
    static constexpr int kFrames = 5;
    static constexpr std::uint32_t kFlying = 0;
    double quietSeconds() const {
        constexpr double kMin = 5, kFrameTimes = 4;
        return std::max(kMin, kFrameTimes * last_.frameSeconds);
    }

    ipc::Status last_;
    bool known_ = false, own_ = true;
    int frames_ = 0; ///< that were seen since something was given
    double acted_ = 0, looked_ = 0;
};

} // namespace bridge

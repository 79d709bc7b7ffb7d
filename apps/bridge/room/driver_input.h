/// Keys and turns of the page that drives, on their way to the server; and who else moves the camera.
#pragma once

#include "bridge/clock.h"
#include "bridge/control/camera_watch.h"
#include "bridge/control/input_state.h"
#include "bridge/control/locked_keys.h"
#include "bridge/control/roles.h"
#include "bridge/control/server_commands.h"

#include <map>
#include <optional>

namespace bridge {

/// One thread.
class DriverInput {
  public:
    /// Both must outlive it.
    DriverInput(const Limits& limits, const Clock& clock) : clock_(clock), lockedKeys_(limits) {}

    /// The server's answer to `bindings` says which keys are locked, where any can be.
    LockedKeys& lockedKeys() { return lockedKeys_; }
    void leave(SessionId id) { inputs_.erase(id); }

    enum class Given {
        Nothing, ///< an old message
        Rest,    ///< nothing is held or done any more
        Action,
    };
    /// Input of the driver.
    Given give(SessionId driver, const InputMessage& sent, ServerCommands& server);
    /// All keys are let go of: `last`, if any, drives no more.
    void release(std::optional<SessionId> last, ServerCommands& server);
    /// True: keys were held, and are not any more, since nothing came from the page.
    bool expire(SessionId driver, ServerCommands& server);

    /// Something of the bridge's own moves the camera.
    void moves() { camera_.acted(clock_.seconds()); }
    /// Notes that the camera moves on where the driver holds keys.
    void goOn(std::optional<SessionId> driver);
    /// By this status another client moved the camera: true once in 10 s.
    bool movedByOther(const ipc::Status& status);
    void serverGone();

  private:
    const Clock& clock_;
    LockedKeys lockedKeys_;
    CameraWatch camera_;
    std::map<SessionId, InputState> inputs_; ///< of those that have driven
    double lastElsewhere_ = -1e9;
};

} // namespace bridge

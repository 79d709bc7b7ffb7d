#include "rtserver/server_status.h"

#include "common/frames/frame_status.h"

namespace rtserver {

ipc::Status statusOf(const ServerState& state, const FrameMaker& frames, const Activity& activity) {
    ipc::Status status;
    status.progress = activity.progress;
    status.paused = state.paused ? 1 : 0;
    status.recording = state.recording() ? 1 : 0;
    status.messages = activity.messages;
    status.stateRevision = activity.stateRevision;
    status.framesPerSecond = activity.framesPerSecond;
    status.wholeSeconds = activity.wholeSeconds;
    if (!state.ready()) return status;
    status.frameSeconds = frames.seconds();
    status.raysPerSecond = frames.seconds() > 0 ? static_cast<double>(frames.rays()) / frames.seconds() : 0;
    status.polygons = state.scene()->model.mesh.triangles.size();
    app::setView(state.camera(), state.settings().width, state.settings().height, status);
    status.mode = state.onUnseenFloor() ? 2 : state.walking() ? 1 : 0;
    status.exposure = frames.exposure();
    status.kept = static_cast<float>(frames.kept());
    status.idle = activity.idle ? 1 : 0;
    return status;
}

} // namespace rtserver

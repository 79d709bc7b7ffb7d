#include "rtserver/loop/server_status.h"

#include "common/frames/frame_status.h"

namespace rtserver {

ipc::Status statusOf(const Workspace& state, const FrameMaker& frames, const Activity& activity) {
    ipc::Status status;
    status.progress = activity.progress;
    status.paused = state.paused ? 1 : 0;
    status.recording = state.walk.recording() ? 1 : 0;
    status.messages = activity.messages;
    status.stateRevision = activity.stateRevision;
    status.imageRevision = activity.imageRevision;
    status.framesPerSecond = activity.framesPerSecond;
    status.wholeSeconds = activity.wholeSeconds;
    if (!state.document.ready()) return status;
    status.frameSeconds = frames.seconds();
    status.raysPerSecond = frames.seconds() > 0 ? static_cast<double>(frames.rays()) / frames.seconds() : 0;
    status.polygons = state.document.scene()->model.mesh.triangles.size();
    app::setView(state.document.camera(), state.document.scene()->origin, state.document.settings().width,
                 state.document.settings().height, status);
    status.mode = state.walk.onUnseenFloor() ? 2 : state.walk.walking() ? 1 : 0;
    status.exposure = frames.exposure();
    status.kept = static_cast<float>(frames.kept());
    status.lightError = static_cast<float>(frames.indirectError());
    status.idle = activity.idle ? 1 : 0;
    return status;
}

} // namespace rtserver

#include "common/frames/frame_status.h"

#include "rtcore/render/camera_rays.h"

#include <algorithm>
#include <cstdint>

namespace app {

namespace {

void copy(rtcore::Vec3 from, float (&to)[3]) {
    for (int i = 0; i < 3; ++i) to[i] = from[i];
}

} // namespace

void setView(const rtcore::Camera& camera, const rtcore::LocalOrigin& origin, int width, int height,
             ipc::Status& status) {
    status.width = static_cast<std::uint32_t>(width);
    status.height = static_cast<std::uint32_t>(height);
    copy(camera.eye, status.eye);
    std::ranges::copy(origin.at, status.origin);
    copy(normalize(camera.forward), status.forward);
    copy(normalize(camera.up), status.up);
    status.fieldOfView = rtcore::fieldOfView(camera, width, height);
    const bool parallel = camera.kind == rtcore::CameraKind::Orthographic;
    status.parallelWidth = parallel ? camera.orthographicWidth * rtcore::widening(camera, width, height) : 0;
}

} // namespace app

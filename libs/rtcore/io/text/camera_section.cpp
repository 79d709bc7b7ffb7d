#include "rtcore/io/text/camera_section.h"

#include "rtcore/scene/image.h"

namespace rtcore {

namespace {

constexpr Limits kFieldOfView{.minimum = 0, .maximum = 180, .minimumExcluded = true, .maximumExcluded = true};
constexpr Limits kWidth{.minimum = 0, .maximum = 1e18, .minimumExcluded = true};
constexpr Limits kAspect{.minimum = 1.0 / kMaxImageSide, .maximum = kMaxImageSide};

bool isZero(Vec3 a) { return normalize(a) == Vec3{}; }

} // namespace

Camera readCamera(StrictTable& table, Vec3 up, bool lookAtAllowed) {
    const auto eye = table.vector("eye");
    auto forward = table.vector("forward");
    const auto lookAt = lookAtAllowed ? table.vector("lookAt") : std::nullopt;
    const auto givenUp = table.vector("up");
    const auto fov = table.number("fov", kFieldOfView);
    const auto width = table.number("orthographicWidth", kWidth);
    const auto aspect = table.number("aspect", kAspect);
    table.finish();

    Camera camera;
    camera.eye = table.require("eye", eye);
    if (forward && lookAt) table.fail("lookAt", "forward and lookAt are both given; leave one out");
    if (lookAt) forward = *lookAt - camera.eye;
    camera.forward = table.require("forward", forward);
    camera.up = givenUp.value_or(upwardsOf(camera.forward, up));
    if (fov && width) table.fail("fov", "fov and orthographicWidth are both given; leave one out");
    camera.horizontalFov = fov.value_or(camera.horizontalFov);
    if (width) camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = width.value_or(0);
    camera.aspect = aspect.value_or(0);

    if (lookAt && isZero(camera.forward))
        table.fail("lookAt", "lookAt is where eye is; the camera needs a direction");
    if (isZero(camera.forward)) table.fail("forward", "forward is zero; the camera needs a direction");
    if (isZero(camera.up)) table.fail("up", "up is zero; give the direction that is up in the image");
    if (areParallel(camera.forward, camera.up))
        table.fail("up", "up is parallel to the view direction; give another up");
    return camera;
}

void writeCamera(TomlWriter& writer, const Camera& camera) {
    writer.add("eye", camera.eye);
    writer.add("forward", camera.forward);
    writer.add("up", camera.up);
    if (camera.kind == CameraKind::Orthographic) {
        writer.add("orthographicWidth", camera.orthographicWidth);
    } else {
        writer.add("fov", camera.horizontalFov);
    }
    if (camera.aspect > 0) writer.add("aspect", camera.aspect);
}

} // namespace rtcore

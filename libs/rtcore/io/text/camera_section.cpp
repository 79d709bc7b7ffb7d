#include "rtcore/io/text/camera_section.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/scene/image.h"

namespace rtcore {

namespace {

constexpr Limits kFieldOfView{.minimum = 0, .maximum = 180, .minimumExcluded = true, .maximumExcluded = true};
constexpr Limits kWidth{.minimum = 0, .maximum = 1e18, .minimumExcluded = true};
constexpr Limits kAspect{.minimum = 1.0 / kMaxImageSide, .maximum = kMaxImageSide};

bool isZero(Vec3 a) { return normalize(a) == Vec3{}; }

} // namespace

Camera readCamera(StrictTable& table, Vec3 up, bool lookAtAllowed) {
    const auto eye = table.position("eye");
    auto forward = table.vector("forward");
    const auto lookAt = lookAtAllowed ? table.position("lookAt") : std::nullopt;
    const auto givenUp = table.vector("up");
    const auto fov = table.number("fov", kFieldOfView);
    const auto width = table.number("orthographicWidth", kWidth);
    const auto aspect = table.number("aspect", kAspect);
    table.finish();

    Camera camera;
    camera.eye = table.require("eye", eye);
    if (forward && lookAt)
        table.fail("lookAt", say("{0} and {1} are both given; leave one out", std::string("forward"),
                                 std::string("lookAt")));
    if (lookAt) forward = *lookAt - camera.eye;
    camera.forward = table.require("forward", forward);
    camera.up = givenUp.value_or(upwardsOf(camera.forward, up));
    if (fov && width)
        table.fail("fov", say("{0} and {1} are both given; leave one out", std::string("fov"),
                              std::string("orthographicWidth")));
    camera.horizontalFov = fov.value_or(camera.horizontalFov);
    if (width) camera.kind = CameraKind::Orthographic;
    camera.orthographicWidth = width.value_or(0);
    camera.aspect = aspect.value_or(0);

    if (lookAt && isZero(camera.forward))
        table.fail("lookAt", say("lookAt is where eye is; the camera needs a direction"));
    if (isZero(camera.forward)) table.fail("forward", say("forward is zero; the camera needs a direction"));
    if (isZero(camera.up)) table.fail("up", say("up is zero; give the direction that is up in the image"));
    if (areParallel(camera.forward, camera.up))
        table.fail("up", say("up is parallel to the view direction; give another up"));
    return camera;
}

void writeCamera(TomlWriter& writer, const Camera& camera, const LocalOrigin& zero) {
    writer.addPosition("eye", camera.eye, zero);
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

#include "rtcore/io/text/camera_section.h"

namespace rtcore {

namespace {

constexpr Limits kFieldOfView{.minimum = 0, .maximum = 180, .minimumExcluded = true, .maximumExcluded = true};
constexpr float kParallelSine = 1e-5F;

bool parallel(Vec3 a, Vec3 b) { return length(cross(normalize(a), normalize(b))) < kParallelSine; }
bool isZero(Vec3 a) { return normalize(a) == Vec3{}; }

} // namespace

Camera readCamera(StrictTable& table, Vec3 up, bool lookAtAllowed) {
    const auto eye = table.vector("eye");
    auto forward = table.vector("forward");
    const auto lookAt = lookAtAllowed ? table.vector("lookAt") : std::nullopt;
    const auto givenUp = table.vector("up");
    const auto fov = table.number("fov", kFieldOfView);
    table.finish();

    Camera camera;
    camera.eye = table.require("eye", eye);
    if (forward && lookAt) table.fail("lookAt", "forward and lookAt are both given; leave one out");
    if (lookAt) forward = *lookAt - camera.eye;
    camera.forward = table.require("forward", forward);
    camera.up = givenUp.value_or(up);
    camera.horizontalFov = fov.value_or(camera.horizontalFov);

    const char* const forwardKey = lookAt ? "lookAt" : "forward";
    if (lookAt && isZero(camera.forward))
        table.fail("lookAt", "lookAt is where eye is; the camera needs a direction");
    if (isZero(camera.forward)) table.fail("forward", "forward is zero; the camera needs a direction");
    if (isZero(camera.up)) table.fail("up", "up is zero; give the direction that is up in the picture");
    if (parallel(camera.forward, camera.up))
        table.fail(givenUp ? "up" : forwardKey, "up is parallel to the view direction; give another up");
    return camera;
}

void writeCamera(TomlWriter& writer, const Camera& camera) {
    writer.add("eye", camera.eye);
    writer.add("forward", camera.forward);
    writer.add("up", camera.up);
    writer.add("fov", camera.horizontalFov);
}

} // namespace rtcore

#include "rtcore/motion/orbit.h"

#include "rtcore/motion/flying.h"
#include "rtcore/motion/world_frame.h"

#include <algorithm>

namespace rtcore {

namespace {

/// The axes of an image, unit vectors.
struct ImageAxes {
    Vec3d right, up, forward;

    ImageAxes(Vec3d forwards, Vec3d upwards) : forward(normalize(forwards)) {
        right = normalize(cross(forward, upwards));
        up = cross(right, forward);
    }
    Vec3d at(Vec3d inImage) const { return right * inImage.x + up * inImage.y + forward * inImage.z; }
    Vec3d of(Vec3d way) const { return {dot(way, right), dot(way, up), dot(way, forward)}; }
};

} // namespace

Camera orbited(const Camera& camera, Vec3 up, Vec3 pivot, double right, double upwards) {
    const WorldFrame frame(up, 1);
    const Vec3d forward = frame.turn(camera.forward), about = frame.toMetres(pivot);
    const ImageAxes before(forward, frame.turn(camera.up));
    Heading heading = headingOf(forward, frame.turn(camera.up));
    heading = normalize(Heading{heading.yaw - right, heading.pitch + upwards});
    const ImageAxes after(lookDirection(heading), Vec3d{0, 0, 1});
    Camera result = camera;
    result.eye = frame.toScene(about + after.at(before.of(frame.toMetres(camera.eye) - about)));
    result.forward = frame.turnBack(after.forward);
    result.up = up;
    return result;
}

Camera approached(const Camera& camera, Vec3 pivot, double factor) {
    Camera result = camera;
    const auto left = static_cast<float>(1 / factor);
    const Vec3 way = camera.eye - pivot;
    if (camera.kind == CameraKind::Perspective) {
        result.eye = pivot + way * left;
        return result;
    }
    const Vec3 forward = normalize(camera.forward), along = forward * dot(way, forward);
    result.eye = pivot + along + (way - along) * left;
    result.orthographicWidth = std::clamp(camera.orthographicWidth * left, 1e-18F, 1e18F);
    return result;
}

Camera shifted(const Camera& camera, double right, double upwards) {
    Camera result = camera;
    const Vec3 forward = normalize(camera.forward);
    const Vec3 across = normalize(cross(forward, camera.up));
    const Vec3 up = cross(across, forward);
    result.eye = camera.eye + across * static_cast<float>(right) + up * static_cast<float>(upwards);
    return result;
}

} // namespace rtcore

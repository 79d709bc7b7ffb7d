#include "rtcore/render/framing.h"

#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rtcore {

namespace {

constexpr float kMargin = 0.95F;

/// Right, up and forward in the image, from the middle of the box.
class ImagePoints {
  public:
    ImagePoints(const Camera& camera, const Box3& box)
        : middle_(box.centre()), forward_(normalize(camera.forward)),
          right_(normalize(cross(forward_, camera.up))), up_(cross(right_, forward_)) {}

    Vec3 of(Vec3 position) const {
        const Vec3 p = position - middle_;
        return {dot(p, right_), dot(p, up_), dot(p, forward_)};
    }
    Vec3 back(Vec3 p) const { return middle_ + right_ * p.x + up_ * p.y + forward_ * p.z; }

  private:
    Vec3 middle_, forward_, right_, up_;
};

std::vector<Vec3> pointsIn(const Mesh& mesh, const Box3& box, const ImagePoints& image) {
    constexpr std::size_t kSamples = 50'000;
    std::vector<Vec3> points;
    const std::size_t step = std::max<std::size_t>(1, mesh.vertices.size() / kSamples);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += step) {
        const Vec3 position = mesh.vertices[i].position();
        if (box.contains(position)) points.push_back(image.of(position));
    }
    if (!points.empty()) return points;
    for (int corner = 0; corner < 8; ++corner)
        points.push_back(
            image.of({(corner & 1) != 0 ? box.hi.x : box.lo.x, (corner & 2) != 0 ? box.hi.y : box.lo.y,
                      (corner & 4) != 0 ? box.hi.z : box.lo.z}));
    return points;
}

} // namespace

Camera framed(const Mesh& mesh, const Box3& box, Camera camera, float aspect) {
    const ImagePoints image(camera, box);
    const std::vector<Vec3> points = pointsIn(mesh, box, image);
    Box3 seen;
    for (const Vec3 point : points) seen.extend(point);
    const Vec3 middle = seen.centre();
    float distance = 0, width = 0;
    const float half = camera.horizontalFov * kPi / 360;
    // An author's aspect widens images that are wider (camera.h).
    const float across = portableSin(half) / portableCos(half) * kMargin *
                         (camera.aspect > 0 ? std::max(1.0F, aspect / camera.aspect) : 1.0F);
    for (const Vec3 point : points) {
        const Vec3 p = point - middle;
        distance =
            std::max({distance, std::fabs(p.x) / across - p.z, std::fabs(p.y) * aspect / across - p.z});
        width = std::max({width, 2 * std::fabs(p.x), 2 * std::fabs(p.y) * aspect});
    }
    if (camera.kind == CameraKind::Orthographic) {
        camera.orthographicWidth = width > 0 ? width / kMargin : 1;
        distance = box.diagonal();
    }
    camera.eye = image.back(middle - Vec3{0, 0, distance > 0 ? distance : 1.0F});
    return camera;
}

} // namespace rtcore

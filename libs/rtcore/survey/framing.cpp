#include "rtcore/survey/framing.h"

#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace rtcore {

namespace {

constexpr float kMargin = 0.88F;

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

/// How far points are beyond the borders of the image along an axis, for an eye at `distance` before depth 0
/// whose image reaches `reach` times the distance to either side; below 0 for within.
struct Overhang {
    Overhang(std::span<const Vec3> points, int axis, float distance, float reach) {
        for (const Vec3 p : points) {
            const float border = reach * (p.z + distance);
            above = std::max(above, p[axis] - border);
            below = std::max(below, -p[axis] - border);
        }
    }
    float both() const { return above + below; }         ///< at most 0: beside there all is seen
    float middle() const { return (above - below) / 2; } ///< where that is
    float above = std::numeric_limits<float>::lowest(), below = std::numeric_limits<float>::lowest();
};

/// From where at that distance the outermost points are equally far from the middle of the image.
float middleOf(std::span<const Vec3> points, int axis, float distance, float reach) {
    float low = 0, high = reach;
    constexpr int kSteps = 16; // a hundredth of a pixel
    for (int i = 0; i < kSteps; ++i) {
        const float between = (low + high) / 2;
        (Overhang(points, axis, distance, between).both() > 0 ? low : high) = between;
    }
    return Overhang(points, axis, distance, high).middle();
}

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
    std::vector<Vec3> points = pointsIn(mesh, box, image);
    Box3 seen;
    for (const Vec3 point : points) seen.extend(point);
    const Vec3 middle = seen.centre();
    const float half = camera.horizontalFov * kPi / 360;
    // An author's aspect widens images that are wider (camera.h).
    const float across = portableSin(half) / portableCos(half) * kMargin *
                         (camera.aspect > 0 ? std::max(1.0F, aspect / camera.aspect) : 1.0F);
    for (Vec3& point : points) point = point - middle;
    Vec3 eye = middle;
    if (camera.kind == CameraKind::Orthographic) {
        const float width = std::max(seen.size().x, seen.size().y * aspect);
        camera.orthographicWidth = width > 0 ? width / kMargin : 1;
        eye.z -= box.diagonal();
    } else {
        const float far = std::max(Overhang(points, 0, 0, across).both() / (2 * across),
                                   Overhang(points, 1, 0, across / aspect).both() / (2 * across / aspect));
        const float distance = far > 0 ? far : 1;
        eye += {middleOf(points, 0, distance, across), middleOf(points, 1, distance, across / aspect),
                -distance};
    }
    camera.eye = image.back(eye);
    return camera;
}

} // namespace rtcore

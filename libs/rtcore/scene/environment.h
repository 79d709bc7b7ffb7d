/// The view of a ray that leaves the scene: a cube map or an equirectangular image at infinite distance.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/environment_light.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/texel_filter.h"

#include <array>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace rtcore {

/// Safe from many threads while it is not changed. Copies are cheap. Directions need not be normalised, only
/// finite and not zero.
class Environment {
  public:
    /// Six square faces of one size as cube maps list them: right (+x), left (-x), up (+y), down (-y), ahead
    /// (-z), behind (+z), each as it looks from inside. Throws std::invalid_argument when the sizes differ.
    static Environment fromCube(std::array<HdrImage, 6> faces, std::string name);
    /// Full sphere: u = 0.5 + atan2(x, -z) / 2 pi, v = acos(y) / pi, rows from the top.
    static Environment fromEquirectangular(const HdrImage& image, std::string name);

    /// Radiance from `direction`. Bilinear lookups have no seam at the edges of faces, at the wrap or at the
    /// poles.
    Colour radiance(Vec3 direction, TexelFilter filter) const;

    /// Mean over all directions.
    Colour meanRadiance() const { return intensity * mean_; }

    /// All directions in some 10^5 cells of half a degree at most, without the intensity.
    std::vector<EnvironmentCell> cells() const;
    /// Its image, or six faces as fromCube() takes them, each with a border of one texel around it; without
    /// the intensity.
    std::span<const HdrImage> images() const { return *images_; }
    /// A direction of the images as it is seen: turned by rotation().
    Vec3 turned(Vec3 ofImage) const {
        return axes_[0] * ofImage.x + axes_[1] * ofImage.y + axes_[2] * ofImage.z;
    }
    /// Its light on surfaces, without the intensity. Made when first asked for, in some 10^-2 s for each
    /// 10^6 texels; other threads wait for that. A copy that is turned makes its own.
    const EnvironmentLight& light() const;

    const std::string& name() const { return name_; }
    float intensity = 1; ///< factor on every texel
    /// Turns it about `up`, a unit vector: what its image has straight ahead is seen so many degrees to the
    /// right then, as one stands. Earlier turns are forgotten.
    void turn(float degrees, Vec3 up);
    float rotation() const { return rotation_; } ///< degrees
    bool isCube() const { return cube_; }

  private:
    struct LazyLight {
        std::once_flag made;
        EnvironmentLight light;
    };

    Environment() = default;

    std::string name_;
    bool cube_ = false;
    Colour mean_; ///< without the intensity
    /// Six faces with a border of one texel, or one image; copies share them.
    std::shared_ptr<const std::vector<HdrImage>> images_;
    float rotation_ = 0;
    std::array<Vec3, 3> axes_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};      ///< of the images, as they are seen
    std::shared_ptr<LazyLight> light_ = std::make_shared<LazyLight>(); ///< copies share it
};

/// Direction -> face (0..5 in the order above) and s, t in [0, 1] on it, t down: OpenGL 4.6, table 8.19,
/// for (x, y, -z), since cube maps are left-handed.
struct CubeCoordinate {
    int face;
    float s, t;
};
CubeCoordinate cubeCoordinate(Vec3 direction);
/// The direction through (s, t) of a face, not normalised; s and t may lie outside [0, 1]. Inverse of the
/// above.
Vec3 cubeDirection(int face, float s, float t);

} // namespace rtcore

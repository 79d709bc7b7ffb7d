/// A thin lens in front of the eye: only what lies in one plane is sharp.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/settings/render_settings.h"

namespace rtcore {

/// Where rays start, as seen from the eye, and where they meet. A pinhole by default.
struct Lens {
    Vec3 right, down; ///< from the middle to the rim, scene units; along the rows and columns of the image
    float inverseFocus = 0; ///< 1 / distance along the axis of what is sharp, per scene unit; 0 = infinity

    bool open() const { return !(right == Vec3{} && down == Vec3{}); }
};

/// From this distance on, scene units, a lens is focused at infinity.
inline constexpr float kInfiniteFocus = 1e15F;

/// A lens that makes the camera's image on a film 36 mm wide while it is focused at `focus` (scene units
/// along the axis): the film lies v = 18 mm / tan(fov / 2) behind it, so its focal length is f
/// = 1 / (1 / v + 1 / focus), and its radius f / (2 fNumber). Then a point at distance x is blurred to a disc
/// of radius r |x - focus| / (x focus) at distance 1, as by the thin lens equation. `horizontalFov` is the
/// camera's; not of parallel rays.
Lens makeLens(const CameraRays& view, float horizontalFov, float fNumber, float focus, float metresPerUnit);

/// Finds what an image is to be focused at.
class FocusFinder {
  public:
    /// Along the axis to what is seen at (x, y) pixels of the image, in scene units; kInfiniteFocus for
    /// nothing.
    float distance(const RayTracer& tracer, const CameraRays& view, float x, float y);

  private:
    RayWave ray_; // kept, so that steady frames allocate nothing
    HitWave hit_;
};

} // namespace rtcore

/// Rays of a pinhole camera with a flat picture.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/camera.h"

namespace rtcore {

/// Directions for a picture of `width` x `height` pixels; pixels are square, so the vertical field of view
/// follows.
class CameraRays {
  public:
    CameraRays(const Camera& camera, int width, int height);

    /// The ray through the point (x, y) of the picture, in pixels from its upper left corner; unit length,
    /// from 0 to infinity.
    Ray at(float x, float y) const;

  private:
    Vec3 eye_;
    Vec3 corner_;       ///< towards the upper left corner of the picture at distance 1
    Vec3 right_, down_; ///< one pixel, at distance 1
};

} // namespace rtcore

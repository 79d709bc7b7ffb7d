/// Rays of a pinhole camera with a flat picture.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/camera.h"

namespace rtcore {

/// Rays of neighbouring samples lie together in blocks of 8 x 8, row by row: they take the same way through
/// the tree.
inline constexpr int kCameraBlock = 8;

/// Directions for a picture of `width` x `height` pixels; pixels are square, so the vertical field of view
/// follows.
class CameraRays {
  public:
    CameraRays() = default;
    CameraRays(const Camera& camera, int width, int height);

    /// The ray through the point (x, y) of the picture, in pixels from its upper left corner; unit length,
    /// from 0 to infinity.
    Ray at(float x, float y) const;
    Vec3 eye() const { return eye_; }

    /// Directions of a block of 8 x 8 samples: those of at(left + (i + 0.5) * step, top + (j + 0.5) * step)
    /// for the samples (i, j) from (column, row) on, to dx[64], dy[64], dz[64].
    struct Block {
        float left, top;
        int column, row;
        float step;
    };
    void directions(const Block& block, float* dx, float* dy, float* dz) const;

    /// What directions() is made of.
    struct Plane {
        Vec3 corner;      ///< towards the upper left corner of the picture at distance 1
        Vec3 right, down; ///< one pixel, at distance 1
    };

  private:
    Vec3 eye_;
    Plane plane_;
};

} // namespace rtcore

/// Rays of a camera.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/camera.h"
#include "rtcore/shading/indirect_taps.h"

namespace rtcore {

/// Rays of neighbouring samples lie together in blocks of 8 x 8, and these in quarters of 4 x 4, each row by
/// row: what is near takes the same way through the tree, and one vector of rays covers a square.
inline constexpr int kCameraBlock = 8;
inline constexpr int kCameraBlockRays = kCameraBlock * kCameraBlock;

/// Where in its block the ray of the sample (column, row) stands, 0..63, and the way back.
constexpr int indexInBlock(int column, int row) {
    return (column & 3) | (row & 3) << 2 | (column & 4) << 2 | (row & 4) << 3;
}
constexpr int columnInBlock(int index) { return (index & 3) | (index >> 2 & 4); }
constexpr int rowInBlock(int index) { return (index >> 2 & 3) | (index >> 3 & 4); }

/// Directions for an image of `width` x `height` pixels; pixels are square, so the vertical field of view
/// follows.
class CameraRays {
  public:
    CameraRays() = default;
    CameraRays(const Camera& camera, int width, int height);

    /// All are parallel, and start in a plane through the eye; else all start at the eye.
    bool parallel() const { return parallel_; }
    /// They go to all sides, by around().
    bool panorama() const { return panorama_; }
    /// The tangent of half the field of view is this many times that of the camera's own (scene/camera.h).
    float widened() const { return widened_; }

    /// The ray through the point (x, y) of the image, in pixels from its upper left corner; unit length,
    /// from 0 to infinity.
    Ray at(float x, float y) const;
    Vec3 eye() const { return eye_; }
    Vec3 forward() const { return forward_; } ///< unit

    /// The same view in pixels `factor` times as wide and as high: one of them covers a square of `factor`
    /// pixels a side, and its middle is the middle of that square.
    CameraRays coarser(int factor) const;

    /// Not of parallel rays. Directions of a block of 8 x 8 samples: those of at(left + (i + 0.5) * step, top
    /// + (j + 0.5) * step) for the samples (i, j) from (column, row) on, to dx[64], dy[64], dz[64], at
    /// indexInBlock().
    struct Block {
        float left, top;
        int column, row;
        float step;
    };
    void directions(const Block& block, float* dx, float* dy, float* dz) const;

    /// The image plane, from which directions are computed; of a panorama the size of a pixel in the middle.
    struct Plane {
        Vec3 corner;      ///< towards the upper left corner of the image at distance 1 (parallel: at the eye)
        Vec3 right, down; ///< one pixel, there
    };

    const Plane& plane() const { return plane_; }

    /// Of a panorama: the axes of its middle, and how far a pixel is turned, in radians.
    struct Around {
        Vec3 forward, right, down;
        float column = 0, row = 0;
    };
    const Around& around() const { return around_; }

  private:
    Vec3 eye_, forward_;
    Plane plane_;
    Around around_;
    bool parallel_ = false, panorama_ = false;
    float widened_ = 1;
};

/// Of a pixel that a ray of the camera sees.
inline PixelSize pixelSizeOf(const CameraRays& camera) {
    const float size = length(camera.plane().right);
    return camera.parallel() ? PixelSize{size, 0} : PixelSize{0, size};
}

/// Degrees between the left and right edge of an image of this size; 0 for an orthographic camera, 360 for a
/// panorama.
float fieldOfView(const Camera& camera, int width, int height);

} // namespace rtcore

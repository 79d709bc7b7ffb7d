/// Projection of points onto the image of a perspective camera, and back to directions.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/render/camera_rays.h"

namespace rtcore {

struct ImagePlane {
    Vec3 eye;
    Vec3 corner;      ///< towards the upper left corner of the image, one unit along the axis of view
    Vec3 right, down; ///< one pixel, there
    /// A point at `offset` from the eye is seen at (dot(column, offset), dot(row, offset)) / dot(axis,
    /// offset), where the last is above 0; a point at infinity by its direction.
    Vec3 column, row, axis;
    int width = 0, height = 0;

    ImagePlane() = default;
    ImagePlane(const CameraRays& rays, int w, int h)
        : eye(rays.eye()), corner(rays.plane().corner), right(rays.plane().right), down(rays.plane().down),
          width(w), height(h) {
        const float volume = dot(right, cross(down, corner));
        column = cross(down, corner) / volume;
        row = cross(corner, right) / volume;
        axis = cross(right, down) / volume;
    }
    friend bool operator==(const ImagePlane&, const ImagePlane&) = default;

    /// Direction through the point (x, y) of the image, in pixels from its upper left corner; one unit along
    /// the axis.
    Vec3 towards(float x, float y) const { return corner + right * x + down * y; }
};

} // namespace rtcore

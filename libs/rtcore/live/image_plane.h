/// Where points are in the image of a camera whose rays all begin at its eye, and the way back.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/render/camera_rays.h"

namespace rtcore {

struct ImagePlane {
    Vec3 eye;
    Vec3 corner;            ///< towards the upper left corner of the image, one unit along the axis of view
    Vec3 right, down;       ///< one pixel, there
    Vec3 column, row, axis; ///< what an offset from the eye is multiplied with to find it in the image
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

    /// Through the point (x, y) of the image, in pixels from its upper left corner; one unit along the axis.
    Vec3 towards(float x, float y) const { return corner + right * x + down * y; }

    struct Position {
        bool inside = false;
        float x = 0, y = 0;
    };
    /// Where the point at `offset` from the eye is seen; for what is infinitely far, its direction.
    Position find(Vec3 offset) const {
        const float depth = dot(axis, offset);
        if (!(depth > 0)) return {};
        const float x = dot(column, offset) / depth, y = dot(row, offset) / depth;
        const bool inside =
            x >= 0 && y >= 0 && x < static_cast<float>(width) && y < static_cast<float>(height);
        return {inside, x, y};
    }
};

} // namespace rtcore

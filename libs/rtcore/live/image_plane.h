/// Projection of points onto the image of a camera, and back to rays.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/render/camera_rays.h"

namespace rtcore {

struct ImagePlane {
    Vec3 eye;
    /// Towards the upper left corner of the image, one unit along the axis of view; parallel: from the eye to
    /// that corner.
    Vec3 corner;
    Vec3 right, down; ///< one pixel, there
    /// A point at `offset` from the eye is seen at (dot(column, offset), dot(row, offset)) / dot(axis,
    /// offset), where the last is above 0; a point at infinity by its direction. Parallel: at (dot(column,
    /// offset - corner), dot(row, offset - corner)).
    Vec3 column, row, axis;
    int width = 0, height = 0;
    bool parallel = false; ///< all rays are, and start in a plane through the eye
    /// Parallel: added to depths before their ratio is taken, since the eye may be anywhere along the axis:
    /// the width of what is seen. 0 of a perspective view.
    float addedDepth = 0;

    ImagePlane() = default;
    ImagePlane(const CameraRays& rays, int w, int h)
        : eye(rays.eye()), corner(rays.plane().corner), right(rays.plane().right), down(rays.plane().down),
          width(w), height(h), parallel(rays.parallel()) {
        if (parallel) {
            column = right / dot(right, right);
            row = down / dot(down, down);
            axis = rays.forward();
            addedDepth = length(right) * static_cast<float>(width);
            return;
        }
        const float volume = dot(right, cross(down, corner));
        column = cross(down, corner) / volume;
        row = cross(corner, right) / volume;
        axis = cross(right, down) / volume;
    }
    friend bool operator==(const ImagePlane&, const ImagePlane&) = default;

    /// From the eye to the point (x, y) of the image, in pixels from its upper left corner: of a perspective
    /// view the direction of its ray, one unit along the axis; of a parallel one to where its ray starts.
    Vec3 towards(float x, float y) const { return corner + right * x + down * y; }

    /// The point of the ray through (x, y) in that depth: so many units along the axis.
    Vec3 inDepth(float x, float y, float depth) const {
        return parallel ? eye + towards(x, y) + axis * depth : eye + towards(x, y) * depth;
    }
    float depthOf(Vec3 point) const { return dot(axis, point - eye); }

    /// The point of the ray through `point` that is so far from where the ray starts.
    Vec3 alongRay(Vec3 point, float distance) const {
        if (parallel) return point + axis * (distance - depthOf(point));
        const Vec3 towardsPoint = point - eye;
        return eye + towardsPoint * (distance / length(towardsPoint));
    }

    /// Whether nothing but a shift lies between both images: each surface moves by as many pixels.
    bool shiftedFrom(const ImagePlane& before) const {
        return parallel && before.parallel && right == before.right && down == before.down;
    }
};

} // namespace rtcore

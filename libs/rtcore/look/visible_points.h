/// A few hundred visible points of a scene, and how lights reach them.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/math/box.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/light.h"
#include "rtcore/scene/mesh.h"

#include <span>
#include <vector>

namespace rtcore {

/// A point of a surface, a little before it, and the surface's unit normal there to the viewer's side.
struct VisiblePoint {
    Vec3 position, normal;
};

/// kSeenAcross x kSeenDown rays, in an image of 16:9; those that hit nothing are left out.
inline constexpr int kSeenAcross = 32, kSeenDown = 18;
std::vector<VisiblePoint> visiblePoints(const KdTree& tree, const Mesh& mesh, const Camera& camera);

/// Whether the camera shows some of what is in the box: at least a hundredth of its image. One that an
/// exporter left somewhere does not.
bool showsModel(std::span<const VisiblePoint> points, const Box3& box);

/// How much of them is in the camera's image, whatever is before it: 0 to 1. Of cameras that are neither
/// perspective nor orthographic 1.
float partInImage(std::span<const VisiblePoint> points, const Camera& camera);

/// Irradiance of the lights that are on at each of the points; W/m^2 of the brightest channel.
std::vector<float> irradianceAt(const KdTree& tree, const Mesh& mesh, std::span<const Light> lights,
                                std::span<const VisiblePoint> points);

/// Whether one of the lights that are on can be noticed beside `ambient` at some of the places.
bool lightReaches(const KdTree& tree, const Mesh& mesh, std::span<const Light> lights,
                  std::span<const VisiblePoint> points, Colour ambient);

/// Whether the model is open to what surrounds it at some of the places.
bool isOpen(const KdTree& tree, const Mesh& mesh, std::span<const VisiblePoint> points);

} // namespace rtcore

/// One ray at a time. Watertight: a ray that starts inside a closed mesh never leaves it without a hit,
/// whatever its direction (Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection", on a tree
/// whose clipping and intervals are widened by a few units in the last place; accel/README.md).
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/kernels/kernel_scene.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <optional>

namespace rtcore {

/// Closest hit in [ray.tMin, ray.tMax]; of several on one surface (one_surface.h) the triangle with the
/// lowest index, with its own distance. Does not allocate. Safe from many threads. Miss: returns false and
/// leaves `hit` untouched.
bool intersect(const KdTree& tree, const Mesh& mesh, const Ray& ray, Hit& hit);

/// Whether anything is hit in [ray.tMin, ray.tMax]. Agrees with intersect().
bool occluded(const KdTree& tree, const Mesh& mesh, const Ray& ray);

/// As intersect(), but the distance is the leaf test's own, before refineDistance() (hit_distance.h). Hits
/// only what the scene's filter keeps.
bool findClosest(const KernelScene& scene, const Ray& ray, Hit& hit);
/// As occluded(), with the same exception, and those of `clear`.
bool findAny(const KernelScene& scene, const Ray& ray);

/// The first half of findClosest(): whatever is nearest. Where the number of the triangle has kTiedHit others
/// may be as near; then `hit.t` alone is known, or the ray hits nothing at all.
bool findNearest(const KernelScene& scene, const Ray& ray, Hit& hit);
/// The second half, for such hits: chooses among those on one surface with the nearest, at `hit.t`. Returns
/// HitWave::clearance; nothing where the ray hits nothing. `narrow`: the scene's; null: to be found out.
std::optional<float> settleTie(const KernelScene& scene, const NarrowTriangles* narrow, const Ray& ray,
                               Hit& hit);

} // namespace rtcore

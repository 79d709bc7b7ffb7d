/// The renderer's tree, lights, camera and normals drawn as a model that other programs open. It has the
/// coordinates of the scene's model, so that it can be laid over it.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/scene.h"

#include <filesystem>
#include <string>

namespace rtcore {

/// Objects of the drawing, each in a colour of its own: `tree_depth_00` and so on, the cells of the kd-tree
/// down to the depth at which there are a thousand; `tree_heaviest_leaves`, those with the most triangles;
/// `lights_on` and `lights_off`, octahedra, with a bar where they shine to and the sides of rectangles;
/// `camera`, the edges of what it sees and a bar for its upper side; `normals_shading` and
/// `normals_geometric`, pins on what rays through a grid of the image hit.
struct DebugScene {
    std::string obj, mtl;
};
/// `materials`: how the file of `mtl` will be named. The image is `width` x `height` pixels.
DebugScene sketchScene(const Scene& scene, const KdTree& tree, const RayTracer& tracer, const Camera& camera,
                       int width, int height, std::string_view materials);

/// The file of materials that writeDebugScene() writes beside `path`.
std::filesystem::path debugMaterials(std::filesystem::path path);

/// Writes the drawing to `path` and its materials beside it, with the ending .mtl; both complete or not at
/// all. Throws FileError CannotWrite.
void writeDebugScene(const std::filesystem::path& path, const Scene& scene, const KdTree& tree,
                     const RayTracer& tracer, const Camera& camera, int width, int height);

} // namespace rtcore

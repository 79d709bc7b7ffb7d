/// The scene without its hidden parts.
#pragma once

#include "rtcore/accel/visible_tree.h"
#include "rtcore/scene/scene.h"

namespace rtcore {

/// `tree` of the scene's whole mesh without its hidden parts, at once; the same one where none is hidden.
inline KdTree visibleTree(const KdTree& tree, const Scene& scene) {
    if (scene.hiddenParts == nullptr) return tree;
    return visibleTree(tree, partTriangles(scene.model, scene.hiddenParts));
}

/// The same, built anew, which many rays are worth.
inline KdTree buildVisibleTree(const KdTree& tree, const Scene& scene, const BuildOptions& options) {
    if (scene.hiddenParts == nullptr) return tree;
    return buildVisibleTree(scene.model.mesh, partTriangles(scene.model, scene.hiddenParts), tree.bounds,
                            options);
}

} // namespace rtcore

/// Meshes of Assimp's in the pose of their joints and morph targets.
#pragma once

#include "rtcore/io/import/assimp/assimp_parts.h"
#include "rtcore/io/import/assimp/scene_pose.h"
#include "rtcore/io/import/mesh/affine.h"
#include "rtcore/math/vec.h"

#include <cstdint>
#include <vector>

struct aiBone;
struct aiMesh;
struct aiNode;

namespace rtcore {

/// A mesh's lists, in the world.
struct PosedMesh {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals; ///< as many, or none where the mesh has none
    bool mirrored = false;     ///< turned inside out
};

class MeshPoser {
  public:
    /// `transforms`: of all nodes. All must outlive the object.
    MeshPoser(const NodeTransforms& transforms, const FormatQuirks& quirks, const ScenePose& pose,
              const MorphWeights& weights)
        : transforms_(transforms), quirks_(quirks), pose_(pose), weights_(weights) {}

    /// Null for a mesh that stands as its node does. Joints take the place of `toWorld`, the node's, where a
    /// vertex has any. Valid until the next call.
    const PosedMesh* pose(const aiMesh& mesh, const aiNode& node, const Affine& toWorld);
    void warn(ImportReport& report) const;

  private:
    struct Skin;
    bool morph(const aiMesh& mesh, const aiNode& node);
    Skin skinOf(const aiMesh& mesh, const aiNode& node);
    Affine geometricOf(const aiNode& node) const;

    const NodeTransforms& transforms_;
    const FormatQuirks& quirks_;
    const ScenePose& pose_;
    const MorphWeights& weights_;
    PosedMesh posed_;
    std::uint64_t lostJoints_ = 0, brokenTargets_ = 0;
};

} // namespace rtcore

/// The pose of a scene of Assimp's: where its nodes stand, and how far morph targets are moved.
#pragma once

#include "rtcore/io/import/assimp/fbx_notes.h"
#include "rtcore/io/import/assimp/format_quirks.h"
#include "rtcore/io/import/import_report.h"
#include "rtcore/io/import/mesh/affine.h"
#include "rtcore/scene/pose_choice.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

struct aiAnimation;
struct aiMesh;
struct aiNode;
struct aiScene;

namespace rtcore {

class ScenePose {
  public:
    /// The pose that the nodes have in the file. All must outlive the object.
    ScenePose(const aiScene& scene, const FormatQuirks& quirks);

    /// Moves nodes and targets as an animation says. Throws as animationOf() does.
    void choose(const PoseChoice& choice, ImportReport& report);

    /// From a node's coordinates to its parent's.
    Affine localOf(const aiNode& node) const;
    /// Of a morph target, in place of what the file says; nothing where no animation moves it. FBX counts
    /// channels in place of targets.
    std::optional<double> animatedWeight(const aiNode& node, unsigned target) const;

  private:
    void move(const aiAnimation& animation, double ticks);
    void moveNodes(const aiAnimation& animation, double ticks);
    void moveTargets(const aiAnimation& animation, double ticks);

    const aiScene& scene_;
    const FormatQuirks& quirks_;
    std::map<const aiNode*, Affine> moved_;
    std::map<std::string, std::map<unsigned, double>> weights_; ///< by node
    std::size_t damagedChannels_ = 0;
};

/// Weights of morph targets as they stand in the file, which Assimp does not always hand over.
class MorphWeights {
  public:
    /// All must outlive the object.
    MorphWeights(const ScenePose& pose, const FbxNotes& fbx) : pose_(pose), fbx_(fbx) {}
    /// For each target of the mesh.
    std::vector<double> of(const aiMesh& mesh, const aiNode& node) const;

  private:
    const FbxMorphs* fbxMorphsOf(const aiMesh& mesh, const aiNode& node) const;

    const ScenePose& pose_;
    const FbxNotes& fbx_;
};

} // namespace rtcore

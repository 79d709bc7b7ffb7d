/// The nodes of a scene of Assimp's that the file hides.
#pragma once

#include "rtcore/io/import/assimp/fbx_notes.h"

#include <cstddef>
#include <map>
#include <string>

struct aiNode;
struct aiScene;

namespace rtcore {

/// Asked for all nodes, depth first, since several may have one name.
class HiddenNodes {
  public:
    /// Both must outlive the object.
    HiddenNodes(const aiScene& scene, const FbxNotes& notes) : scene_(scene), notes_(notes) {}

    bool any() const { return notes_.hidesSome; }
    /// Whether the next node of its name, which is `node`, is hidden.
    bool takeNext(const aiNode& node);

  private:
    std::string pathOf(const aiNode& node) const;

    const aiScene& scene_;
    const FbxNotes& notes_;
    std::map<std::string, std::size_t> taken_; ///< by the names from the root on
};

} // namespace rtcore

/// Facts of FBX files that Assimp does not hand over: which parts are hidden, and how far morph targets are
/// moved.
#pragma once

#include "rtcore/io/import/assimp/fbx_elements.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace rtcore {

/// A slider of shapes: one, or several between which it passes.
struct FbxMorphChannel {
    double position = 0;              ///< 0 to 1 as a rule
    std::vector<double> full;         ///< the positions at which each of its shapes stands alone
    std::vector<std::string> targets; ///< the names that Assimp may give them

    /// The weights of its shapes with the slider at `at`: linear between neighbours, and beyond the ends.
    std::vector<double> weightsAt(double at) const;
};

struct FbxMorphs {
    std::string mesh;               ///< its own name, may be ""
    std::vector<std::string> nodes; ///< that show it
    std::vector<FbxMorphChannel> channels;
    std::size_t targetCount() const;
};

struct FbxNotes {
    std::vector<FbxMorphs> morphs;
    /// By the name of a node that no other has: those of its materials, in the order of the numbers that its
    /// geometry names them by.
    std::map<std::string, std::vector<std::string>> materials;
    bool hidesSome = false;
    /// By the names of the nodes from the root on, each with a slash before it: of the nodes of these names,
    /// depth first, whether they are hidden. By Visibility or Show, or as the second or a further level of
    /// detail.
    std::map<std::string, std::vector<std::uint8_t>> hidden;
};

/// The program from which the scene comes, which need not be the library that wrote the file; "" where none
/// is named.
std::string fbxApplication(const std::vector<FbxElement>& elements);

FbxNotes fbxNotesOf(const std::vector<FbxElement>& elements);

} // namespace rtcore

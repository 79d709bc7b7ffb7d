#include "rtcore/io/import/assimp/hidden_nodes.h"

#include <assimp/scene.h>

#include <string_view>

namespace rtcore {

namespace {

/// One of those that Assimp makes of a node's pivots, in front of the node itself.
bool isPivot(const aiNode& node) {
    return std::string_view(node.mName.C_Str()).find("_$AssimpFbx$_") != std::string_view::npos;
}

} // namespace

std::string HiddenNodes::pathOf(const aiNode& node) const {
    constexpr int kDeepest = 1024; // pivots count
    std::string path;
    const aiNode* at = &node;
    for (int depth = 0; at != nullptr && at != scene_.mRootNode && depth < kDeepest; ++depth) {
        if (!isPivot(*at)) path = "/" + std::string(at->mName.C_Str()) + path;
        at = at->mParent;
    }
    return path;
}

bool HiddenNodes::takeNext(const aiNode& node) {
    if (!any() || &node == scene_.mRootNode || isPivot(node)) return false;
    const std::string path = pathOf(node);
    const auto facts = notes_.hidden.find(path);
    const std::size_t number = taken_[path]++;
    return facts != notes_.hidden.end() && number < facts->second.size() && facts->second[number] != 0;
}

} // namespace rtcore

#include "rtcore/io/import/assimp/expanded_nodes.h"

#include "rtcore/io/import/assimp/xml_text.h"
#include "rtcore/io/import/assimp/xml_tree.h"
#include "rtcore/io/import/gltf/json_members.h"
#include "rtcore/io/import/mesh/geometry_finish.h"
#include "rtcore/io/import/mesh/instance_graph.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

using NodeText = std::string_view;

/// Nodes by their names, known or not yet.
template <typename Name>
class NamedNodes {
  public:
    std::size_t of(const Name& name) {
        const auto [entry, isNew] = numbers_.try_emplace(name, 0);
        if (isNew) entry->second = graph.addNode({1, 0, 0});
        return entry->second;
    }
    InstanceGraph graph;

  private:
    std::map<Name, std::size_t> numbers_;
};

std::optional<ExpandedCount> fbxNodes(const std::vector<FbxElement>& elements) {
    NamedNodes<std::int64_t> nodes;
    std::map<std::int64_t, bool> isModel;
    std::vector<std::pair<std::int64_t, std::int64_t>> links; // child, parent
    for (const FbxElement& part : elements) {
        for (const FbxElement& each : part.children) {
            if (part.name == "Objects" && each.name == "Model") isModel[each.id(0)] = true;
            if (part.name == "Connections" && each.text(0) == "OO")
                links.emplace_back(each.id(1), each.id(2));
        }
    }
    constexpr std::int64_t kRoot = 0;
    for (const auto& [child, parent] : links)
        if (isModel.contains(child) && (parent == kRoot || isModel.contains(parent)))
            nodes.graph.addChild(nodes.of(parent), nodes.of(child));
    const std::size_t root = nodes.of(kRoot);
    return nodes.graph.count(std::span(&root, 1));
}

/// Follows the nodes of a Collada file, which hold others and name others.
class ColladaNodes {
  public:
    explicit ColladaNodes(NodeText text) : text_(text) {}

    std::optional<ExpandedCount> count() {
        for (std::size_t at = text_.find('<'); at != NodeText::npos; at = text_.find('<', at + 1)) {
            if (!isRead(text_.substr(at, kLongestName))) continue;
            const std::size_t end = xml::endOfHead(text_, at);
            read(text_.substr(at, std::min(end, text_.size()) - at));
            if (end == NodeText::npos) break; // of all that would begin behind it, too
        }
        return nodes_.graph.count(roots_);
    }

  private:
    static bool begins(NodeText head, NodeText name) {
        return head.starts_with(name) &&
               (head.size() == name.size() || NodeText(" \t\r\n/").find(head[name.size()]) != NodeText::npos);
    }

    static constexpr std::size_t kLongestName = 16; ///< "</visual_scene>"
    static bool isRead(NodeText text) {
        const NodeText name = text.substr(std::min<std::size_t>(text.starts_with("</") ? 2 : 1, text.size()));
        return name.starts_with("node") || name.starts_with("instance_node") ||
               name.starts_with("visual_scene");
    }

    void read(NodeText head) {
        if (begins(head, "<node")) {
            const std::string id = xml::attributeOf(head, "id");
            const std::size_t node = id.empty() ? nodes_.graph.addNode({1, 0, 0}) : nodes_.of(id);
            if (!open_.empty()) {
                nodes_.graph.addChild(open_.back(), node);
            } else if (inScene_) {
                roots_.push_back(node);
            }
            if (!head.ends_with('/')) open_.push_back(node);
        } else if (begins(head, "</node") && !open_.empty()) {
            open_.pop_back();
        } else if (begins(head, "<instance_node") && !open_.empty()) {
            nodes_.graph.addChild(open_.back(), nodes_.of(xml::idOf(xml::attributeOf(head, "url"))));
        } else if (begins(head, "<visual_scene")) {
            inScene_ = true;
        } else if (begins(head, "</visual_scene")) {
            inScene_ = false;
        }
    }

    NodeText text_;
    NamedNodes<std::string> nodes_;
    std::vector<std::size_t> open_, roots_;
    bool inScene_ = false;
};

std::optional<ExpandedCount> colladaNodes(const std::filesystem::path& path) {
    const FileBytes file = openFileBytes(path);
    const NodeText text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
    if (text.find("<instance_node") == NodeText::npos) return ExpandedCount{};
    return ColladaNodes(xml::textWithoutComments(path)).count();
}

/// Of version 1, in which nodes have names.
std::optional<ExpandedCount> gltfNodes(const std::filesystem::path& path) {
    const FileBytes file = openFileBytes(path);
    const NodeText text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
    const gltf::Json root = gltf::Json::parse(text, nullptr, false);
    const gltf::Json& stated = gltf::member(root, "nodes");
    NamedNodes<std::string> nodes;
    if (!stated.is_object()) return ExpandedCount{};
    for (const auto& [name, node] : stated.items())
        for (const gltf::Json& child : gltf::member(node, "children"))
            if (child.is_string()) nodes.graph.addChild(nodes.of(name), nodes.of(child.get<std::string>()));
    std::vector<std::size_t> roots;
    const gltf::Json& scenes = gltf::member(root, "scenes");
    const gltf::Json& shown = gltf::member(scenes, gltf::text(root, "scene").c_str());
    for (const gltf::Json& node : gltf::member(shown, "nodes"))
        if (node.is_string()) roots.push_back(nodes.of(node.get<std::string>()));
    return nodes.graph.count(roots);
}

std::optional<ExpandedCount> nodesOf(const std::filesystem::path& path, const std::vector<FbxElement>& fbx) {
    if (!fbx.empty()) return fbxNodes(fbx);
    if (xml::isCollada(path)) return colladaNodes(path);
    const std::string ending = path.extension().string();
    if (ending == ".gltf" || ending == ".GLTF") return gltfNodes(path);
    return ExpandedCount{};
}

} // namespace

void refuseManyNodes(const std::filesystem::path& path, const std::vector<FbxElement>& fbx,
                     std::uint64_t memoryLimit) {
    constexpr std::uint64_t kBytesOfNode = 1600; // of Assimp's, with a name of 1 KB
    const auto count = nodesOf(path, fbx);
    if (!count) throw FileError(FailureKind::BadData, "", "its node graph has no end; repair the file");
    refuseTooMuch(*count, memoryLimit, kBytesOfNode);
}

} // namespace rtcore

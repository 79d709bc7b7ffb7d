#include "rtcore/io/import/gltf/scene_meshes.h"

#include "rtcore/io/import/gltf/instances.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <utility>

namespace rtcore::gltf {

namespace {

ExpandedCount sizeOfMesh(const Json& mesh, PrimitiveReader& primitives) {
    ExpandedCount size;
    for (const Json& primitive : member(mesh, "primitives")) {
        const auto [vertices, faces] = primitives.sizeOf(primitive);
        size.add({1, vertices, faces});
    }
    return size;
}

std::string meshName(const Json& mesh, std::size_t number, std::size_t primitive) {
    std::string name = text(mesh, "name");
    if (name.empty()) name = "meshes[" + std::to_string(number) + "]";
    return sizeOf(member(mesh, "primitives")) > 1 ? name + "-" + std::to_string(primitive) : name;
}

} // namespace

ExpandedCount shownOf(const Json& root, PrimitiveReader& primitives, Accessors& accessors) {
    const Json &nodes = member(root, "nodes"), &meshes = member(root, "meshes");
    std::vector<ExpandedCount> sizes;
    for (const Json& mesh : meshes) sizes.push_back(sizeOfMesh(mesh, primitives));
    ExpandedCount all;
    if (sizeOf(nodes) == 0) { // a file of meshes alone
        for (const ExpandedCount& size : sizes) all.add(size);
        return all;
    }
    InstanceGraph graph;
    for (const Json& node : nodes) {
        const bool hidden = isHidden(node);
        const auto mesh = hidden ? std::nullopt : index(node, "mesh");
        ExpandedCount own;
        if (mesh && *mesh < sizes.size()) own = sizes[*mesh].times(instanceCount(node, accessors));
        own.parts = std::max<std::uint64_t>(own.parts, 1);
        const std::size_t number = graph.addNode(own);
        if (hidden) continue;
        for (const Json& child : member(node, "children"))
            if (const auto below = wholeNumber(child)) graph.addChild(number, *below);
    }
    const auto count = graph.count(rootsOf(root));
    if (!count) throw FileError(FailureKind::BadData, "", "its node graph has no end; repair the file");
    return *count;
}

std::vector<Placement> placementsOf(const Json& root, const World& world, const NodeWalk& walk,
                                    Accessors& accessors) {
    const Json &nodes = member(root, "nodes"), &meshes = member(root, "meshes");
    std::vector<Placement> placements;
    for (std::size_t i = 0; i < walk.nodes.size(); ++i) {
        const Json& node = nodes[walk.nodes[i].node];
        const auto mesh = index(node, "mesh");
        if (!mesh || *mesh >= sizeOf(meshes)) continue;
        Placement placement{*mesh, i, walk.nodes[i].toWorld, index(node, "skin"), std::nullopt};
        const auto instances = instancesOf(node, accessors);
        if (!instances) {
            placements.push_back(std::move(placement));
            continue;
        }
        for (std::size_t k = 0; k < instances->size(); ++k) {
            placement.toWorld = walk.nodes[i].toWorld * (*instances)[k];
            placement.instance = k;
            placements.push_back(placement);
        }
    }
    if (walk.nodes.empty() && sizeOf(nodes) == 0) // a file of meshes alone
        for (std::size_t m = 0; m < sizeOf(meshes); ++m)
            placements.push_back({m, PlacedNode::kNoParent, world.ofFile(), std::nullopt, std::nullopt});
    return placements;
}

std::string nameOf(const Json& root, const NodeWalk& walk, const Placement& at, std::size_t primitive) {
    const Json& mesh = member(root, "meshes")[at.mesh];
    const Json& primitives = member(mesh, "primitives");
    std::string path = pathOf(root, walk, at.placed);
    std::string name = path.empty() ? meshName(mesh, at.mesh, primitive) : "";
    if (sizeOf(primitives) > 1) {
        const auto material = index(primitives[primitive], "material");
        const std::string own = text(element(member(root, "materials"), material), "name");
        if (!own.empty()) name = own;
    }
    if (at.instance) {
        const std::string number = std::to_string(*at.instance + 1);
        path = path.empty() ? number : path + "/" + number;
    }
    return path.empty() || name.empty() ? path + name : path + "/" + name;
}

} // namespace rtcore::gltf

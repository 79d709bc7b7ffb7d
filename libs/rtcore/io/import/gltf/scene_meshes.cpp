#include "rtcore/io/import/gltf/scene_meshes.h"

#include "rtcore/io/import/gltf/instances.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <utility>

namespace rtcore::gltf {

namespace {

/// Each has at least a triangle and a name beside its place.
void refuseMany(std::uint64_t count, std::uint64_t memoryLimit) {
    constexpr std::uint64_t kMax = 50'000'000, kBytesOfOne = 400;
    if (count <= (memoryLimit > 0 ? std::min(memoryLimit / kBytesOfOne, kMax) : kMax)) return;
    throw FileError(FailureKind::BadData, "",
                    say("it shows its meshes {0} times, more than fit into the memory that it may use; raise "
                        "the limit or export fewer instances",
                        count));
}

std::string meshName(const Json& mesh, std::size_t number, std::size_t primitive) {
    std::string name = text(mesh, "name");
    if (name.empty()) name = "meshes[" + std::to_string(number) + "]";
    return sizeOf(member(mesh, "primitives")) > 1 ? name + "-" + std::to_string(primitive) : name;
}

} // namespace

std::vector<Placement> placementsOf(const Json& root, const World& world, const NodeWalk& walk,
                                    Accessors& accessors, std::uint64_t memoryLimit) {
    const Json &nodes = member(root, "nodes"), &meshes = member(root, "meshes");
    std::vector<Placement> placements;
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < walk.nodes.size(); ++i) {
        const Json& node = nodes[walk.nodes[i].node];
        const auto mesh = index(node, "mesh");
        if (!mesh || *mesh >= sizeOf(meshes)) continue;
        count += instanceCount(node, accessors);
        refuseMany(count, memoryLimit);
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

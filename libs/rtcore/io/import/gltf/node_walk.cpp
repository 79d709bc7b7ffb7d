#include "rtcore/io/import/gltf/node_walk.h"

#include "rtcore/platform/error.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace rtcore::gltf {

namespace {

struct OpenNode {
    std::size_t node, parent, depth;
};

std::vector<std::size_t> rootsOf(const Json& root) {
    const Json &scenes = member(root, "scenes"), &nodes = member(root, "nodes");
    const auto shown = index(root, "scene").value_or(0);
    std::vector<std::size_t> roots;
    const Json& scene = element(scenes, shown < sizeOf(scenes) ? shown : 0);
    if (!scene.is_null()) {
        for (const Json& number : member(scene, "nodes"))
            if (const auto node = wholeNumber(number)) roots.push_back(*node);
        return roots;
    }
    std::vector<char> isChild(sizeOf(nodes), 0);
    for (const Json& node : nodes) {
        for (const Json& number : member(node, "children")) {
            const auto child = wholeNumber(number);
            if (child && *child < isChild.size()) isChild[*child] = 1;
        }
    }
    for (std::size_t i = 0; i < isChild.size(); ++i)
        if (isChild[i] == 0) roots.push_back(i);
    return roots;
}

bool isHidden(const Json& node) { return !flag(extension(node, "KHR_node_visibility"), "visible", true); }

std::array<float, 4> unitRotation(std::array<float, 4> q) {
    constexpr float kRounded = 1e-4F; // of what is of unit length but for its digits
    const float square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (std::fabs(square - 1) < kRounded) return q;
    if (!(square > 0) || !std::isfinite(square)) return {0, 0, 0, 1};
    const float length = std::sqrt(square);
    for (float& v : q) v /= length;
    return q;
}

} // namespace

// In floats, rounded as Assimp's matrices were, so that models keep their bits.
Affine affineOf(Vec3 translation, const std::array<float, 4>& rotation, Vec3 scale) {
    const auto [x, y, z, w] = unitRotation(rotation);
    const float r[3][3] = {{1.0F - 2.0F * (y * y + z * z), 2.0F * (x * y - z * w), 2.0F * (x * z + y * w)},
                           {2.0F * (x * y + z * w), 1.0F - 2.0F * (x * x + z * z), 2.0F * (y * z - x * w)},
                           {2.0F * (x * z - y * w), 2.0F * (y * z + x * w), 1.0F - 2.0F * (x * x + y * y)}};
    Affine a;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            a.m[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
                double{r[row][column] * scale[column]};
        a.m[static_cast<std::size_t>(row)][3] = double{translation[row]};
    }
    return a;
}

Affine localOf(const Json& node) {
    if (const auto matrix = numbers<16>(node, "matrix")) {
        Affine a;
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                a.m[row][column] = double{(*matrix)[4 * column + row]};
        return a;
    }
    const auto t = numbers<3>(node, "translation").value_or(std::array<float, 3>{0, 0, 0});
    const auto r = numbers<4>(node, "rotation").value_or(std::array<float, 4>{0, 0, 0, 1});
    const auto s = numbers<3>(node, "scale").value_or(std::array<float, 3>{1, 1, 1});
    return affineOf({t[0], t[1], t[2]}, r, {s[0], s[1], s[2]});
}

NodeWalk walkNodes(const Json& root) {
    constexpr std::size_t kMaxNodes = 4'000'000; // more has only a graph with cycles
    const Json& nodes = member(root, "nodes");
    const std::vector<std::size_t> roots = rootsOf(root);
    NodeWalk walk;
    walk.oneRoot = roots.size() == 1;
    std::vector<OpenNode> open;
    for (std::size_t i = roots.size(); i-- > 0;) open.push_back({roots[i], PlacedNode::kNoParent, 0});
    while (!open.empty()) {
        const OpenNode at = open.back();
        open.pop_back();
        if (at.depth > sizeOf(nodes) || walk.nodes.size() > kMaxNodes)
            throw FileError(FailureKind::BadData, "", "its node graph has no end; repair the file");
        const Json& node = element(nodes, at.node);
        if (!node.is_object() || isHidden(node)) continue;
        const Affine local = localOf(node);
        const std::size_t placed = walk.nodes.size();
        walk.nodes.push_back(
            {at.node, at.parent == PlacedNode::kNoParent ? local : walk.nodes[at.parent].toWorld * local,
             at.parent});
        const Json& children = member(node, "children");
        for (std::size_t i = sizeOf(children); i-- > 0;)
            if (const auto child = wholeNumber(children[i])) open.push_back({*child, placed, at.depth + 1});
    }
    return walk;
}

std::vector<std::size_t> leavesFirst(const NodeWalk& walk) {
    std::vector<std::size_t> order, open; // `open`: the way to the last node
    order.reserve(walk.nodes.size());
    const auto closeUpTo = [&](std::size_t parent) {
        while (!open.empty() && open.back() != parent) {
            order.push_back(open.back());
            open.pop_back();
        }
    };
    for (std::size_t i = 0; i < walk.nodes.size(); ++i) {
        closeUpTo(walk.nodes[i].parent);
        open.push_back(i);
    }
    closeUpTo(PlacedNode::kNoParent);
    return order;
}

std::string nodeName(const Json& root, std::size_t node) {
    const std::string name = text(element(member(root, "nodes"), node), "name");
    return name.empty() ? "nodes[" + std::to_string(node) + "]" : name;
}

std::string pathOf(const Json& root, const NodeWalk& walk, std::size_t placed) {
    constexpr int kDeepest = 256; // deeper ones are told by their ends
    std::string path;
    for (int depth = 0; placed != PlacedNode::kNoParent && depth < kDeepest; ++depth) {
        const PlacedNode& at = walk.nodes[placed];
        if (at.parent == PlacedNode::kNoParent && walk.oneRoot) break;
        const std::string name = nodeName(root, at.node);
        path = path.empty() ? name : name + "/" + path;
        placed = at.parent;
    }
    return path;
}

} // namespace rtcore::gltf

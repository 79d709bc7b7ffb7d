#include "rtcore/io/import/gltf/node_walk.h"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

namespace rtcore::gltf {

namespace {

struct OpenNode {
    std::size_t node, parent;
};

template <typename Number>
std::array<Number, 4> unitRotation(std::array<Number, 4> q) {
    // Of what is of unit length but for its digits.
    constexpr auto kRounded = std::is_same_v<Number, float> ? Number(1e-4) : Number(0);
    const Number square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (std::fabs(square - 1) < kRounded) return q;
    if (!(square > 0) || !std::isfinite(square)) return {0, 0, 0, 1};
    const Number length = std::sqrt(square);
    for (Number& v : q) v /= length;
    return q;
}

template <typename Number>
Affine statedTransform(const Json& node) {
    if (const auto matrix = numbers<16, Number>(node, "matrix")) {
        Affine a;
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                a.m[row][column] = double{(*matrix)[4 * column + row]};
        return a;
    }
    return affineOf<Number>(numbers<3, Number>(node, "translation").value_or(std::array<Number, 3>{0, 0, 0}),
                            numbers<4, Number>(node, "rotation").value_or(std::array<Number, 4>{0, 0, 0, 1}),
                            numbers<3, Number>(node, "scale").value_or(std::array<Number, 3>{1, 1, 1}));
}

} // namespace

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

// In floats, rounded as Assimp's matrices were, so that models keep their bits.
template <typename Number>
Affine affineOf(const std::array<Number, 3>& translation, const std::array<Number, 4>& rotation,
                const std::array<Number, 3>& scale) {
    const auto [x, y, z, w] = unitRotation(rotation);
    const Number one = 1, two = 2;
    const Number r[3][3] = {{one - two * (y * y + z * z), two * (x * y - z * w), two * (x * z + y * w)},
                            {two * (x * y + z * w), one - two * (x * x + z * z), two * (y * z - x * w)},
                            {two * (x * z - y * w), two * (y * z + x * w), one - two * (x * x + y * y)}};
    Affine a;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column)
            a.m[row][column] = double{r[row][column] * scale[column]};
        a.m[row][3] = double{translation[row]};
    }
    return a;
}

template Affine affineOf(const std::array<float, 3>&, const std::array<float, 4>&,
                         const std::array<float, 3>&);

World::World(const LocalOrigin& origin) : precise_(!origin.isZero()), ofFile_(lessOrigin(origin)) {}

Affine World::localOf(const Json& node, bool isRoot) const {
    if (!precise_) return statedTransform<float>(node);
    const Affine local = statedTransform<double>(node);
    return isRoot ? ofFile_ * local : local;
}

NodeWalk walkNodes(const Json& root, const World& world) {
    const Json& nodes = member(root, "nodes");
    const std::vector<std::size_t> roots = rootsOf(root);
    NodeWalk walk;
    walk.oneRoot = roots.size() == 1;
    std::vector<OpenNode> open;
    for (std::size_t i = roots.size(); i-- > 0;) open.push_back({roots[i], PlacedNode::kNoParent});
    while (!open.empty()) {
        const OpenNode at = open.back();
        open.pop_back();
        const Json& node = element(nodes, at.node);
        if (!node.is_object() || isHidden(node)) continue;
        const bool isRoot = at.parent == PlacedNode::kNoParent;
        const Affine local = world.localOf(node, isRoot);
        const std::size_t placed = walk.nodes.size();
        walk.nodes.push_back({at.node, isRoot ? local : walk.nodes[at.parent].toWorld * local, at.parent});
        const Json& children = member(node, "children");
        for (std::size_t i = sizeOf(children); i-- > 0;)
            if (const auto child = wholeNumber(children[i])) open.push_back({*child, placed});
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

#include "rtcore/io/import/gltf/skin.h"

#include <numeric>
#include <optional>

namespace rtcore::gltf {

namespace {

Affine affineOf(std::span<const float> matrix) {
    Affine a;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            a.m[row][column] = double{matrix[4 * column + row]};
    return a;
}

} // namespace

Skins::Skins(const Json& root, const World& world, Accessors& accessors)
    : root_(root), world_(world), accessors_(accessors), parents_(gltf::sizeOf(member(root, "nodes"))),
      worlds_(parents_.size()) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    const Json& nodes = member(root, "nodes");
    for (std::size_t i = 0; i < parents_.size(); ++i) {
        for (const Json& number : member(nodes[i], "children")) {
            const auto child = wholeNumber(number);
            if (child && *child < parents_.size()) parents_[*child] = i;
        }
    }
}

bool Skins::has(std::size_t skin) const { return skin < gltf::sizeOf(member(root_, "skins")); }

/// `node` exists. A chain that runs in a circle begins somewhere.
const Affine& Skins::toWorld(std::size_t node) {
    std::vector<std::size_t> chain;
    for (std::size_t at = node; !worlds_[at]; at = parents_[at]) {
        chain.push_back(at);
        if (parents_[at] == at || chain.size() > parents_.size()) break;
    }
    while (!chain.empty()) {
        const std::size_t at = chain.back(), parent = parents_[at];
        const bool isRoot = parent == at || !worlds_[parent];
        const Affine local = world_.localOf(member(root_, "nodes")[at], isRoot);
        worlds_[at] = isRoot ? local : *worlds_[parent] * local;
        chain.pop_back();
    }
    return *worlds_[node];
}

std::span<const Affine> Skins::joints(std::size_t skin) {
    const auto known = joints_.find(skin);
    if (known != joints_.end()) return known->second;
    const Json& stated = element(member(root_, "skins"), skin);
    const Json& numbers = member(stated, "joints");
    std::vector<Affine>& joints = joints_[skin];
    const auto accessor = accessors_.find(index(stated, "inverseBindMatrices"));
    std::vector<float> bind;
    if (accessor && accessor->count >= gltf::sizeOf(numbers)) {
        bind.resize(accessor->count * 16);
        if (!accessors_.readFloats(*accessor, 16, bind)) bind.clear();
    }
    for (std::size_t i = 0; i < gltf::sizeOf(numbers); ++i) {
        const auto node = wholeNumber(numbers[i]);
        const Affine world = node && *node < worlds_.size() ? toWorld(*node) : world_.ofFile();
        joints.push_back(bind.empty() ? world : world * affineOf(std::span(bind).subspan(16 * i, 16)));
    }
    return joints;
}

Affine skinOf(std::span<const std::vector<Influences>> sets, std::size_t vertex,
              std::span<const Affine> joints) {
    Affine sum;
    sum.m = {};
    double weights = 0;
    std::optional<std::size_t> first;
    for (const std::vector<Influences>& set : sets) {
        for (std::size_t i = 0; i < 4; ++i) {
            const float number = set[vertex].joints[i];
            if (!(number >= 0) || !(number < static_cast<float>(joints.size()))) continue;
            const auto joint = static_cast<std::size_t>(number);
            const double weight = double{set[vertex].weights[i]};
            if (!first) first = joint;
            if (!(weight > 0) || !std::isfinite(weight)) continue;
            sum.add(joints[joint], weight);
            weights += weight;
        }
    }
    if (!(weights > 0)) return first ? joints[*first] : Affine();
    for (auto& row : sum.m)
        for (double& v : row) v /= weights;
    return sum;
}

} // namespace rtcore::gltf

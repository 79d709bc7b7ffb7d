#include "rtcore/io/import/gltf/instances.h"

#include "rtcore/io/import/gltf/node_walk.h"

#include <algorithm>

namespace rtcore::gltf {

namespace {

constexpr const char *kTranslation = "TRANSLATION", *kRotation = "ROTATION", *kScale = "SCALE";

const Json& listsOf(const Json& node) { return member(extension(node, kInstancingExtension), "attributes"); }

/// Empty where there is none of use.
std::vector<float> numbersOf(const Json& lists, const char* name, std::uint32_t components,
                             std::uint64_t count, Accessors& accessors) {
    auto accessor = accessors.find(index(lists, name));
    if (!accessor || accessor->count != count) return {};
    if (components == 4) accessor->elements.normalized = true; // rotations cannot be anything else
    std::vector<float> list(count * components);
    if (!accessors.readFloats(*accessor, components, list)) list.clear();
    return list;
}

std::uint64_t countOf(const Json& lists, Accessors& accessors) {
    std::uint64_t count = 0;
    for (const char* name : {kTranslation, kRotation, kScale})
        if (const auto accessor = accessors.find(index(lists, name)))
            count = std::max(count, accessor->count);
    return count;
}

} // namespace

std::optional<std::vector<Affine>> instancesOf(const Json& node, Accessors& accessors) {
    const Json& lists = listsOf(node);
    if (lists.is_null()) return std::nullopt;
    const std::uint64_t count = countOf(lists, accessors);
    const std::vector<float> t = numbersOf(lists, kTranslation, 3, count, accessors);
    const std::vector<float> r = numbersOf(lists, kRotation, 4, count, accessors);
    const std::vector<float> s = numbersOf(lists, kScale, 3, count, accessors);
    std::vector<Affine> instances;
    instances.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto triple = [&](const std::vector<float>& list, float otherwise) {
            return list.empty() ? std::array{otherwise, otherwise, otherwise}
                                : std::array{list[3 * i], list[3 * i + 1], list[3 * i + 2]};
        };
        const std::array<float, 4> rotation =
            r.empty() ? std::array<float, 4>{0, 0, 0, 1}
                      : std::array<float, 4>{r[4 * i], r[4 * i + 1], r[4 * i + 2], r[4 * i + 3]};
        instances.push_back(affineOf(triple(t, 0), rotation, triple(s, 1)));
    }
    return instances;
}

std::uint64_t instanceCount(const Json& node, Accessors& accessors) {
    const Json& lists = listsOf(node);
    return lists.is_null() ? 1 : countOf(lists, accessors);
}

} // namespace rtcore::gltf

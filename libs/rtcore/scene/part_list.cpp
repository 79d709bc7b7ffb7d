#include "rtcore/scene/part_list.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace rtcore {

bool sameParts(const PartSet& a, const PartSet& b) {
    return a == b || (a != nullptr && b != nullptr && *a == *b);
}

PartSet eitherParts(const PartSet& a, const PartSet& b) {
    if (a == nullptr || b == nullptr) return a == nullptr ? b : a;
    std::vector<std::uint8_t> all = *a;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] |= (*b)[i];
    return std::make_shared<const std::vector<std::uint8_t>>(std::move(all));
}

std::vector<NamedPart> namedParts(const Model& model) {
    std::vector<NamedPart> parts;
    std::unordered_map<std::string_view, std::size_t> known;
    for (std::uint32_t i = 0; i < model.parts.size(); ++i) {
        const std::string_view name = model.name(model.parts[i].nameOffset);
        const auto [entry, isNew] = known.try_emplace(name, parts.size());
        if (isNew) parts.push_back({name, {}, 0});
        NamedPart& part = parts[entry->second];
        part.pieces.push_back(i);
        part.triangles += model.parts[i].triangleCount;
    }
    return parts;
}

bool isIn(const NamedPart& part, const PartSet& set) {
    return set != nullptr && std::all_of(part.pieces.begin(), part.pieces.end(),
                                         [&](std::uint32_t piece) { return (*set)[piece] != 0; });
}

PartSet withParts(const Model& model, std::span<const NamedPart> parts, std::span<const std::uint8_t> chosen,
                  bool in, const PartSet& set) {
    std::vector<std::uint8_t> all = set != nullptr ? *set : std::vector<std::uint8_t>(model.parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (chosen[i] == 0) continue;
        for (const std::uint32_t piece : parts[i].pieces) all[piece] = in ? 1 : 0;
    }
    const bool any = std::find(all.begin(), all.end(), 1) != all.end();
    return any ? std::make_shared<const std::vector<std::uint8_t>>(std::move(all)) : nullptr;
}

PartSet allButParts(const Model& model, std::span<const NamedPart> parts,
                    std::span<const std::uint8_t> chosen) {
    const std::vector<std::uint8_t> every(parts.size(), 1);
    return withParts(model, parts, chosen, false, withParts(model, parts, every, true, nullptr));
}

std::vector<std::uint8_t> partTriangles(const Model& model, const PartSet& set) {
    std::vector<std::uint8_t> triangles(model.mesh.triangles.size());
    if (set == nullptr) return triangles;
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        if ((*set)[i] == 0) continue;
        const ModelPart& part = model.parts[i];
        std::fill_n(triangles.begin() + part.firstTriangle, part.triangleCount, std::uint8_t{1});
    }
    return triangles;
}

} // namespace rtcore

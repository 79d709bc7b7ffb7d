#include "rtcore/scene/part_list.h"

#include <algorithm>
#include <unordered_map>

namespace rtcore {

bool sameHidden(const HiddenParts& a, const HiddenParts& b) {
    return a == b || (a != nullptr && b != nullptr && *a == *b);
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

bool isHidden(const NamedPart& part, const HiddenParts& hidden) {
    return hidden != nullptr && std::all_of(part.pieces.begin(), part.pieces.end(),
                                            [&](std::uint32_t piece) { return (*hidden)[piece] != 0; });
}

HiddenParts withParts(const Model& model, std::span<const NamedPart> parts,
                      std::span<const std::uint8_t> chosen, bool hide, const HiddenParts& hidden) {
    std::vector<std::uint8_t> all =
        hidden != nullptr ? *hidden : std::vector<std::uint8_t>(model.parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (chosen[i] == 0) continue;
        for (const std::uint32_t piece : parts[i].pieces) all[piece] = hide ? 1 : 0;
    }
    const bool any = std::find(all.begin(), all.end(), 1) != all.end();
    return any ? std::make_shared<const std::vector<std::uint8_t>>(std::move(all)) : nullptr;
}

HiddenParts onlyParts(const Model& model, std::span<const NamedPart> parts,
                      std::span<const std::uint8_t> chosen) {
    const std::vector<std::uint8_t> every(parts.size(), 1);
    return withParts(model, parts, chosen, false, withParts(model, parts, every, true, nullptr));
}

std::vector<std::uint8_t> hiddenTriangles(const Model& model, const HiddenParts& hidden) {
    std::vector<std::uint8_t> triangles(model.mesh.triangles.size());
    if (hidden == nullptr) return triangles;
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        if ((*hidden)[i] == 0) continue;
        const ModelPart& part = model.parts[i];
        std::fill_n(triangles.begin() + part.firstTriangle, part.triangleCount, std::uint8_t{1});
    }
    return triangles;
}

} // namespace rtcore

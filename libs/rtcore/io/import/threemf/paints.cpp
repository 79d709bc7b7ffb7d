#include "rtcore/io/import/threemf/paints.h"

#include <algorithm>

namespace rtcore::threemf {

namespace {

std::optional<Paint> compositeAt(const PartContent& part, const PropertyGroup& group, std::uint32_t entry) {
    const PropertyGroup* const of = groupAt(part, group.source);
    const std::size_t columns = group.columns.size(), first = entry * columns;
    if (of == nullptr || of->kind != GroupKind::Materials || first + columns > group.weights.size())
        return std::nullopt;
    Paint sum{{}, 0};
    float weights = 0;
    for (std::size_t i = 0; i < columns; ++i) {
        const float weight = std::clamp(group.weights[first + i], 0.0F, 1.0F);
        if (group.columns[i] >= of->paints.size()) return std::nullopt;
        const Paint& paint = of->paints[group.columns[i]];
        sum.colour += paint.colour * weight;
        sum.alpha += paint.alpha * weight;
        weights += weight;
    }
    if (!(weights > 0)) return std::nullopt;
    return Paint{sum.colour * (1 / weights), sum.alpha / weights};
}

std::optional<Paint> layersAt(const PartContent& part, const PropertyGroup& group, std::uint32_t entry) {
    std::optional<Paint> paint;
    for (std::size_t i = 0; i < group.columns.size(); ++i) {
        const PropertyGroup* const layer = groupAt(part, group.columns[i]);
        if (layer == nullptr || layer->kind == GroupKind::Layers) return std::nullopt;
        if (layer->kind == GroupKind::Texture) continue;
        const auto upper = paintAt(part, group.columns[i], entryOfLayer(group, entry, i));
        if (!upper) return std::nullopt;
        paint = paint ? blended(*paint, *upper, group.multiplies[i] != 0) : *upper;
    }
    return paint;
}

} // namespace

const PropertyGroup* groupAt(const PartContent& part, std::uint32_t number) {
    const auto at = part.groups.find(number);
    return number == kNoNumber || at == part.groups.end() ? nullptr : &at->second;
}

std::optional<Paint> paintAt(const PartContent& part, std::uint32_t group, std::uint32_t entry) {
    const PropertyGroup* const found = groupAt(part, group);
    if (found == nullptr || entry == kNoNumber) return std::nullopt;
    switch (found->kind) {
    case GroupKind::Materials:
    case GroupKind::Colours:
        return entry < found->paints.size() ? std::optional(found->paints[entry]) : std::nullopt;
    case GroupKind::Composites:
        return compositeAt(part, *found, entry);
    case GroupKind::Layers:
        return layersAt(part, *found, entry);
    case GroupKind::Texture:
        break;
    }
    return std::nullopt;
}

Paint blended(Paint lower, Paint upper, bool multiply) {
    if (multiply) return {lower.colour * upper.colour, lower.alpha * upper.alpha};
    const float rest = lower.alpha * (1 - upper.alpha), alpha = upper.alpha + rest;
    if (!(alpha > 0)) return {lower.colour, 0};
    return {(upper.colour * upper.alpha + lower.colour * rest) * (1 / alpha), alpha};
}

std::optional<Vec2> coordinateAt(const PartContent& part, std::uint32_t group, std::uint32_t entry) {
    const PropertyGroup* const found = groupAt(part, group);
    if (found == nullptr || entry >= found->coordinates.size()) return std::nullopt;
    return found->coordinates[entry];
}

std::uint32_t entryOfLayer(const PropertyGroup& layers, std::uint32_t entry, std::size_t column) {
    const std::size_t at = entry * layers.columns.size() + column;
    return entry != kNoNumber && at < layers.rows.size() ? layers.rows[at] : kNoNumber;
}

} // namespace rtcore::threemf

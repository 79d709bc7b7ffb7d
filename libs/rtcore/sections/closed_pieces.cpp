#include "rtcore/sections/closed_pieces.h"

#include "rtcore/scene/closed_surfaces.h"

#include <numeric>

namespace rtcore {

std::vector<PartRange> rangesOf(const Model& model) {
    std::vector<PartRange> ranges;
    std::uint32_t end = 0;
    const auto add = [&](std::uint32_t part, std::uint32_t first, std::uint32_t count) {
        if (count > 0) ranges.push_back({part, first, count});
        end = first + count;
    };
    for (std::uint32_t i = 0; i < model.parts.size(); ++i) {
        const ModelPart& part = model.parts[i];
        add(PartRange::kNoPart, end, part.firstTriangle - end);
        add(i, part.firstTriangle, part.triangleCount);
    }
    add(PartRange::kNoPart, end, static_cast<std::uint32_t>(model.mesh.triangles.size()) - end);
    return ranges;
}

ClosedPieces::ClosedPieces(const Model& model)
    : model_(model), ranges_(rangesOf(model)), closed_(ranges_.size()) {}

const std::vector<std::uint8_t>& ClosedPieces::of(std::size_t range) {
    std::optional<std::vector<std::uint8_t>>& known = closed_[range];
    if (!known) {
        std::vector<std::uint32_t> triangles(ranges_[range].triangleCount);
        std::iota(triangles.begin(), triangles.end(), ranges_[range].firstTriangle);
        known = inClosedPieces(model_.mesh, triangles);
    }
    return *known;
}

} // namespace rtcore

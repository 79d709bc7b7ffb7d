/// The parts of a model as its author named them.
#pragma once

#include "rtcore/scene/model.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace rtcore {

/// One value for each of Model::parts, immutable, shared by all copies of a scene: 1 where no ray hits its
/// triangles. Null where none is hidden.
using HiddenParts = std::shared_ptr<const std::vector<std::uint8_t>>;

bool sameHidden(const HiddenParts& a, const HiddenParts& b);

/// All pieces of one name, which are hidden and shown together.
struct NamedPart {
    std::string_view name;             ///< groups of groups have slashes between them; may be ""
    std::vector<std::uint32_t> pieces; ///< numbers in Model::parts
    std::uint64_t triangles = 0;
};

/// In the order in which their names first appear. The names are the model's, which must outlive them.
std::vector<NamedPart> namedParts(const Model& model);

/// Whether all pieces are hidden.
bool isHidden(const NamedPart& part, const HiddenParts& hidden);
/// `hidden` with these parts hidden or shown. `chosen` has one value for each of `parts`; those of 0 stay.
HiddenParts withParts(const Model& model, std::span<const NamedPart> parts,
                      std::span<const std::uint8_t> chosen, bool hide, const HiddenParts& hidden);
/// The chosen ones shown, all others hidden.
HiddenParts onlyParts(const Model& model, std::span<const NamedPart> parts,
                      std::span<const std::uint8_t> chosen);

/// One value for each triangle: 1 where it is hidden.
std::vector<std::uint8_t> hiddenTriangles(const Model& model, const HiddenParts& hidden);

} // namespace rtcore

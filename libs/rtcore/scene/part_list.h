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

/// One value for each of Model::parts, immutable, shared by all copies of a scene: 1 where it is in the set.
/// Null where none is.
using PartSet = std::shared_ptr<const std::vector<std::uint8_t>>;
/// No ray hits their triangles.
using HiddenParts = PartSet;

bool sameParts(const PartSet& a, const PartSet& b);
/// Those of either.
PartSet eitherParts(const PartSet& a, const PartSet& b);

/// All pieces of one name, which are hidden and shown together.
struct NamedPart {
    std::string_view name;             ///< groups of groups have slashes between them; may be ""
    std::vector<std::uint32_t> pieces; ///< numbers in Model::parts
    std::uint64_t triangles = 0;
};

/// In the order in which their names first appear. The names are the model's, which must outlive them.
std::vector<NamedPart> namedParts(const Model& model);

/// Whether all its pieces are.
bool isIn(const NamedPart& part, const PartSet& set);
/// `set` with these parts, or without them. `chosen` has one value for each of `parts`; those of 0 stay.
PartSet withParts(const Model& model, std::span<const NamedPart> parts, std::span<const std::uint8_t> chosen,
                  bool in, const PartSet& set);
/// All but the chosen ones.
PartSet allButParts(const Model& model, std::span<const NamedPart> parts,
                    std::span<const std::uint8_t> chosen);

/// One value for each triangle: 1 where it is of a part of the set.
std::vector<std::uint8_t> partTriangles(const Model& model, const PartSet& set);

} // namespace rtcore

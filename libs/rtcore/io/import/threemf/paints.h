/// Colours of corners, and the images that lie on them.
#pragma once

#include "rtcore/io/import/threemf/model_part.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace rtcore::threemf {

/// The group of this number; null where there is none.
const PropertyGroup* groupAt(const PartContent& part, std::uint32_t number);

/// The colour of an entry: mixed of those of its parts or layers, if these are such; layers of images are
/// passed over. Nothing where group or entry do not exist or say no colour.
std::optional<Paint> paintAt(const PartContent& part, std::uint32_t group, std::uint32_t entry);

/// `upper` over `lower`, or multiplied with it. Linear.
Paint blended(Paint lower, Paint upper, bool multiply);

/// A layer of images, of which the group has none or several.
inline bool isTexture(const PartContent& part, std::uint32_t group) {
    const PropertyGroup* const found = groupAt(part, group);
    return found != nullptr && found->kind == GroupKind::Texture;
}

/// Where the entry of a group of images lies on its image; nothing where it does not exist.
std::optional<Vec2> coordinateAt(const PartContent& part, std::uint32_t group, std::uint32_t entry);

/// The number of the entry of a group of layers in its column; kNoNumber where there is none.
std::uint32_t entryOfLayer(const PropertyGroup& layers, std::uint32_t entry, std::size_t column);

} // namespace rtcore::threemf

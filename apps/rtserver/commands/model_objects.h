/// The materials and parts of the model as commands name them, and as text for clients.
#pragma once

#include "rtcore/scene/part_list.h"
#include "rtcore/survey/seen_object.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace rtserver {

/// Those that a number, counted from 1, or a pattern stands for; counted from 0, ascending. Throw
/// app::UsageError where it stands for none.
std::vector<std::size_t> materialsNamed(const rtcore::Scene& scene, const std::string& text);
/// One value for each of `parts`: 1 where any of the texts stands for it.
std::vector<std::uint8_t> partsNamed(std::span<const rtcore::NamedPart> parts,
                                     std::span<const std::string> texts);

/// A line each from number `first` (counted from 1) on, as many as an answer takes.
std::string materialLines(const rtcore::Scene& scene, int first);
std::string partLines(const rtcore::Scene& scene, int first);

/// As a [[material]] with all keys says it; `textures` only where the material has some.
std::string materialText(const rtcore::Scene& scene, std::span<const rtcore::Material> loaded,
                         std::size_t index);

/// Two lines.
std::string seenText(const rtcore::Scene& scene, const rtcore::SeenObject& seen);

/// Width, height and runs of a mask; coarser where an answer has no room for it.
std::string maskText(const std::vector<bool>& mask, int width, int height);

} // namespace rtserver

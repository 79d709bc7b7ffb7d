/// Sections of a .scn that are for something of the model: by a pattern of its name or by its number.
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/platform/sentence.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

/// Whether a section for `pattern`, or for the `number` counted from 1, is for the element `index` of a list.
bool isNamed(const std::string& pattern, std::optional<int> number, std::size_t index, std::string_view name);

/// The warning of a section, of a material or a part, that is for nothing of the model; `path` of the .scn.
/// The forms are for a number and for a pattern.
Sentence unusedSection(const std::filesystem::path& path, const char* ofNumber, const char* ofPattern,
                       const auto& section) {
    return say("{0}: {1}", path.string(),
               section.number ? say(ofNumber, *section.number) : say(ofPattern, section.pattern));
}

Sentence unusedMaterial(const std::filesystem::path& path, const MaterialOverride& section);
Sentence unusedPart(const std::filesystem::path& path, const PartDescription& section);

} // namespace rtcore

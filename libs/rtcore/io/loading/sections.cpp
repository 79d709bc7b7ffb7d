#include "rtcore/io/loading/sections.h"

#include "rtcore/io/text/pattern.h"

namespace rtcore {

bool isNamed(const std::string& pattern, std::optional<int> number, std::size_t index,
             std::string_view name) {
    return number ? static_cast<std::size_t>(*number) == index + 1 : matchesPattern(pattern, name);
}

Sentence unusedMaterial(const std::filesystem::path& path, const MaterialOverride& section) {
    return unusedSection(path, form("no material of the model has the number {0}"),
                         form("no material of the model is named like \"{0}\""), section);
}

Sentence unusedPart(const std::filesystem::path& path, const PartDescription& section) {
    return unusedSection(path, form("no part of the model has the number {0}"),
                         form("no part of the model is named like \"{0}\""), section);
}

} // namespace rtcore

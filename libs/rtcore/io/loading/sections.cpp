#include "rtcore/io/loading/sections.h"

#include "rtcore/io/text/pattern.h"

namespace rtcore {

bool isNamed(const std::string& pattern, std::optional<int> number, std::size_t index,
             std::string_view name) {
    return number ? static_cast<std::size_t>(*number) == index + 1 : matchesPattern(pattern, name);
}

std::string unusedSection(const std::filesystem::path& path, const std::string& what,
                          const std::string& pattern, std::optional<int> number) {
    const std::string which =
        number ? "has the number " + std::to_string(*number) : "is named like \"" + pattern + "\"";
    return path.string() + ": no " + what + " of the model " + which;
}

} // namespace rtcore

#include "rtcore/io/loading/sections.h"

#include "rtcore/io/text/pattern.h"

namespace rtcore {

bool isNamed(const std::string& pattern, std::optional<int> number, std::size_t index,
             std::string_view name) {
    return number ? static_cast<std::size_t>(*number) == index + 1 : matchesPattern(pattern, name);
}

} // namespace rtcore

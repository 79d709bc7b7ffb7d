#include "common/settings/named_numbers.h"

#include "common/cli/command_line.h"

#include "rtcore/io/text/pattern.h"

#include <cstdint>
#include <optional>
#include <utility>

namespace app {

std::vector<std::size_t> fitting(const std::string& pattern, std::size_t count, const NameOf& nameOf) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < count; ++i) {
        if (rtcore::matchesPattern(pattern, nameOf(i))) all.push_back(i);
    }
    return all;
}

std::vector<std::size_t> numbersNamed(const std::string& text, std::size_t count, const NameOf& nameOf) {
    std::vector<std::size_t> all = fitting(text, count, nameOf);
    if (!all.empty()) return all;
    const std::optional<std::int64_t> number = parseInteger(text);
    if (number && *number >= 1 && std::cmp_less_equal(*number, count))
        return {static_cast<std::size_t>(*number - 1)};
    return {};
}

} // namespace app

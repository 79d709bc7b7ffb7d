#include "common/cli/parent_option.h"

#include <limits>

namespace app {

Option parentOption() {
    return {.name = "parent",
            .value = ValueKind::Integer,
            .argument = "PID",
            .help = "stop as soon as this process, which started the program, is no more",
            .minimum = 1,
            .maximum = std::numeric_limits<std::int32_t>::max()};
}

std::int64_t parentOf(const Arguments& arguments) { return arguments.integer("parent").value_or(0); }

} // namespace app

#include "bridge/control/plain_name.h"

#include "rtcore/settings/plain_text.h"

namespace bridge {

std::string plainName(std::string_view given) {
    constexpr std::size_t kMax = 40;
    return rtcore::withoutControls(given, kMax);
}

} // namespace bridge

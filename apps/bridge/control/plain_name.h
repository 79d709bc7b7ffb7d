/// A name as others see it.
#pragma once

#include <string>
#include <string_view>

namespace bridge {

/// rtcore::withoutControls(), 40 characters at most.
std::string plainName(std::string_view given);

} // namespace bridge

/// A name as others see it.
#pragma once

#include <string>
#include <string_view>

namespace bridge {

/// Without control characters, 40 characters at most; `given` is UTF-8.
std::string plainName(std::string_view given);

} // namespace bridge

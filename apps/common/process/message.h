/// Messages of a program to the people who run it.
#pragma once

#include <string_view>

namespace app {

/// "Program: text" and a line end, on stderr, in one write. Names in the text may come from anywhere: control
/// characters and what is no UTF-8 are shown as `\xNN`. Safe from any thread.
void printMessage(std::string_view program, std::string_view text) noexcept;

} // namespace app

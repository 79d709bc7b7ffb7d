/// Which ones of many things a name, a pattern or a number stands for: materials, parts, lights.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// The name of the thing with that index, counted from 0.
using NameOf = std::function<std::string_view(std::size_t)>;

/// Those whose names a pattern fits (rtcore::matchesPattern()), counted from 0, ascending.
std::vector<std::size_t> fitting(const std::string& pattern, std::size_t count, const NameOf& nameOf);
/// The same, else the one of that number, counted from 1. Empty where `text` stands for none.
std::vector<std::size_t> numbersNamed(const std::string& text, std::size_t count, const NameOf& nameOf);

} // namespace app

/// Numbers at even distances, for loops over ranges.
#pragma once

#include <cstddef>
#include <vector>

namespace test {

/// from, from + step, ... below `to`; counted in integers, so that rounding never adds or loses one.
template <typename Number>
std::vector<Number> steps(Number from, Number to, Number step) {
    std::vector<Number> numbers;
    const auto count = static_cast<int>((to - from) / step);
    numbers.reserve(static_cast<std::size_t>(count) + 1);
    for (int i = 0; i <= count; ++i) {
        const Number x = from + static_cast<Number>(i) * step;
        if (x < to) numbers.push_back(x);
    }
    return numbers;
}

} // namespace test

/// Work on an image in parts, by several threads.
#pragma once

#include "rtcore/platform/task_errors.h"

#include <algorithm>
#include <cstddef>

namespace rtcore {

/// Calls `work` with the number of each of `parts` parts, by `threads`, in any order. Throws what it throws.
template <typename Work>
void forEachPart(std::size_t parts, [[maybe_unused]] int threads, Work&& work) {
    const auto count = static_cast<int>(parts);
    TaskErrors errors;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (int part = 0; part < count; ++part) {
        if (!errors.any()) errors.guard([&] { work(static_cast<std::size_t>(part)); });
    }
    errors.rethrow();
}

/// The same with parts of `rowsOfPart` rows: `work` gets the first row of each, and that behind it.
template <typename Work>
void forEachRows(int rows, int rowsOfPart, int threads, Work&& work) {
    const auto parts = static_cast<std::size_t>((rows + rowsOfPart - 1) / rowsOfPart);
    forEachPart(parts, threads, [&](std::size_t part) {
        const int first = static_cast<int>(part) * rowsOfPart;
        work(first, std::min(first + rowsOfPart, rows));
    });
}

} // namespace rtcore

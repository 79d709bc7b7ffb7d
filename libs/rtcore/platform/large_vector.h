/// Long lists in large pages (raw_memory.h).
#pragma once

#include "rtcore/platform/raw_memory.h"

#include <cstddef>
#include <vector>

namespace rtcore {

/// As list.reserve(capacity).
template <typename T>
void reserveLarge(std::vector<T>& list, std::size_t capacity) {
    if (capacity <= list.capacity()) return;
    std::vector<T> larger;
    larger.reserve(capacity);
    preferLargePages(larger.data(), capacity * sizeof(T));
    larger.assign(list.begin(), list.end());
    list.swap(larger);
}

/// As list.resize(size); the system clears the pages of new memory for all threads of OpenMP at once.
template <typename T>
void resizeLarge(std::vector<T>& list, std::size_t size) {
    reserveLarge(list, size);
    if (size > list.size()) touchPages(list.data() + list.size(), (size - list.size()) * sizeof(T));
    list.resize(size);
}

} // namespace rtcore

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

/// As list.resize(size).
template <typename T>
void resizeLarge(std::vector<T>& list, std::size_t size) {
    reserveLarge(list, size);
    list.resize(size);
}

} // namespace rtcore

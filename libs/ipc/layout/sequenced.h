/// One value with one writer and any number of readers, none of whom waits. The number is odd while the value
/// changes.
#pragma once

#include <atomic>
#include <cstdint>
#include <type_traits>

namespace ipc {

template <class T>
struct alignas(64) Sequenced {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) == 8 && sizeof(T) % 8 == 0);
    std::atomic<std::uint64_t> sequence;
    T value;
};

} // namespace ipc

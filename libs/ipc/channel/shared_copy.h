/// Copies to and from memory that another process may change at the same time. What was read counts only when
/// the sequence number beside it did not change meanwhile (Boehm 2012, "Can seqlocks get along with
/// programming language memory models?"): a writer stores odd, releases, copies, stores even with release; a
/// reader loads with acquire, copies, acquires, loads again.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace ipc {

#if defined(__SANITIZE_THREAD__)

// The thread sanitizer does not know fences and reports a plain copy as a race; so it copies word by word,
// which is slow.
inline void copyToShared(void* to, const void* from, std::size_t bytes) {
    auto* target = static_cast<std::uint8_t*>(to);
    const auto* source = static_cast<const std::uint8_t*>(from);
    std::size_t i = 0;
    for (; i + 8 <= bytes; i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, source + i, 8);
        std::atomic_ref(*reinterpret_cast<std::uint64_t*>(target + i)).store(word, std::memory_order_release);
    }
    for (; i < bytes; ++i) std::atomic_ref(target[i]).store(source[i], std::memory_order_release);
}
inline void copyFromShared(void* to, const void* from, std::size_t bytes) {
    auto* target = static_cast<std::uint8_t*>(to);
    auto* source = const_cast<std::uint8_t*>(static_cast<const std::uint8_t*>(from));
    std::size_t i = 0;
    for (; i + 8 <= bytes; i += 8) {
        const auto word =
            std::atomic_ref(*reinterpret_cast<std::uint64_t*>(source + i)).load(std::memory_order_acquire);
        std::memcpy(target + i, &word, 8);
    }
    for (; i < bytes; ++i) target[i] = std::atomic_ref(source[i]).load(std::memory_order_acquire);
}
inline void fenceBeforeWriting() {}
inline void fenceAfterReading() {}

#else

inline void copyToShared(void* to, const void* from, std::size_t bytes) {
    if (bytes != 0) std::memcpy(to, from, bytes);
}
inline void copyFromShared(void* to, const void* from, std::size_t bytes) {
    if (bytes != 0) std::memcpy(to, from, bytes);
    // The compiler must not read `from` a second time: the value that is checked is the one that is used.
    std::atomic_signal_fence(std::memory_order_seq_cst);
}
inline void fenceBeforeWriting() { std::atomic_thread_fence(std::memory_order_release); }
inline void fenceAfterReading() { std::atomic_thread_fence(std::memory_order_acquire); }

#endif

/// A field of our own that should have this value: checked often, written only when another process overwrote
/// it.
template <class T>
void keep(std::atomic<T>& field, T value) {
    if (field.load(std::memory_order_relaxed) != value) field.store(value, std::memory_order_release);
}
template <class T>
void keep(T& field, const T& value) {
    static_assert(std::has_unique_object_representations_v<T>);
    if (std::memcmp(&field, &value, sizeof(T)) != 0) copyToShared(&field, &value, sizeof(T));
}

} // namespace ipc

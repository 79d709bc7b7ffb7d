/// A list in memory that is not cleared first.
#pragma once

#include "rtcore/platform/raw_memory.h"

#include <cstddef>
#include <memory>
#include <type_traits>

namespace rtcore {

/// Pages that are never written cost nothing, so that a capacity may be a rough upper bound.
template <typename T>
class UninitializedArray {
    static_assert(std::is_trivial_v<T> && alignof(T) <= 16);

  public:
    UninitializedArray() = default;
    explicit UninitializedArray(std::size_t capacity)
        : data_(static_cast<T*>(allocateRaw(capacity * sizeof(T)))), capacity_(capacity) {}

    T* data() { return data_.get() + first_; }
    const T* data() const { return data_.get() + first_; }
    std::size_t capacity() const { return capacity_ - first_; }
    std::size_t size() const { return size_; }
    void setSize(std::size_t size) { size_ = size; }
    /// Forgets the first `count` elements without moving the others.
    void dropFront(std::size_t count) {
        first_ += count;
        size_ -= count;
    }

  private:
    struct Free {
        void operator()(T* memory) const { freeRaw(memory); }
    };

    std::unique_ptr<T[], Free> data_;
    std::size_t capacity_ = 0;
    std::size_t first_ = 0;
    std::size_t size_ = 0;
};

} // namespace rtcore

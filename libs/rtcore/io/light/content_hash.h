/// A hash of 64 bits of much content, to tell whether it is the same as before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace rtcore {

/// Some 5 GB per second. The order counts, and where what is added begins and ends. No protection against
/// those who look for another content of the same hash.
class ContentHash {
  public:
    void add(std::span<const std::byte> bytes);
    void add(std::string_view text) { add(std::as_bytes(std::span(text))); }
    /// Of records without gaps.
    template <typename T>
    void add(std::span<const T> records) {
        static_assert(std::is_trivially_copyable_v<T>);
        add(std::as_bytes(records));
    }
    template <typename T>
    requires std::is_arithmetic_v<T>
    void add(T number) { add(std::span<const T>(&number, 1)); }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0;
};

} // namespace rtcore

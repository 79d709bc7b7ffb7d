/// How far the making of a pack is, and the word to give it up.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>

namespace rtserver {

/// One thread packs; any other may read `done` and `all`, and set `stop`.
struct PackProgress {
    std::atomic<std::uint64_t> done{0}, all{0}; ///< bytes, each twice: it is copied, and the copy is read
    std::atomic<bool> stop{false};

    /// 0..1
    double fraction() const {
        const std::uint64_t total = all;
        return total == 0 ? 0 : std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
    }
};

} // namespace rtserver

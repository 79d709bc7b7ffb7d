#include "rtcore/irradiance/hashed_cell.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace rtcore {

/// By how far from their own slots they come to lie, which their order does not change.
bool areSpread(std::span<const std::uint64_t> hashes) {
    constexpr std::size_t kMeanDistance = 8, kOfAnyFew = 4096; // honest ones: below 1
    std::vector<std::uint32_t> own(std::bit_ceil(std::max<std::size_t>(2 * hashes.size(), 2)));
    for (const std::uint64_t hash : hashes) ++own[hash & (own.size() - 1)];
    std::uint64_t waiting = 0, distance = 0;
    for (std::size_t turn = 0; turn < 2; ++turn) { // the last ones go on at the first slot
        distance = 0;
        for (const std::uint32_t count : own) {
            waiting += count;
            if (waiting > 0) --waiting;
            distance += waiting;
        }
    }
    return distance <= kMeanDistance * hashes.size() + kOfAnyFew;
}

} // namespace rtcore

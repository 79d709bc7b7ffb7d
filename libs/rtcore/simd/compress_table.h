/// Which lanes a compressed vector takes, for each set of up to eight lanes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rtcore {

struct CompressTable {
    /// The set's lanes in ascending order, then the others.
    std::uint8_t lanes[256][8] = {};

    constexpr CompressTable() {
        for (std::size_t set = 0; set < 256; ++set) {
            std::size_t next = 0;
            for (const bool in : {true, false}) {
                for (std::uint8_t lane = 0; lane < 8; ++lane) {
                    if ((set >> lane & 1U) == (in ? 1U : 0U)) lanes[set][next++] = lane;
                }
            }
        }
    }
};
inline constexpr CompressTable kCompressTable;

} // namespace rtcore

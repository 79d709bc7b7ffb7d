/// Keys as a server sees them. What a code means is agreed between the programs.
#pragma once

#include "ipc/layout/limits.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>

namespace ipc {

/// What is pressed, united over the clients.
struct KeyState {
    std::bitset<kMaxKeys> down;                    ///< down now
    std::array<std::uint32_t, kMaxKeys> presses{}; ///< times pressed since the state was last asked for
    bool held(int key) const { return down[static_cast<std::size_t>(key)]; }
    std::uint32_t pressed(int key) const { return presses[static_cast<std::size_t>(key)]; }
};

} // namespace ipc

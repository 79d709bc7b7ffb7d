/// Keys as a server sees them. What a code means is agreed between the programs.
#pragma once

#include "ipc/layout/limits.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>

namespace ipc {

/// The keys that are pressed, united over the clients.
struct KeyState {
    using Presses = std::array<std::uint32_t, kMaxKeys>;
    std::bitset<kMaxKeys> down; ///< down now
    Presses presses{};          ///< times pressed since the state was last asked for
    /// The presses among them by clients of a restraint of 1 at least, and of 2: the higher, the less their
    /// keys may do. The server decides how much that is.
    std::array<Presses, kKeyRestraints> restrained{};
};

} // namespace ipc

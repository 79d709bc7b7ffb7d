/// A word that one process waits on and others set; platform/system.h knows how to use it.
#pragma once

#include <atomic>
#include <cstdint>

namespace ipc {

struct alignas(64) Doorbell {
    std::atomic<std::uint32_t> rung; ///< not 0: it was rung since it was last looked at
};

} // namespace ipc

/// Memory of a semaphore shared by processes; platform/system.h knows how to use it.
#pragma once

#include <cstddef>

namespace ipc {

struct alignas(64) Doorbell {
    std::byte memory[64];
};

} // namespace ipc

/// Names of paths, from which their random numbers follow.
#pragma once

#include <cstdint>

namespace rtcore {

/// One element for each sample of a wave of camera rays.
struct PathNames {
    const std::uint32_t* pixel = nullptr; ///< pixelName()
    const std::uint32_t* sub = nullptr;
    std::uint32_t first = 0; ///< of a wave of camera rays: its first sample
};

} // namespace rtcore

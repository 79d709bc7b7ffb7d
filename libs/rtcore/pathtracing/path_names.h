/// What names the random numbers of paths.
#pragma once

#include <cstdint>

namespace rtcore {

/// Of each sample of a wave of camera rays.
struct PathNames {
    const std::uint32_t* pixel = nullptr; ///< pixelName()
    const std::uint32_t* sub = nullptr;
};

} // namespace rtcore

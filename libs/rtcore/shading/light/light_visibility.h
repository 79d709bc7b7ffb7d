/// Known visibility of lights at a point, which saves shadow rays.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rtcore {

/// A bit for each of the scene's first kRememberedLights lights, set in `clear` where all of its light
/// arrives and in `dark` where none does. Of lights with neither nothing is known, or they arrive in part. To
/// lights with a size one ray is traced all the same; what it does not confirm does not count.
struct LightVisibility {
    std::uint32_t clear = 0, dark = 0;

    friend bool operator==(const LightVisibility&, const LightVisibility&) = default;
};
inline constexpr std::size_t kRememberedLights = 32;

} // namespace rtcore

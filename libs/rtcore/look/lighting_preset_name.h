/// The ready-made light of a scene, by name.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace rtcore {

/// Sky: a sky with its sun, lights under the ceilings of rooms, and a ground below an object. Studio: white
/// walls with three soft lights around an object, which mirrors show; in a room, its lights before an even
/// background that lights. Headlight: a point light beside the viewer and ambient light, both without regard
/// to what the model is.
enum class LightingPreset : std::uint8_t { Sky, Studio, Headlight };

/// By Look.
inline constexpr std::array<std::string_view, 3> kLightingPresetNames{"sky", "studio", "headlight"};

} // namespace rtcore

/// The kinds of rays that are raced.
#pragma once

#include "rtcore/kernels/ray_wave.h"

#include <array>
#include <string_view>

namespace rtbench {

struct RayTest {
    std::string_view name; ///< in --rays, tables and JSON
    rtcore::RayKind kind;
    bool anyHit; ///< only whether something is hit; else distance, triangle and barycentrics
};

/// primary: one ray a pixel. All others start at what these hit: shadow rays end at the light, ao has 9
/// directions distributed by the cosine, up to 15 % of the diagonal, at every second pixel of every second
/// row, mirror reflects perfectly, bounce has one direction distributed by the cosine.
inline constexpr std::array<RayTest, 5> kRayTests{{
    {"primary", rtcore::RayKind::Primary, false},
    {"shadow", rtcore::RayKind::Shadow, true},
    {"ao", rtcore::RayKind::Occlusion, true},
    {"mirror", rtcore::RayKind::Mirror, false},
    {"bounce", rtcore::RayKind::Scattered, false},
}};

} // namespace rtbench

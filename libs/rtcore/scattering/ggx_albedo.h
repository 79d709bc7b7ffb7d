/// How much of even light the GGX lobe reflects to a viewer, as a table.
#pragma once

#include <cstddef>

namespace rtcore {

inline constexpr int kGgxAlbedoSide = 32;

/// With Schlick's reflectance F0 + (1 - F0) (1 - cos)^5 the albedo is F0 straight + grazing; of perfect
/// mirrors the sum of both. Rows by roughness, columns by the square root of the viewer's cosine, each from 0
/// to 1. Between them ggxAlbedo() of ggx_albedo-inl.h interpolates, with errors up to 0.006 for cosines from
/// 0.02 on and up to 0.035 below. `mean`: of perfect mirrors, for light from all sides; by roughness.
struct GgxAlbedoTable {
    float straight[kGgxAlbedoSide * kGgxAlbedoSide];
    float grazing[kGgxAlbedoSide * kGgxAlbedoSide];
    float mean[kGgxAlbedoSide];
};

/// Made when it is first asked for, which takes some 15 ms; the same bits on every processor. Safe from many
/// threads.
const GgxAlbedoTable& ggxAlbedoTable();

} // namespace rtcore

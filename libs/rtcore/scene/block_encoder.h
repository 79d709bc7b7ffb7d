/// Blocks (texel_block.h) of images.
#pragma once

#include "rtcore/scene/texel_block.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace rtcore {

/// The block of 16 texels, rows from the top; alpha is not in it. Exact where the ranges of the channels fit
/// the indices of one of kBlockModes, else by the mode from which the smallest squared error is expected.
TexelBlock encodeBlock(const std::array<Rgba8, kBlockTexels>& texels);

/// Appends the blocks of the image, in rows from the top, those at its right and lower edge filled up with
/// the texels of the edge. By the threads of OpenMP, whose number does not change a bit; about 0.1 s for each
/// 10^7 texels and thread. Returns the squared error in codes, the mean over all texels and red, green and
/// blue.
double appendBlocks(const LdrImage& image, std::vector<TexelBlock>& to);

} // namespace rtcore

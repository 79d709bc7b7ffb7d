/// In which form a model keeps an image.
#pragma once

#include "rtcore/scene/model.h"

namespace rtcore {

/// Images of fewer texels stay as they are.
inline constexpr std::size_t kWorthBlocks = std::size_t{1} << 20;

/// Adds the texels of the image to the model and says where they are. An opaque one of at least kWorthBlocks
/// texels is stored in blocks (texel_block.h), which take half the memory, if the mean squared error of all
/// its codes is at most 1, a PSNR of 48.1 dB; one that holds normals (relief.h), if it is at most that of
/// rounding to codes, 1/12. The number of threads does not change a bit.
Texture storeImage(const LdrImage& image, ModelBuffers& model);

} // namespace rtcore

#include "rtcore/render/tile_store.h"

#include "rtcore/render/camera_rays.h"

#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/render/tile_store.cpp"
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void storeColours(const float* HWY_RESTRICT r, const float* HWY_RESTRICT g, const float* HWY_RESTRICT b,
                  std::size_t width, Colour* HWY_RESTRICT pixels) {
    const hn::CappedTag<float, kCameraBlock> d;
    for (std::size_t y = 0; y < kCameraBlock; ++y) {
        for (std::size_t x = 0; x < kCameraBlock; x += hn::Lanes(d)) {
            const std::size_t i = y * kCameraBlock + x;
            hn::StoreInterleaved3(hn::LoadU(d, r + i), hn::LoadU(d, g + i), hn::LoadU(d, b + i), d,
                                  &pixels[y * width + x].r);
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(storeColours);

void storeBlock(const float* r, const float* g, const float* b, const std::uint8_t* hit, std::size_t width,
                Colour* pixels, std::uint8_t* covered) {
    HWY_DYNAMIC_DISPATCH(storeColours)(r, g, b, width, pixels);
    for (std::size_t y = 0; y < kCameraBlock; ++y) {
        std::uint64_t row = 0;
        std::memcpy(&row, hit + y * kCameraBlock, sizeof row);
        row *= 255; // bytes of 0 or 1: no carry
        std::memcpy(covered + y * width, &row, sizeof row);
    }
}

} // namespace rtcore
#endif

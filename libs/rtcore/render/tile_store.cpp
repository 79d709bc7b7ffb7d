#include "rtcore/render/tile_store.h"

#include "rtcore/render/camera_rays.h"

#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/render/tile_store.cpp"
#include "rtcore/simd/foreach_target.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void storeColours(const float* HWY_RESTRICT r, const float* HWY_RESTRICT g, const float* HWY_RESTRICT b,
                  std::size_t width, Colour* HWY_RESTRICT pixels) {
    const hn::CappedTag<float, 4> d;
    for (int y = 0; y < kCameraBlock; ++y) {
        for (int x = 0; x < kCameraBlock; x += static_cast<int>(hn::Lanes(d))) {
            const auto i = static_cast<std::size_t>(indexInBlock(x, y));
            const std::size_t pixel = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
            hn::StoreInterleaved3(hn::LoadU(d, r + i), hn::LoadU(d, g + i), hn::LoadU(d, b + i), d,
                                  &pixels[pixel].r);
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
    for (int y = 0; y < kCameraBlock; ++y) {
        for (int x = 0; x < kCameraBlock; x += 4) {
            std::uint32_t four = 0;
            std::memcpy(&four, hit + indexInBlock(x, y), sizeof four);
            four *= 255; // bytes of 0 or 1: no carry
            std::memcpy(covered + static_cast<std::size_t>(y) * width + x, &four, sizeof four);
        }
    }
}

} // namespace rtcore
#endif

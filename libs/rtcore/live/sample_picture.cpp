#include "rtcore/live/sample_picture.h"

#include "rtcore/live/parts.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/live/sample_picture.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/live/packed_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace {

void unpackAll(const std::uint32_t* light, std::size_t count, Colour* to) {
    std::size_t i = 0;
    for (; i + lanes() <= count; i += lanes()) {
        const Float3 unpacked = unpackedLight<Float>(load(light + i));
        hn::StoreInterleaved3(unpacked.x.raw, unpacked.y.raw, unpacked.z.raw, FloatTag(), &to[i].r);
    }
    for (; i < count; ++i) to[i] = unpackLight(light[i]);
}

} // namespace

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(unpackAll);

namespace {

/// Of a pixel without a sample: the mean of those next to it, or, amid such pixels, of those around.
Colour filled(const LiveSamples& samples, const SampleMeans& means, const std::vector<Colour>& light, int x,
              int y) {
    const ImagePlane& plane = samples.plane();
    Colour sum;
    int known = 0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, plane.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, plane.width - 1); ++u) {
            const std::size_t at = samples.index(u, v);
            if (!samples.known(at)) continue;
            sum += light[at];
            ++known;
        }
    }
    return known > 0 ? sum / static_cast<float>(known) : means.around(x, y);
}

} // namespace

void SamplePicture::show(const LiveSamples& samples, int threads, Frame& frame) {
    const ImagePlane& plane = samples.plane();
    std::vector<Colour>& light = frame.radiance.pixels;
    means_.begin(plane.width, plane.height);
    forEachRows(plane.height, SampleMeans::kSide, threads, [&](int first, int last) {
        const std::size_t from = samples.index(0, first), count = samples.index(0, last) - from;
        HWY_DYNAMIC_DISPATCH(unpackAll)(&samples.light[from], count, &light[from]);
        for (std::size_t i = from; i < from + count; ++i)
            frame.covered[i] = (samples.states[i] & LiveSamples::kBackground) != 0 ? 0 : 255;
        means_.take(samples, light, first, last);
    });
    constexpr int kRows = 8;
    forEachRows(plane.height, kRows, threads, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            const std::size_t row = samples.index(0, y);
            for (int x = 0; x < plane.width; ++x) {
                const std::size_t i = row + static_cast<std::size_t>(x);
                if (!samples.known(i)) light[i] = filled(samples, means_, light, x, y);
            }
        }
    });
}

} // namespace rtcore
#endif

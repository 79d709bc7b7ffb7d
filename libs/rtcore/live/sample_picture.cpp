#include "rtcore/live/sample_picture.h"

#include "rtcore/live/parts.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <atomic>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/live/sample_picture.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/live/live_samples-inl.h"

#ifndef RTCORE_LIVE_SAMPLE_PICTURE_TYPES
#define RTCORE_LIVE_SAMPLE_PICTURE_TYPES
namespace rtcore {

/// A row of samples, ready to be weighed. Each array can be read one before its first pixel, and a vector
/// behind its last.
struct WeighedRow {
    static constexpr int kArrays = 9;
    static constexpr std::size_t kRoom = 64; ///< no vector has more lanes

    float* light[3];
    float* across[3]; ///< weight in the pixel to the left, in its own, in that to the right
    float* down[3];   ///< in the pixel above, in its own, in that below

    static std::size_t arrayLength(std::size_t pixels) { return pixels + 2 * kRoom; }
    WeighedRow(float* values, std::size_t pixels) {
        float* next = values + kRoom;
        for (auto* arrays : {&light, &across, &down}) {
            for (float*& array : *arrays) {
                array = next;
                next += arrayLength(pixels);
            }
        }
    }
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace {

/// Of a sample so many pixels off, across or down.
HWY_INLINE Float weightAt(Float distance) {
    constexpr float kLeast = 1e-4F; // of what is further away than a pixel, where nothing else is
    const Float falling = max(1.0F - distance * distance, kLeast);
    return falling * falling;
}

/// Row `y` of the samples. A pixel whose light is not all known weighs nothing. Of one that mirrors the place
/// is that of the layer which is brighter.
void weighRow(const LiveLayers& samples, int y, const WeighedRow& to) {
    const LiveSamples& own = samples.own;
    const ImagePlane& plane = own.plane();
    const std::size_t row = own.index(0, y);
    const Float middleY = static_cast<float>(y) + 0.5F;
    for (std::size_t x = 0; x < static_cast<std::size_t>(plane.width); x += lanes()) {
        const std::size_t i = row + x;
        const LivePoints points(own.points[i]);
        Mask known = points.state != 0U;
        Float3 light = radianceOf(own.lights[i]);
        SeenAt at = seenAt(points, plane);
        const Mask mirrors = points.has(LiveSamples::kMirrors);
        if (any(mirrors)) {
            const Float3 mirrored = radianceOf(samples.mirrored.lights[i]);
            const LivePoints mirroredPoints(samples.mirrored.points[i]);
            const SeenAt there = seenAt(mirroredPoints, plane);
            const Mask brighter = mirrors & (luminance<Float>(mirrored) > luminance<Float>(light));
            at = {select(brighter, there.x, at.x), select(brighter, there.y, at.y), at.depth};
            light += selectOrZero(mirrors, mirrored);
            const Mask missing = mirrors & (mirroredPoints.state == 0U);
            known = known & !missing;
        }
        const Float dx = at.x - (toFloat(toInt(iota(x))) + 0.5F), dy = at.y - middleY;
        store(light.x, to.light[0] + x);
        store(light.y, to.light[1] + x);
        store(light.z, to.light[2] + x);
        for (int side = -1; side <= 1; ++side) {
            const auto way = static_cast<float>(side);
            store(selectOrZero(known, weightAt(dx - way)), to.across[side + 1] + x);
            store(selectOrZero(known, weightAt(dy - way)), to.down[side + 1] + x);
        }
    }
}

/// The light of `count` pixels, of samples in their row and in those above and below; below 0 where there is
/// none. Whether there are such.
bool weighedMeans(const WeighedRow* const rows[3], std::size_t count, Colour* to) {
    Float least = 1.0F;
    for (std::size_t x = 0; x < count; x += lanes()) {
        Float3 sum{};
        Float weights = 0.0F;
        for (std::size_t v = 0; v < 3; ++v) {
            for (std::size_t u = 0; u < 3; ++u) {
                const WeighedRow& row = *rows[v];
                const std::size_t at = x + u - 1;
                const Float weight = load(row.across[2 - u] + at) * load(row.down[2 - v] + at);
                sum += load(row.light[0] + at, row.light[1] + at, row.light[2] + at) * weight;
                weights += weight;
            }
        }
        const Mask seen = weights > 0.0F;
        const Float3 mean = select(seen, sum / weights, broadcast(Vec3{-1, -1, -1}));
        if (x + lanes() <= count) {
            hn::StoreInterleaved3(mean.x.raw, mean.y.raw, mean.z.raw, FloatTag(), &to[x].r);
            least = min(least, mean.x);
            continue;
        }
        float last[3][kLanes];
        store(mean.x, last[0]);
        store(mean.y, last[1]);
        store(mean.z, last[2]);
        for (std::size_t k = 0; x + k < count; ++k) {
            to[x + k] = {last[0][k], last[1][k], last[2][k]};
            if (last[0][k] < 0) least = -1.0F;
        }
    }
    return any(least < 0.0F);
}

} // namespace

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(weighRow);
HWY_EXPORT(weighedMeans);

bool SamplePicture::showRows(const LiveLayers& samples, int first, int last, Rows& rows, Frame& frame) const {
    constexpr int kKept = 4; // the row, that above, that below, and one of no weight beyond the image
    const ImagePlane& plane = samples.own.plane();
    const auto width = static_cast<std::size_t>(plane.width);
    const std::size_t size = WeighedRow::kArrays * WeighedRow::arrayLength(width);
    rows.values.assign(kKept * size, 0);
    const WeighedRow weighed[kKept] = {{rows.values.data(), width},
                                       {rows.values.data() + size, width},
                                       {rows.values.data() + 2 * size, width},
                                       {rows.values.data() + 3 * size, width}};
    const auto rowAt = [&](int y) {
        return &weighed[y < 0 || y >= plane.height ? kKept - 1 : y % (kKept - 1)];
    };
    const auto weigh = [&](int y) {
        if (y < 0 || y >= plane.height) return;
        const WeighedRow& row = *rowAt(y);
        HWY_DYNAMIC_DISPATCH(weighRow)(samples, y, row);
        for (float* const array : row.across) std::fill_n(array + width, WeighedRow::kRoom, 0.0F);
    };
    weigh(first - 1);
    weigh(first);
    bool holes = false;
    for (int y = first; y < last; ++y) {
        weigh(y + 1);
        const WeighedRow* const around[] = {rowAt(y - 1), rowAt(y), rowAt(y + 1)};
        const std::size_t row = samples.own.index(0, y);
        if (HWY_DYNAMIC_DISPATCH(weighedMeans)(around, width, &frame.radiance.pixels[row])) holes = true;
        for (std::size_t i = row; i < row + width; ++i)
            frame.covered[i] = (samples.own.points[i].state & LiveSamples::kBackground) != 0 ? 0 : 255;
    }
    return holes;
}

void SamplePicture::show(const LiveLayers& samples, int threads, Frame& frame) {
    const ImagePlane& plane = samples.own.plane();
    std::vector<Colour>& light = frame.radiance.pixels;
    rows_.resize(std::max(rows_.size(), static_cast<std::size_t>(threads)));
    means_.begin(plane.width, plane.height);
    std::atomic<bool> holes = false;
    forEachRows(plane.height, SampleMeans::kSide, threads, [&](int first, int last) {
        Rows& rows = rows_[static_cast<std::size_t>(threadNumber())];
        if (showRows(samples, first, last, rows, frame)) holes.store(true, std::memory_order_relaxed);
    });
    if (!holes) return;
    forEachRows(plane.height, SampleMeans::kSide, threads,
                [&](int first, int last) { means_.take(frame.radiance, first, last); });
    constexpr int kRows = 8;
    forEachRows(plane.height, kRows, threads, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            for (int x = 0; x < plane.width; ++x) {
                Colour& pixel = light[samples.own.index(x, y)];
                if (pixel.r < 0) pixel = means_.around(x, y);
            }
        }
    });
}

} // namespace rtcore
#endif

#include "rtcore/live/reprojection.h"

#include "rtcore/live/parts.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/live/reprojection.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/float3-inl.h"

#ifndef RTCORE_LIVE_REPROJECTION_TYPES
#define RTCORE_LIVE_REPROJECTION_TYPES
namespace rtcore {

// How near and how stale a sample is, to be compared: the upper half are bits of the depth.
inline constexpr float kKeySteps = 32768; ///< of staleness, for a square pixel
inline constexpr std::uint32_t kStalenessOfKey = 0xFFFF;

/// To the pixel that is next to a sample after its own, in the upper bits of a pixel's index.
inline constexpr int kWayShift = 28;
inline constexpr std::int32_t kLeft = 0 << kWayShift, kRight = 1 << kWayShift, kUp = 2 << kWayShift,
                              kDown = 3 << kWayShift;

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace {

/// Of a sample of that state, (dx, dy) from the middle of the pixel that shows it. `depth` > 0.
HWY_INLINE Uint keyOf(Float depth, Float dx, Float dy, Uint state) {
    // Each frame counts as so many square pixels.
    constexpr float kAged = 0.003F, kAgedOfMirrors = 0.25F;
    const Float age = toFloat(toInt(state & LiveSamples::kAge));
    const Float mirrored = toFloat(toInt(shiftRight<LiveSamples::kMirroredShift>(state) & 255U));
    const Float stale = dx * dx + dy * dy + age * (mirrored * (kAgedOfMirrors / 255) + kAged);
    const Int steps = truncate(min(stale * kKeySteps, static_cast<float>(kStalenessOfKey)));
    return (bitsOf(depth) & ~kStalenessOfKey) | toUint(steps);
}

/// For each of `count` samples from `first` on: the pixel that shows it, with the way to the pixel that is
/// next to it, or -1, and its key.
void projectSamples(const LiveSamples& past, const ImagePlane& plane, std::size_t first, std::size_t count,
                    std::int32_t* pixels, std::uint32_t* keys) {
    const auto width = static_cast<float>(plane.width), height = static_cast<float>(plane.height);
    for (std::size_t i = 0; i < count; i += lanes()) {
        const Uint state = load(&past.states[first + i]);
        const Mask background = (state & LiveSamples::kBackground) != 0U;
        const Float3 position = load(&past.x[first + i], &past.y[first + i], &past.z[first + i]);
        const Float3 offset = position - selectOrZero(!background, broadcast(plane.eye));
        const Float depth = dot(offset, broadcast(plane.axis));
        const Float x = dot(offset, broadcast(plane.column)) / depth;
        const Float y = dot(offset, broadcast(plane.row)) / depth;
        const Mask seen =
            (state != 0U) & (depth > 0.0F) & (x >= 0.0F) & (y >= 0.0F) & (x < width) & (y < height);
        const Float insideX = selectOrZero(seen, x), insideY = selectOrZero(seen, y);
        const Int column = truncate(insideX), row = truncate(insideY);
        const Float dx = insideX - toFloat(column) - 0.5F, dy = insideY - toFloat(row) - 0.5F;
        // From pixels at the edge of the image into it.
        const Mask right = (column == 0) | ((dx > 0.0F) & (insideX + 1.0F < width));
        const Mask down = (row == 0) | ((dy > 0.0F) & (insideY + 1.0F < height));
        const Int way = select(abs(dy) > abs(dx), select(down, Int(kDown), Int(kUp)),
                               select(right, Int(kRight), Int(kLeft)));
        store(select(seen, (row * plane.width + column) | way, Int(-1)), &pixels[i]);
        store(keyOf(select(background, std::numeric_limits<float>::max(), depth), dx, dy, state), &keys[i]);
    }
}

} // namespace

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(projectSamples);

namespace {

/// Samples that follow each other, projected together.
constexpr std::size_t kProjected = 2048;
constexpr int kRowsOfBand = 32;
constexpr std::uint32_t kSameDepth = 2; ///< of the depths in keys: what is further away is hidden
/// Staleness of samples that are shown beside where they are.
constexpr auto kBesideSteps = static_cast<std::uint32_t>(0.4F * kKeySteps),
               kBorrowedSteps = static_cast<std::uint32_t>(kKeySteps);

// Entries of pixels: from the upper bits on whether the sample belongs beside, its key, whether it is
// borrowed, its index. The least is shown.
constexpr std::uint64_t kNoSample = ~std::uint64_t{0};
constexpr std::uint64_t kBeside = std::uint64_t{1} << 63, kBorrowed = std::uint64_t{1} << 31;
constexpr std::uint64_t kIndex = (std::uint64_t{1} << kWayShift) - 1;

std::size_t indexOf(std::uint64_t entry) { return entry & kIndex; }
std::uint32_t depthOf(std::uint64_t entry) { return static_cast<std::uint32_t>(entry >> 48) & 0x7FFFU; }
std::uint64_t entryOf(std::uint32_t key, std::size_t index) { return std::uint64_t{key} << 32 | index; }

std::uint32_t staler(std::uint32_t key, std::uint32_t steps) {
    const std::uint32_t stale = std::min((key & kStalenessOfKey) + steps, kStalenessOfKey);
    return (key & ~kStalenessOfKey) | stale;
}

std::size_t pixelOf(std::int32_t pixelAndWay) { return static_cast<std::size_t>(pixelAndWay & ~kDown); }

} // namespace

void Reprojection::project(const LiveSamples& past, const ImagePlane& plane, int threads) {
    pixels_.resize(past.size());
    keys_.resize(past.size());
    parts_.resize((past.size() + kProjected - 1) / kProjected);
    forEachPart(parts_.size(), threads, [&](std::size_t number) {
        Part& part = parts_[number];
        part.first = number * kProjected;
        part.last = std::min(part.first + kProjected, past.size());
        HWY_DYNAMIC_DISPATCH(projectSamples)
        (past, plane, part.first, part.last - part.first, &pixels_[part.first], &keys_[part.first]);
        std::int32_t least = std::numeric_limits<std::int32_t>::max(), most = -1;
        for (std::size_t i = part.first; i < part.last; ++i) {
            const std::int32_t pixel = pixels_[i] < 0 ? -1 : pixels_[i] & ~kDown;
            least = std::min(least, pixel < 0 ? least : pixel);
            most = std::max(most, pixel);
        }
        part.least = most < 0 ? 1 : static_cast<std::size_t>(least);
        part.most = most < 0 ? 0 : static_cast<std::size_t>(most);
    });
}

/// Calls `work` with each part of the past whose samples may be seen in pixels from `first` to before `last`.
template <typename Work>
void Reprojection::forEachPartIn(std::size_t first, std::size_t last, Work&& work) const {
    for (const Part& part : parts_) {
        if (part.least < last && part.most >= first && part.least <= part.most) work(part);
    }
}

/// Each pixel gets the least entry of its samples.
void Reprojection::compete(std::size_t first, std::size_t last) {
    const std::size_t count = last - first;
    std::uint64_t* const nearest = &nearest_[first];
    std::fill_n(nearest, count, kNoSample);
    forEachPartIn(first, last, [&](const Part& part) {
        for (std::size_t i = part.first; i < part.last; ++i) {
            // Of a sample that is not seen, or elsewhere, far behind the last.
            const std::size_t pixel = static_cast<std::size_t>(pixels_[i] & ~kDown) - first;
            if (pixels_[i] < 0 || pixel >= count) continue;
            nearest[pixel] = std::min(nearest[pixel], entryOf(keys_[i], i));
        }
    });
}

/// Samples move to and fro in the grid of pixels, so that by and by two would fall into many a pixel, and
/// none into that beside it. One of the two goes there.
void Reprojection::spread(const ImagePlane& plane, std::size_t first, std::size_t last) {
    const auto width = static_cast<std::size_t>(plane.width);
    const std::size_t from = first - std::min(first, width), to = last + width;
    forEachPartIn(from, to, [&](const Part& part) {
        std::array<std::uint32_t, kProjected> losers;
        std::size_t count = 0;
        for (std::size_t i = part.first; i < part.last; ++i) {
            const std::size_t pixel = pixels_[i] < 0 ? first : pixelOf(pixels_[i]);
            const std::uint64_t nearest = nearest_[pixel];
            losers[count] = static_cast<std::uint32_t>(i);
            const bool lost = (pixels_[i] >= 0) & (indexOf(nearest) != i) &
                              ((keys_[i] >> 16) <= depthOf(nearest) + kSameDepth);
            count += lost ? 1U : 0U;
        }
        const std::array<std::ptrdiff_t, 4> ways = {-1, 1, -static_cast<std::ptrdiff_t>(width),
                                                    static_cast<std::ptrdiff_t>(width)};
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = losers[k];
            const auto way = static_cast<std::size_t>(static_cast<std::uint32_t>(pixels_[i]) >> kWayShift);
            const std::size_t beside = pixelOf(pixels_[i]) + static_cast<std::size_t>(ways[way]);
            if (beside < first || beside >= last || nearest_[beside] < kBeside) continue;
            nearest_[beside] =
                std::min(nearest_[beside], kBeside | entryOf(staler(keys_[i], kBesideSteps), i));
        }
    });
}

/// Pixels that show no sample, but have such beside them that do, take the nearest of theirs to the viewer.
void Reprojection::borrow(const ImagePlane& plane, int y) {
    constexpr int kLeastKnown = 2;
    const auto width = static_cast<std::size_t>(plane.width);
    const std::size_t row = static_cast<std::size_t>(y) * width;
    const auto entryAt = [&](std::size_t pixel) {
        // Rows beside may be filled by other threads; what they borrow does not count.
        return std::atomic_ref(nearest_[pixel]).load(std::memory_order_relaxed);
    };
    std::size_t holes = 0;
    std::vector<std::uint32_t>& columns = holes_[static_cast<std::size_t>(threadNumber())];
    columns.resize(width);
    for (std::size_t x = 0; x < width; ++x) {
        columns[holes] = static_cast<std::uint32_t>(x);
        holes += nearest_[row + x] == kNoSample ? 1U : 0U;
    }
    for (std::size_t k = 0; k < holes; ++k) {
        const std::size_t x = columns[k], pixel = row + x;
        std::uint64_t best = kNoSample;
        int known = 0;
        const auto ask = [&](std::size_t beside) {
            const std::uint64_t there = entryAt(beside);
            const bool own = (there & kBorrowed) == 0; // not of kNoSample
            known += own ? 1 : 0;
            best = std::min(best, own ? there & ~kBeside : kNoSample);
        };
        if (x > 0) ask(pixel - 1);
        if (x + 1 < width) ask(pixel + 1);
        if (y > 0) ask(pixel - width);
        if (y + 1 < plane.height) ask(pixel + width);
        if (known < kLeastKnown) continue;
        const auto key = static_cast<std::uint32_t>(best >> 32);
        std::atomic_ref(nearest_[pixel])
            .store(kBorrowed | entryOf(staler(key, kBorrowedSteps), indexOf(best)),
                   std::memory_order_relaxed);
    }
}

void Reprojection::take(const LiveSamples& past, LiveSamples& present, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const std::uint64_t nearest = nearest_[i];
        // Behind the last sample there is one that is not known.
        const std::size_t from = nearest == kNoSample ? past.size() : indexOf(nearest);
        present.x[i] = past.x[from];
        present.y[i] = past.y[from];
        present.z[i] = past.z[from];
        present.light[i] = past.light[from];
        present.lights[i] = past.lights[from];
        const std::uint32_t state = past.states[from], age = state & LiveSamples::kAge;
        present.states[i] = state + ((state != 0) & (age < LiveSamples::kAge) ? 1U : 0U);
        staleness_[i] = static_cast<float>(nearest >> 32 & kStalenessOfKey) * (1 / kKeySteps);
    }
}

void Reprojection::carry(const LiveSamples& past, LiveSamples& present, int threads) {
    const ImagePlane& plane = present.plane();
    nearest_.resize(present.size());
    staleness_.resize(present.size());
    holes_.resize(std::max(holes_.size(), static_cast<std::size_t>(threads)));
    project(past, plane, threads);
    forEachRows(plane.height, kRowsOfBand, threads,
                [&](int first, int last) { compete(present.index(0, first), present.index(0, last)); });
    forEachRows(plane.height, kRowsOfBand, threads,
                [&](int first, int last) { spread(plane, present.index(0, first), present.index(0, last)); });
    forEachRows(plane.height, kRowsOfBand, threads, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            borrow(plane, y);
            take(past, present, present.index(0, y), present.index(0, y + 1));
        }
    });
}

} // namespace rtcore
#endif

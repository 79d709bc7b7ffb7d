#include "rtcore/live/reprojection.h"

#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/live/reprojection.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/live/live_samples-inl.h"

#ifndef RTCORE_LIVE_REPROJECTION_TYPES
#define RTCORE_LIVE_REPROJECTION_TYPES
namespace rtcore {

// Keys order samples by depth, then by staleness: the upper half are bits of the depth.
inline constexpr float kKeySteps = 32768; ///< of staleness, for a square pixel
inline constexpr std::uint32_t kStalenessOfKey = 0xFFFF;

/// Pixels from `min` to `max`. Indices count one more at the end of each row, and a row more above the image
/// and below: these never show a sample.
struct PixelRange {
    std::int32_t min, max; ///< none: 2^31 - 1 and -1
};

/// The direction from a sample's pixel to the neighbour nearest to the sample, in the upper bits of an index.
inline constexpr int kDirectionShift = 28;
inline constexpr std::int32_t kLeft = 0 << kDirectionShift, kRight = 1 << kDirectionShift,
                              kUp = 2 << kDirectionShift, kDown = 3 << kDirectionShift;

// Entries of pixels, from the upper bits on: whether the sample belongs to a neighbour, its key, its index.
// The smallest is shown.
inline constexpr std::uint64_t kNoSample = ~std::uint64_t{0}, kBeside = std::uint64_t{1} << 63;
inline constexpr int kKeyShift = 32;
/// About 1/20 in units of the keys' depths: a sample so much further away than its neighbours is seen through
/// a gap.
inline constexpr std::uint64_t kNearer = std::uint64_t{8} << 48;
/// Staleness of samples that are shown beside where they are.
inline constexpr auto kBesideSteps = static_cast<std::uint32_t>(0.4F * kKeySteps),
                      kBorrowedSteps = static_cast<std::uint32_t>(kKeySteps);

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace {

/// Key of a sample of that state, (dx, dy) from the middle of the pixel that shows it. `depth` > 0.
/// `unreliableBits` of states.
HWY_INLINE Uint keyOf(Float depth, Float dx, Float dy, Uint state, std::uint32_t unreliableBits) {
    // Each frame counts as so many square pixels.
    constexpr float kAged = 0.003F, kAgedUnreliable = 0.25F;
    const Float age = toFloat(toInt(state & LiveSamples::kAge));
    const Mask unreliable = (state & unreliableBits) != 0U;
    const Float stale = dx * dx + dy * dy + age * select(unreliable, Float(kAgedUnreliable), Float(kAged));
    const Int steps = truncate(min(stale * kKeySteps, static_cast<float>(kStalenessOfKey)));
    return (bitsOf(depth) & ~kStalenessOfKey) | toUint(steps);
}

/// For each of `count` samples from `first` on: the pixel that shows it, with the direction to the
/// neighbour nearest to it, or -1, and its key. Returns the first and the last of these pixels.
PixelRange projectSamples(const LiveSamples& past, const ImagePlane& plane, std::size_t first,
                          std::size_t count, std::int32_t* pixels, std::uint32_t* keys) {
    constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();
    // Rays of a parallel view that turns pass by where those of the background did before.
    const bool turns = plane.parallel && plane.axis != past.plane().axis;
    const std::uint32_t unreliable = LiveSamples::kUnreliable | (turns ? LiveSamples::kBackground : 0U);
    Int min = kMax, max = -1;
    const auto width = static_cast<float>(plane.width), height = static_cast<float>(plane.height);
    for (std::size_t i = 0; i < count; i += lanes()) {
        const LivePoints points(past.points[first + i]);
        if (none(points.state != 0U)) {
            store(Int(-1), &pixels[i]);
            continue;
        }
        const auto [x, y, depth] = seenAt(points, plane);
        const Mask seen =
            (points.state != 0U) & (depth > 0.0F) & (x >= 0.0F) & (y >= 0.0F) & (x < width) & (y < height);
        const Float insideX = selectOrZero(seen, x), insideY = selectOrZero(seen, y);
        const Int column = truncate(insideX), row = truncate(insideY);
        const Float dx = insideX - toFloat(column) - 0.5F, dy = insideY - toFloat(row) - 0.5F;
        // From pixels at the edge of the image into it.
        const Mask right = (column == 0) | ((dx > 0.0F) & (insideX + 1.0F < width));
        const Mask down = (row == 0) | ((dy > 0.0F) & (insideY + 1.0F < height));
        const Int direction = select(abs(dy) > abs(dx), select(down, Int(kDown), Int(kUp)),
                                     select(right, Int(kRight), Int(kLeft)));
        const Int pixel = (row + 1) * (plane.width + 1) + column;
        const Int low = select(seen, pixel, Int(kMax)), high = select(seen, pixel, Int(-1));
        min = select(low < min, low, min);
        max = select(high > max, high, max);
        store(select(seen, pixel | direction, Int(-1)), &pixels[i]);
        const Mask background = points.has(LiveSamples::kBackground);
        store(keyOf(select(background, std::numeric_limits<float>::max(), depth), dx, dy, points.state,
                    unreliable),
              &keys[i]);
    }
    std::int32_t lows[kLanes], highs[kLanes];
    store(min, lows);
    store(max, highs);
    return {*std::min_element(lows, lows + lanes()), *std::max_element(highs, highs + lanes())};
}

/// Finds those of `count` samples that are shown in one of `pixels` pixels from `first` on: writes their
/// numbers to `shown`, with room for a vector more, and returns how many they are.
std::size_t samplesIn(const std::int32_t* pixelsAndDirections, std::size_t count, std::size_t first,
                      std::size_t pixels, std::uint32_t* shown) {
    const Int from = static_cast<std::int32_t>(first), behind = static_cast<std::int32_t>(pixels),
              end = static_cast<std::int32_t>(count);
    std::size_t found = 0;
    for (std::size_t i = 0; i < count; i += lanes()) {
        const Uint number = iota(i);
        const Int at =
            (load(&pixelsAndDirections[i]) & ~kDown) - from; // of a sample that is not seen below 0
        const Compressor some((at > -1) & (at < behind) & (toInt(number) < end));
        some.store(number, shown + found);
        found += some.count();
    }
    return found;
}

/// Fills in a row of pixels; `rows` has two above, itself and two below. A pixel without a sample, two of
/// whose neighbours have one, gets the nearest of theirs. So does, with `gaps`, a pixel whose sample is seen
/// through a gap in an approaching surface: within two pixels to each side there is a nearer one. (Beyond the
/// image's sides the pixels are those that follow in memory.) Reads and writes a vector behind the last.
void borrowBeside(const std::uint64_t* const rows[5], bool gaps, std::size_t width, std::uint64_t* to) {
    using Entry = Wide<std::uint64_t>;
    constexpr std::uint64_t kStaleness = std::uint64_t{kStalenessOfKey} << kKeyShift,
                            kStaler = std::uint64_t{kBorrowedSteps} << kKeyShift;
    const auto load = [](const std::uint64_t* from)
                          HWY_ATTR -> Entry { return hn::LoadU(Entry::Tag(), from); };
    const auto minOf = [](Entry a, Entry b) HWY_ATTR -> Entry { return hn::Min(a.raw, b.raw); };
    for (std::size_t x = 0; x < width; x += hn::Lanes(Entry::Tag())) {
        Entry entry = load(rows[2] + x);
        const Entry::Mask empty = entry == kNoSample;
        const std::uint64_t* const around[] = {rows[2] + x - 1, rows[2] + x + 1, rows[1] + x, rows[3] + x};
        const Entry near = gaps ? (entry & ~kBeside) - kNearer : Entry(std::uint64_t{0});
        const auto isNearer = [&](const std::uint64_t* one, const std::uint64_t* other) HWY_ATTR {
            return minOf(load(one) & ~kBeside, load(other) & ~kBeside) < near;
        };
        const Entry::Mask covered = isNearer(rows[2] + x - 1, rows[2] + x - 2) &
                                    isNearer(rows[2] + x + 1, rows[2] + x + 2) &
                                    isNearer(rows[1] + x, rows[0] + x) & isNearer(rows[3] + x, rows[4] + x);
        if (any(empty | covered)) {
            Entry best = kNoSample, known = std::uint64_t{0};
            for (const std::uint64_t* const beside : around) {
                const Entry there = load(beside);
                const Entry::Mask some = there != kNoSample;
                known += selectOrZero(some, Entry(std::uint64_t{1}));
                best = minOf(best, select(some, there & ~kBeside, Entry(kNoSample)));
            }
            const Entry stale = minOf((best & kStaleness) + kStaler, kStaleness);
            const Entry::Mask borrows = (empty | covered) & ((known & ~std::uint64_t{1}) != std::uint64_t{0});
            entry = select(borrows, (best & ~kStaleness) | stale, entry);
        }
        store(entry, to + x);
    }
}

} // namespace

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(projectSamples);
HWY_EXPORT(samplesIn);
HWY_EXPORT(borrowBeside);

namespace {

/// Samples that follow each other, projected together.
constexpr std::size_t kProjected = 2048;
constexpr std::size_t kMaxLanes = 64;   ///< no vector has more
constexpr std::uint32_t kSameDepth = 2; ///< of the depths in keys: what is further away is hidden

/// Specular light, by frame: its tint and its position change with the direction of view.
constexpr float kStalerSpecular = 0.2F;

constexpr std::uint64_t kIndex = (std::uint64_t{1} << kDirectionShift) - 1;

std::size_t indexOf(std::uint64_t entry) { return entry & kIndex; }
std::uint32_t depthOf(std::uint64_t entry) { return static_cast<std::uint32_t>(entry >> 48) & 0x7FFFU; }
std::uint64_t entryOf(std::uint32_t key, std::size_t index) {
    return std::uint64_t{key} << kKeyShift | index;
}

float stalenessOf(std::uint64_t entry) {
    return static_cast<float>(entry >> kKeyShift & kStalenessOfKey) * (1 / kKeySteps);
}
LiveSamples::Point aged(LiveSamples::Point point) {
    const std::uint32_t age = point.state & LiveSamples::kAge;
    point.state += (point.state != 0) & (age < LiveSamples::kAge) ? 1U : 0U;
    return point;
}

std::uint32_t staler(std::uint32_t key, std::uint32_t steps) {
    const std::uint32_t stale = std::min((key & kStalenessOfKey) + steps, kStalenessOfKey);
    return (key & ~kStalenessOfKey) | stale;
}

std::size_t pixelOf(std::int32_t pixelAndDirection) {
    return static_cast<std::size_t>(pixelAndDirection & ~kDown);
}

/// Samples are asked for in an order that processors do not foresee.
constexpr std::size_t kAhead = 16; ///< at most kMaxLanes
void fetch(const LiveSamples& samples, std::uint64_t entry) {
    const std::size_t from = entry == kNoSample ? 0 : indexOf(entry);
    __builtin_prefetch(&samples.points[from]);
    __builtin_prefetch(&samples.lights[from]);
}

std::size_t rowLength(const ImagePlane& plane) { return static_cast<std::size_t>(plane.width) + 1; }
std::size_t firstPixel(const ImagePlane& plane, int row) {
    return static_cast<std::size_t>(row + 1) * rowLength(plane);
}

} // namespace

void Reprojection::project(const LiveSamples& past, const ImagePlane& plane, int threads) {
    pixels_.resize(past.size());
    keys_.resize(past.size());
    parts_.resize((past.size() + kProjected - 1) / kProjected);
    forEachPart(parts_.size(), threads, [&](std::size_t number) {
        Part& part = parts_[number];
        part.first = number * kProjected;
        part.last = std::min(part.first + kProjected, past.size());
        const PixelRange seen = HWY_DYNAMIC_DISPATCH(projectSamples)(
            past, plane, part.first, part.last - part.first, &pixels_[part.first], &keys_[part.first]);
        part.min = seen.max < 0 ? 1 : static_cast<std::size_t>(seen.min);
        part.max = seen.max < 0 ? 0 : static_cast<std::size_t>(seen.max);
    });
}

/// Calls `work` with each part of the past whose samples may be seen in pixels from `first` to before `last`.
template <typename Work>
void Reprojection::forEachPartIn(std::size_t first, std::size_t last, Work&& work) const {
    for (const Part& part : parts_) {
        if (part.min < last && part.max >= first && part.min <= part.max) work(part);
    }
}

/// Each pixel gets the least entry of its samples.
void Reprojection::compete(const ImagePlane& plane, int firstRow, int lastRow) {
    const std::size_t width = rowLength(plane), first = firstPixel(plane, firstRow),
                      last = firstPixel(plane, lastRow), count = last - first;
    Band& band = bands_[static_cast<std::size_t>(firstRow / kRowsOfBand)];
    band.inside.clear();
    band.atEdge.clear();
    band.inside.reserve(count);
    band.atEdge.reserve(2 * width);
    std::array<std::uint32_t, kProjected + kMaxLanes> shown;
    std::array<std::uint32_t, kProjected + 1> lostHere;
    std::uint64_t* const nearest = &nearest_[first];
    std::fill_n(nearest, count, kNoSample);
    forEachPartIn(first, last, [&](const Part& part) {
        const std::int32_t* const pixels = &pixels_[0];
        const std::uint32_t* const keys = &keys_[0];
        std::size_t lost = 0;
        const std::size_t found = HWY_DYNAMIC_DISPATCH(samplesIn)(pixels + part.first, part.last - part.first,
                                                                  first, count, shown.data());
        for (std::size_t k = 0; k < found; ++k) {
            const std::size_t i = part.first + shown[k], pixel = pixelOf(pixels[i]) - first;
            // Without branches, which could not be foretold.
            const std::uint64_t before = nearest[pixel], entry = entryOf(keys[i], i);
            const std::uint64_t swap = (before ^ entry) & (0 - static_cast<std::uint64_t>(entry < before));
            nearest[pixel] = before ^ swap;
            lostHere[lost] = static_cast<std::uint32_t>(indexOf(entry ^ swap));
            lost += before != kNoSample ? 1U : 0U;
        }
        for (std::size_t k = 0; k < lost; ++k) {
            const std::size_t pixel = pixelOf(pixels_[lostHere[k]]) - first;
            const bool beside = pixel >= width && pixel + width < count;
            (beside ? band.inside : band.atEdge).push_back(lostHere[k]);
        }
    });
}

/// Samples drift within the grid of pixels, so that in time many pixels would get two and their neighbours
/// none. One of the two moves to the empty neighbour.
void Reprojection::spread(const ImagePlane& plane, const std::vector<std::uint32_t>& losers) {
    const auto row = static_cast<std::ptrdiff_t>(rowLength(plane));
    const std::ptrdiff_t neighbours[] = {-1, 1, -row, row};
    for (const std::uint32_t i : losers) {
        const std::size_t pixel = pixelOf(pixels_[i]);
        if ((keys_[i] >> 16) > depthOf(nearest_[pixel]) + kSameDepth) continue; // hidden
        const auto direction =
            static_cast<std::size_t>(static_cast<std::uint32_t>(pixels_[i]) >> kDirectionShift);
        std::uint64_t& beside = nearest_[pixel + static_cast<std::size_t>(neighbours[direction])];
        if (beside >= kBeside)
            beside = std::min(beside, kBeside | entryOf(staler(keys_[i], kBesideSteps), i));
    }
}

/// The entries of a row, in which pixels without a sample borrow the nearest one of their neighbours.
const std::uint64_t* Reprojection::shownIn(const ImagePlane& plane, int y) {
    std::vector<std::uint64_t>& row = rows_[static_cast<std::size_t>(threadNumber())];
    row.resize(rowLength(plane) + kMaxLanes);
    const auto rowAt = [&](int at) { return &nearest_[firstPixel(plane, std::clamp(at, -1, plane.height))]; };
    const std::uint64_t* const rows[] = {rowAt(y - 2), rowAt(y - 1), rowAt(y), rowAt(y + 1), rowAt(y + 2)};
    HWY_DYNAMIC_DISPATCH(borrowBeside)(rows, gaps_, static_cast<std::size_t>(plane.width), row.data());
    return row.data();
}

/// The pixels from `first` on, by the entries of their row.
void Reprojection::take(const LiveLayers& past, const std::uint64_t* nearest, LiveLayers& present,
                        std::size_t first, std::size_t last) {
    LiveSamples::Point* const points = &present.surface.points[first];
    LiveSamples::Light* const lights = &present.surface.lights[first];
    LiveSamples::Matter* const matter = present.updatesLight ? &present.surface.matter[first] : nullptr;
    std::uint32_t* const tints = present.mirrors ? &present.tints[first] : nullptr;
    float* const staleness = &staleness_[first];
    for (std::size_t i = 0; i < last - first; ++i) {
        fetch(past.surface, nearest[i + kAhead]);
        // Behind the last sample there is one that is not known.
        const std::size_t from = nearest[i] == kNoSample ? past.surface.size() : indexOf(nearest[i]);
        points[i] = aged(past.surface.points[from]);
        lights[i] = past.surface.lights[from];
        staleness[i] = stalenessOf(nearest[i]);
        if (matter != nullptr) matter[i] = past.surface.matter[from];
        if (tints != nullptr && LiveSamples::mirrors(points[i])) tints[i] = past.tints[from];
    }
}

void Reprojection::takeSpecular(const LiveSamples& past, const std::uint64_t* entries, LiveLayers& layers,
                                std::size_t first, std::size_t last) {
    const LiveSamples& surface = layers.surface;
    LiveSamples& present = layers.specular;
    for (std::size_t i = first; i < last; ++i) {
        const std::uint64_t nearest = entries[i - first];
        fetch(past, entries[i - first + kAhead]);
        // Without a branch: the sample behind the last is unknown.
        const bool known = (surface.mirrors(i) | !surface.known(i)) & (nearest != kNoSample);
        const std::size_t from = known ? indexOf(nearest) : past.size();
        present.points[i] = aged(past.points[from]);
        present.lights[i] = past.lights[from];
        const float stale = stalenessOf(nearest) + kStalerSpecular * static_cast<float>(present.age(i));
        staleness_[i] = std::max(staleness_[i], known ? stale : 0);
    }
}

void Reprojection::reproject(const LiveLayers& past, LiveLayers& present, int threads, const RowsDone& done) {
    const LiveSamples& surface = present.surface;
    const ImagePlane &before = past.surface.plane(), &now = surface.plane();
    gaps_ = now.parallel ? !now.shiftedFrom(before) : now.eye != before.eye;
    staleness_.resize(surface.size());
    const auto forEachRow = [&](auto&& work, bool last) {
        forEachRows(surface.plane().height, kRowsOfBand, threads, [&](int from, int to) {
            for (int y = from; y < to; ++y) work(y, surface.index(0, y), surface.index(0, y + 1));
            if (last) done(from, to);
        });
    };
    show(past.surface, surface.plane(), threads);
    forEachRow([&](int y, std::size_t row,
                   std::size_t next) { take(past, shownIn(surface.plane(), y), present, row, next); },
               !present.mirrors);
    if (!present.mirrors) return;
    show(past.specular, surface.plane(), threads);
    forEachRow(
        [&](int y, std::size_t row, std::size_t next) {
            takeSpecular(past.specular, shownIn(surface.plane(), y), present, row, next);
        },
        true);
}

/// Finds the sample of each pixel, but for those that borrow one.
void Reprojection::show(const LiveSamples& past, const ImagePlane& plane, int threads) {
    nearest_.resize(firstPixel(plane, plane.height + 1));
    std::fill_n(&nearest_[0], rowLength(plane), kNoSample);
    std::fill_n(&nearest_[firstPixel(plane, plane.height)], rowLength(plane), kNoSample);
    rows_.resize(std::max(rows_.size(), static_cast<std::size_t>(threads)));
    bands_.resize(static_cast<std::size_t>((plane.height + kRowsOfBand - 1) / kRowsOfBand));
    // An image of one row or column has no pixels on some sides of others.
    const bool spreads = plane.width > 1 && plane.height > 1;
    project(past, plane, threads);
    forEachRows(plane.height, kRowsOfBand, threads, [&](int first, int last) {
        compete(plane, first, last);
        if (spreads) spread(plane, bands_[static_cast<std::size_t>(first / kRowsOfBand)].inside);
    });
    if (!spreads) return;
    for (const Band& band : bands_) spread(plane, band.atEdge);
}

} // namespace rtcore
#endif

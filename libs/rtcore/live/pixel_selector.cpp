#include "rtcore/live/pixel_selector.h"

#include "rtcore/platform/parts.h"
#include "rtcore/sampling/sample_id.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/live/pixel_selector.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/live/live_samples-inl.h"

#ifndef RTCORE_LIVE_PIXEL_SELECTOR_TYPES
#define RTCORE_LIVE_PIXEL_SELECTOR_TYPES
namespace rtcore {

/// A row of pixels. Arrays begin at its first one, and have room for whole vectors.
struct PriorityRow {
    const float* luminance[3]; ///< of the row above, of itself, of the one below; can be read one before
    const float* staleness;
    std::size_t pixels;
    float dark;
    std::uint32_t* priority;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace {

/// -1 where a sample is missing.
void measureLuminanceOf(const LiveLayers& samples, std::size_t first, std::size_t count, float* to) {
    for (std::size_t i = 0; i < count; i += lanes()) {
        const Uint state = statesOf(samples.surface.points[first + i]);
        const Mask mirrors = (state & LiveSamples::kMirrors) != 0U;
        Float value =
            select(state != 0U, luminance<Float>(radianceOf(samples.surface.lights[first + i])), -1.0F);
        if (any(mirrors)) {
            const Mask seen = statesOf(samples.specular.points[first + i]) != 0U;
            const Float3 light =
                radianceOf(samples.specular.lights[first + i]) * tintOf(samples.tints[first + i]);
            value = select(mirrors, select(seen, value + luminance<Float>(light), -1.0F), value);
        }
        store(value, to + i);
    }
}

// Stale light shows beside light that differs.
constexpr float kStaleHole = 8;
constexpr float kMinStale = 0.02F, kMinContrast = 0.04F;

/// Priorities have four steps for each power of two, from 2^-14 on: the upper bits of a float.
constexpr int kPriorityShift = 21, kFirstPriority = (127 - 14) << 2;
constexpr int kMaxPriority = 127;

void measurePriorityOf(const PriorityRow& row) {
    for (std::size_t i = 0; i < row.pixels; i += lanes()) {
        const Float surface = load(row.luminance[1] + i);
        Float lowest = std::numeric_limits<float>::max(), highest = -1.0F;
        for (const float* const line : row.luminance) {
            for (const float* const at : {line + i - 1, line + i, line + i + 1}) {
                const Float there = load(at);
                highest = max(highest, there);
                lowest = min(lowest, select(there < 0.0F, lowest, there));
            }
        }
        const Float contrast = (highest - lowest) / (highest + lowest + row.dark);
        const Float stale = select(surface < 0.0F, Float(kStaleHole), load(row.staleness + i));
        const Float shows = (stale + kMinStale) * (contrast + kMinContrast);
        const Int step = toInt(shiftRight<kPriorityShift>(bitsOf(shows))) - kFirstPriority;
        const Float bounded = clamp(toFloat(step), 1.0F, static_cast<float>(kMaxPriority - 1));
        const Float priority = selectOrZero(stale > 0.0F, bounded);
        store(toUint(truncate(select(highest < 0.0F, static_cast<float>(kMaxPriority), priority))),
              row.priority + i);
    }
}

} // namespace

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(measureLuminanceOf);
HWY_EXPORT(measurePriorityOf);

namespace {

constexpr int kSquare = 32;       ///< pixels; those of one are traced together
constexpr std::size_t kRoom = 64; ///< no vector has more lanes
/// Turns by which a frame begins later than the one before: odd, and the golden section of all, so that no
/// pixel waits long.
constexpr std::uint32_t kTurnsApart = 2531;
/// Whether a pixel is among the `checks` of kTurns that are checked in that frame. Independent of its turn,
/// by which it may be selected as well: reversed digits of turnOf() are scattered anew.
bool isChecked(int x, int y, std::uint32_t number, std::uint32_t checks) {
    std::uint32_t left = turnOf(x, y), reversed = 0;
    for (std::uint32_t all = kTurns; all > 1; all /= 4, left /= 4) reversed = reversed * 4 + left % 4;
    return (reversed + number) * kTurnsApart % kTurns < checks;
}

constexpr double kCheckedPart = 1.0 / 16; ///< of those that are chosen, beside them

} // namespace

std::size_t PixelSelector::luminanceAt(const ImagePlane& plane, int y) {
    return kRoom + static_cast<std::size_t>(y) * (static_cast<std::size_t>(plane.width) + kRoom);
}

void PixelSelector::begin(const ImagePlane& plane) {
    luminance_.resize(luminanceAt(plane, plane.height));
    std::fill_n(luminance_.begin(), kRoom, -1.0F);
}

void PixelSelector::look(const LiveLayers& samples, int first, int last) {
    const ImagePlane& plane = samples.surface.plane();
    const auto length = static_cast<std::size_t>(plane.width);
    for (int y = first; y < last; ++y) {
        float* const to = &luminance_[luminanceAt(plane, y)];
        HWY_DYNAMIC_DISPATCH(measureLuminanceOf)(samples, samples.surface.index(0, y), length, to);
        std::fill_n(to + length, kRoom, -1.0F);
    }
}

std::span<const float> PixelSelector::luminances(const ImagePlane& plane, int y) const {
    return {&luminance_[luminanceAt(plane, y)], static_cast<std::size_t>(plane.width)};
}

void PixelSelector::traced(const ImagePlane& plane, int x, int y, float luminance) {
    luminance_[luminanceAt(plane, y) + static_cast<std::size_t>(x)] = luminance;
}

/// Luminance below which contrast is hardly seen: the mean over some pixels.
float PixelSelector::darkness(const ImagePlane& plane) const {
    constexpr float kOfMean = 1;
    constexpr int kStep = 8;
    double sum = 0;
    int count = 0;
    for (int y = 0; y < plane.height; y += kStep) {
        const std::size_t row = luminanceAt(plane, y);
        for (int x = 0; x < plane.width; x += kStep) {
            const float there = luminance_[row + static_cast<std::size_t>(x)];
            if (there < 0) continue;
            sum += static_cast<double>(there);
            ++count;
        }
    }
    return count > 0 ? kOfMean * static_cast<float>(sum / count) : 1;
}

void PixelSelector::measurePriority(const LiveSamples& samples, const PixelArray<float>& staleness,
                                    int threads) {
    const ImagePlane& plane = samples.plane();
    const auto length = static_cast<std::size_t>(plane.width);
    const float dark = darkness(plane);
    priority_.resize(samples.size());
    forEachRows(plane.height, kSquare, threads, [&](int first, int last) {
        Part& part = parts_[static_cast<std::size_t>(first / kSquare)];
        part.histogram = {};
        part.priority.resize(length + kRoom);
        for (int y = first; y < last; ++y) {
            const std::size_t at = samples.index(0, y);
            const auto row = [&](int which) { return &luminance_[luminanceAt(plane, which)]; };
            HWY_DYNAMIC_DISPATCH(measurePriorityOf)
            ({.luminance = {row(std::max(y - 1, 0)), row(y), row(std::min(y + 1, plane.height - 1))},
              .staleness = &staleness[at],
              .pixels = length,
              .dark = dark,
              .priority = part.priority.data()});
            for (std::size_t x = 0; x < length; ++x)
                priority_[at + x] = static_cast<std::uint8_t>(part.priority[x]);
            for (std::size_t x = 0; x < length; ++x) ++part.histogram[part.priority[x]];
        }
    });
}

/// All pixels above the bound are selected, and of those on it as many as fit, by turns.
PixelSelector::Bound PixelSelector::boundOf(const LiveSamples& samples, double fraction) {
    const auto countOf = [&](std::size_t priority) {
        double count = 0;
        for (const Part& part : parts_) count += static_cast<double>(part.histogram[priority]);
        return count;
    };
    const auto pixels = static_cast<double>(samples.size());
    unknown_ = countOf(kPriorities - 1) / pixels;
    double room = fraction * pixels;
    for (std::size_t priority = kPriorities - 1; priority > 0; --priority) {
        const double count = countOf(priority);
        if (count > room)
            return {.priority = priority,
                    .turns = static_cast<std::uint32_t>(std::lround(room / count * kTurns))};
        room -= count;
    }
    return {.priority = 1, .turns = kTurns};
}

void PixelSelector::collect(const ImagePlane& plane, const Bound& bound, std::uint32_t number, Part& part,
                            int first, int last) const {
    const auto turnsLeft = [number](int x, int y) { return (turnOf(x, y) + number * kTurnsApart) % kTurns; };
    std::array<bool, kSquare> checks = {}; // by row, whether some are checked there
    for (int y = first; y < last; ++y) {
        for (int x = 0; x < kTurnsSide; ++x)
            checks[static_cast<std::size_t>(y - first)] |= isChecked(x, y, number, bound.checks);
    }
    part.chosen.clear();
    part.checked.clear();
    for (int left = 0; left < plane.width; left += kSquare) {
        const int right = std::min(left + kSquare, plane.width);
        for (int y = first; y < last; ++y) {
            const std::uint8_t* const row =
                &priority_[static_cast<std::size_t>(y) * static_cast<std::size_t>(plane.width)];
            std::uint8_t highest = 0;
            for (int x = left; x < right; ++x) highest = std::max(highest, row[x]);
            const bool checksHere = checks[static_cast<std::size_t>(y - first)];
            if (highest < bound.priority && !checksHere) continue;
            for (int x = left; x < right; ++x) {
                const bool selected =
                    row[x] > bound.priority || (row[x] == bound.priority && turnsLeft(x, y) < bound.turns);
                const bool checked = checksHere && row[x] > 0 && isChecked(x, y, number, bound.checks);
                if (!selected && !checked) continue;
                if (checked) part.checked.push_back({part.chosen.size(), !selected});
                part.chosen.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0});
            }
        }
    }
}

void PixelSelector::choose(const LiveLayers& samples, const PixelArray<float>& staleness, double fraction,
                           std::uint32_t number, int threads) {
    const LiveSamples& surface = samples.surface;
    parts_.resize(static_cast<std::size_t>((surface.plane().height + kSquare - 1) / kSquare));
    measurePriority(surface, staleness, threads);
    Bound bound = boundOf(surface, fraction);
    bound.checks = static_cast<std::uint32_t>(std::lround(kCheckedPart * fraction * kTurns));
    forEachRows(surface.plane().height, kSquare, threads, [&](int first, int last) {
        Part& part = parts_[static_cast<std::size_t>(first / kSquare)];
        collect(surface.plane(), bound, number, part, first, last);
    });
    chosen_.clear();
    checked_.clear();
    for (const Part& part : parts_) {
        for (const Check& check : part.checked)
            checked_.push_back({chosen_.size() + check.chosen, check.blind});
        chosen_.insert(chosen_.end(), part.chosen.begin(), part.chosen.end());
    }
}

} // namespace rtcore
#endif

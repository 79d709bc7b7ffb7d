#include "rtcore/live/pixel_choice.h"

#include "rtcore/platform/parts.h"
#include "rtcore/sampling/sample_id.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/live/pixel_choice.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/live/live_samples-inl.h"

#ifndef RTCORE_LIVE_PIXEL_CHOICE_TYPES
#define RTCORE_LIVE_PIXEL_CHOICE_TYPES
namespace rtcore {

/// A row of pixels. Arrays begin at its first one, and have room for whole vectors.
struct UrgencyRow {
    const float* luminance[3]; ///< of the row above, of itself, of the one below; can be read one before
    const float* staleness;
    std::size_t pixels;
    float dark;
    std::uint32_t* urgency;
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
        const Uint state = statesOf(samples.own.points[first + i]);
        const Mask mirrors = (state & LiveSamples::kMirrors) != 0U;
        Float value = select(state != 0U, luminance<Float>(radianceOf(samples.own.lights[first + i])), -1.0F);
        if (any(mirrors)) {
            const Mask seen = statesOf(samples.mirrored.points[first + i]) != 0U;
            const Float3 light =
                radianceOf(samples.mirrored.lights[first + i]) * tintOf(samples.tints[first + i]);
            value = select(mirrors, select(seen, value + luminance<Float>(light), -1.0F), value);
        }
        store(value, to + i);
    }
}

// Stale light shows beside light that differs.
constexpr float kStaleHole = 8;
constexpr float kLeastStale = 0.02F, kLeastContrast = 0.04F;

/// Urgency has four steps for each power of two, from 2^-14 on: the upper bits of a float.
constexpr int kUrgencyShift = 21, kFirstUrgency = (127 - 14) << 2;
constexpr int kMostUrgent = 127;

void measureUrgencyOf(const UrgencyRow& row) {
    for (std::size_t i = 0; i < row.pixels; i += lanes()) {
        const Float own = load(row.luminance[1] + i);
        Float least = std::numeric_limits<float>::max(), most = -1.0F;
        for (const float* const line : row.luminance) {
            for (const float* const at : {line + i - 1, line + i, line + i + 1}) {
                const Float there = load(at);
                most = max(most, there);
                least = min(least, select(there < 0.0F, least, there));
            }
        }
        const Float contrast = (most - least) / (most + least + row.dark);
        const Float stale = select(own < 0.0F, Float(kStaleHole), load(row.staleness + i));
        const Float shows = (stale + kLeastStale) * (contrast + kLeastContrast);
        const Int step = toInt(shiftRight<kUrgencyShift>(bitsOf(shows))) - kFirstUrgency;
        const Float bounded = clamp(toFloat(step), 1.0F, static_cast<float>(kMostUrgent - 1));
        const Float urgency = selectOrZero(stale > 0.0F, bounded);
        store(toUint(truncate(select(most < 0.0F, static_cast<float>(kMostUrgent), urgency))),
              row.urgency + i);
    }
}

} // namespace

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(measureLuminanceOf);
HWY_EXPORT(measureUrgencyOf);

namespace {

constexpr int kSquare = 32;       ///< pixels; those of one are traced together
constexpr std::size_t kRoom = 64; ///< no vector has more lanes
/// From frame to frame: odd, and the golden section of all, so that no pixel waits long.
constexpr std::uint32_t kTurnsApart = 2531;
/// Whether a pixel is one of so many of kTurns that are checked in that frame: independently of its turn, by
/// which it may be chosen as well, since digits of turnOf() in reverse are scattered anew.
bool isChecked(int x, int y, std::uint32_t number, std::uint32_t checks) {
    std::uint32_t left = turnOf(x, y), reversed = 0;
    for (std::uint32_t all = kTurns; all > 1; all /= 4, left /= 4) reversed = reversed * 4 + left % 4;
    return (reversed + number) * kTurnsApart % kTurns < checks;
}

constexpr double kCheckedPart = 1.0 / 16; ///< of those that are chosen, beside them

} // namespace

std::size_t PixelChoice::luminanceAt(const ImagePlane& plane, int y) {
    return kRoom + static_cast<std::size_t>(y) * (static_cast<std::size_t>(plane.width) + kRoom);
}

void PixelChoice::begin(const ImagePlane& plane) {
    luminance_.resize(luminanceAt(plane, plane.height));
    std::fill_n(luminance_.begin(), kRoom, -1.0F);
}

void PixelChoice::look(const LiveLayers& samples, int first, int last) {
    const ImagePlane& plane = samples.own.plane();
    const auto length = static_cast<std::size_t>(plane.width);
    for (int y = first; y < last; ++y) {
        float* const to = &luminance_[luminanceAt(plane, y)];
        HWY_DYNAMIC_DISPATCH(measureLuminanceOf)(samples, samples.own.index(0, y), length, to);
        std::fill_n(to + length, kRoom, -1.0F);
    }
}

std::span<const float> PixelChoice::luminances(const ImagePlane& plane, int y) const {
    return {&luminance_[luminanceAt(plane, y)], static_cast<std::size_t>(plane.width)};
}

void PixelChoice::traced(const ImagePlane& plane, int x, int y, float luminance) {
    luminance_[luminanceAt(plane, y) + static_cast<std::size_t>(x)] = luminance;
}

/// A luminance beside which less contrast is seen: of the mean over some pixels.
float PixelChoice::darkness(const ImagePlane& plane) const {
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

void PixelChoice::measureUrgency(const LiveSamples& samples, const PixelArray<float>& staleness,
                                 int threads) {
    const ImagePlane& plane = samples.plane();
    const auto length = static_cast<std::size_t>(plane.width);
    const float dark = darkness(plane);
    urgency_.resize(samples.size());
    forEachRows(plane.height, kSquare, threads, [&](int first, int last) {
        Part& part = parts_[static_cast<std::size_t>(first / kSquare)];
        part.histogram = {};
        part.urgency.resize(length + kRoom);
        for (int y = first; y < last; ++y) {
            const std::size_t at = samples.index(0, y);
            const auto row = [&](int which) { return &luminance_[luminanceAt(plane, which)]; };
            HWY_DYNAMIC_DISPATCH(measureUrgencyOf)
            ({.luminance = {row(std::max(y - 1, 0)), row(y), row(std::min(y + 1, plane.height - 1))},
              .staleness = &staleness[at],
              .pixels = length,
              .dark = dark,
              .urgency = part.urgency.data()});
            for (std::size_t x = 0; x < length; ++x)
                urgency_[at + x] = static_cast<std::uint8_t>(part.urgency[x]);
            for (std::size_t x = 0; x < length; ++x) ++part.histogram[part.urgency[x]];
        }
    });
}

/// All above the bound are chosen, and of those on it as many as fit, by turns.
PixelChoice::Bound PixelChoice::boundOf(const LiveSamples& samples, double share) {
    const auto countOf = [&](std::size_t urgency) {
        double count = 0;
        for (const Part& part : parts_) count += static_cast<double>(part.histogram[urgency]);
        return count;
    };
    const auto pixels = static_cast<double>(samples.size());
    unknown_ = countOf(kUrgencies - 1) / pixels;
    double room = share * pixels;
    for (std::size_t urgency = kUrgencies - 1; urgency > 0; --urgency) {
        const double count = countOf(urgency);
        if (count > room)
            return {.urgency = urgency,
                    .turns = static_cast<std::uint32_t>(std::lround(room / count * kTurns))};
        room -= count;
    }
    return {.urgency = 1, .turns = kTurns};
}

void PixelChoice::collect(const ImagePlane& plane, const Bound& bound, std::uint32_t number, Part& part,
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
                &urgency_[static_cast<std::size_t>(y) * static_cast<std::size_t>(plane.width)];
            std::uint8_t most = 0;
            for (int x = left; x < right; ++x) most = std::max(most, row[x]);
            const bool checksHere = checks[static_cast<std::size_t>(y - first)];
            if (most < bound.urgency && !checksHere) continue;
            for (int x = left; x < right; ++x) {
                const bool urgent =
                    row[x] > bound.urgency || (row[x] == bound.urgency && turnsLeft(x, y) < bound.turns);
                const bool checked = checksHere && row[x] > 0 && isChecked(x, y, number, bound.checks);
                if (!urgent && !checked) continue;
                if (checked) part.checked.push_back({part.chosen.size(), !urgent});
                part.chosen.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0});
            }
        }
    }
}

void PixelChoice::choose(const LiveLayers& samples, const PixelArray<float>& staleness, double share,
                         std::uint32_t number, int threads) {
    const LiveSamples& own = samples.own;
    parts_.resize(static_cast<std::size_t>((own.plane().height + kSquare - 1) / kSquare));
    measureUrgency(own, staleness, threads);
    Bound bound = boundOf(own, share);
    bound.checks = static_cast<std::uint32_t>(std::lround(kCheckedPart * share * kTurns));
    forEachRows(own.plane().height, kSquare, threads, [&](int first, int last) {
        Part& part = parts_[static_cast<std::size_t>(first / kSquare)];
        collect(own.plane(), bound, number, part, first, last);
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

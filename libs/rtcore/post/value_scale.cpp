#include "rtcore/post/value_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace rtcore {

namespace {

constexpr std::size_t kScalePixels = 1U << 15; ///< pixels that are looked at
constexpr float kMinRange = 10, kMaxRange = 1e4F;
constexpr float kMinEnd = 1e-30F, kMaxEnd = 1e30F;
constexpr float kRoundTolerance = 1e-6F; ///< what is that near to a round number is one
constexpr std::array kRoundSteps{1.0, 2.0, 5.0};

/// The i-th round number: 0 is 1, 1 is 2, 3 is 10.
float roundNumber(int i) {
    const int decade = static_cast<int>(std::floor(i / 3.0));
    const double power = decade < 0 ? 1 / std::pow(10.0, -decade) : std::pow(10.0, decade);
    return static_cast<float>(kRoundSteps[static_cast<std::size_t>(i - 3 * decade)] * power);
}

/// That of the largest round number that is not above `value`.
int indexBelow(float value) {
    int i = 3 * static_cast<int>(std::floor(std::log10(value))) + 3;
    while (roundNumber(i) > value * (1 + kRoundTolerance)) --i;
    return i;
}

/// Wide enough and not too wide.
ValueScale widened(int from, int to) {
    bool up = true;
    while (roundNumber(to) < roundNumber(from) * (kMinRange * (1 - kRoundTolerance))) {
        up ? ++to : --from;
        up = !up;
    }
    while (roundNumber(to) > roundNumber(from) * (kMaxRange * (1 + kRoundTolerance))) ++from;
    return {roundNumber(from), roundNumber(to)};
}

/// 0, or what a scale can begin and end with.
float boundedEnd(float end) { return end > 0 ? std::clamp(end, kMinEnd, kMaxEnd) : 0; }

int roundIndex(float value, bool up) {
    const int below = indexBelow(value);
    return up && roundNumber(below) < value * (1 - kRoundTolerance) ? below + 1 : below;
}

} // namespace

LuminanceUnit shownUnit(const LuminanceUnit& unit, LightQuantity quantity) {
    constexpr float pi = std::numbers::pi_v<float>;
    return {.ofOne = quantity == LightQuantity::Illuminance ? pi * unit.ofOne : unit.ofOne,
            .absolute = unit.absolute};
}

float roundValue(float value, bool up) { return roundNumber(roundIndex(value, up)); }

bool isWide(const ValueScale& scale) { return scale.to > scale.from * (kMaxRange * (1 + kRoundTolerance)); }

std::vector<float> roundValues(const ValueScale& scale, std::size_t max) {
    const int first = roundIndex(scale.from, true), last = roundIndex(scale.to, false);
    for (int step = isWide(scale) ? 3 : 1;; step += step == 1 ? 2 : 3) {
        std::vector<float> values;
        for (int i = first; i <= last; ++i)
            if (step == 1 || i % step == 0) values.push_back(roundNumber(i));
        if (values.size() <= max) return values;
    }
}

std::optional<ValueScale> ScaleChoice::ofImage(const HdrImage& radiance, const LuminanceUnit& unit,
                                               bool hold) {
    const std::size_t step = std::max<std::size_t>(1, radiance.pixels.size() / kScalePixels);
    values_.clear();
    values_.reserve(2 * kScalePixels);
    for (std::size_t i = step / 2; i < radiance.pixels.size(); i += step) {
        const float value = luminance(radiance.pixels[i]) * unit.ofOne;
        if (value > kMinEnd && value < kMaxEnd) values_.push_back(value);
    }
    if (values_.empty()) return std::nullopt;
    const auto lowAt = static_cast<std::ptrdiff_t>(values_.size() / 100);
    const auto highAt = static_cast<std::ptrdiff_t>(values_.size()) - 1 - lowAt;
    std::ranges::nth_element(values_, values_.begin() + lowAt);
    const float low = values_[static_cast<std::size_t>(lowAt)];
    std::ranges::nth_element(values_, values_.begin() + highAt);
    const float high = values_[static_cast<std::size_t>(highAt)];
    const ValueScale own = widened(roundIndex(low, false), roundIndex(high, true));
    constexpr float kRoughly = 1.25F, kTooWide = 5;
    if (hold && before_ && unitBefore_ == unit) {
        const bool within = low * kRoughly >= before_->from && high <= before_->to * kRoughly;
        const bool near = own.from <= before_->from * kTooWide && own.to * kTooWide >= before_->to;
        if (within && near) return before_;
    }
    return own;
}

ValueScale ScaleChoice::choose(const HdrImage& radiance, const FalseColourSettings& settings,
                               const LuminanceUnit& ofLuminance, bool hold) {
    const LuminanceUnit unit = shownUnit(ofLuminance, settings.quantity);
    const float from = boundedEnd(settings.from), to = boundedEnd(settings.to);
    if (from > 0 && to > from) return {from, to};
    ValueScale scale = ofImage(radiance, unit, hold).value_or(ValueScale{});
    before_ = scale;
    unitBefore_ = unit;
    // Of two ends that contradict each other none is given.
    if (from > 0 && to > 0) return scale;
    if (from > 0) scale = {from, std::max(scale.to, from * kMinRange)};
    if (to > 0) scale = {std::min(scale.from, to / kMinRange), to};
    return scale;
}

} // namespace rtcore

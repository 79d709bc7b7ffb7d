#include "rtcore/motion/monotone_track.h"

#include <algorithm>
#include <cstddef>

namespace rtcore {

namespace {

/// At a key, by the slopes before and behind it and how long these last.
double slopeBetween(double before, double after, double lasting, double then) {
    if (!(before * after > 0)) return 0;
    const double a = lasting + 2 * then, b = 2 * lasting + then;
    return (a + b) / (b / before + a / after);
}

} // namespace

MonotoneTrack::MonotoneTrack(std::span<const double> times, std::span<const double> values, bool periodic) {
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!keys_.empty() && !(times[i] > keys_.back().time)) keys_.pop_back();
        keys_.push_back({times[i], values[i], 0});
    }
    const auto lasts = [&](std::size_t i) { return keys_[i + 1].time - keys_[i].time; };
    const auto secant = [&](std::size_t i) { return (keys_[i + 1].value - keys_[i].value) / lasts(i); };
    const std::size_t segments = keys_.size() - 1;
    for (std::size_t i = 1; i < segments; ++i)
        keys_[i].slope = slopeBetween(secant(i - 1), secant(i), lasts(i - 1), lasts(i));
    if (periodic && segments > 0)
        keys_.front().slope = keys_.back().slope =
            slopeBetween(secant(segments - 1), secant(0), lasts(segments - 1), lasts(0));
}

double MonotoneTrack::at(double time) const {
    const auto next = std::upper_bound(keys_.begin(), keys_.end(), time,
                                       [](double wanted, const Key& key) { return wanted < key.time; });
    if (next == keys_.begin()) return keys_.front().value;
    if (next == keys_.end()) return keys_.back().value;
    const Key &from = *(next - 1), &to = *next;
    const double lasts = to.time - from.time, t = (time - from.time) / lasts, rest = 1 - t;
    return from.value * (rest * rest * (1 + 2 * t)) + to.value * (t * t * (1 + 2 * rest)) +
           (from.slope * rest - to.slope * t) * (lasts * t * rest);
}

} // namespace rtcore

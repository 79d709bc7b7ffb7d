#include "common/flights/film_exposure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace app {

namespace {

constexpr int kOfTurntable = 12, kMax = 61, kMin = 9;

double root16(double value) { return std::sqrt(std::sqrt(std::sqrt(std::sqrt(value)))); }

double power16(double value) {
    for (int i = 0; i < 4; ++i) value *= value;
    return value;
}

double weightOf(double seconds) {
    const double off = seconds / FilmExposure::kAdaptation;
    return 1 / ((1 + off * off) * (1 + off * off));
}

/// Seconds between two times; of what goes round the shorter way.
double between(double a, double b, const rtcore::FlightCourse& course) {
    const double off = std::abs(a - b);
    return course.goesRound() ? std::min(off, std::abs(course.seconds() - off)) : off;
}

/// A weighted mean of all roots.
double adapted(double time, std::span<const MeasuredExposure> measured, const rtcore::FlightCourse& course) {
    double sum = 0, weights = 0;
    for (const MeasuredExposure& each : measured) {
        const double weight = course.isTurntable() ? 1 : weightOf(between(time, each.time, course));
        sum += weight * root16(double{each.constant});
        weights += weight;
    }
    return sum / weights;
}

rtcore::MonotoneTrack trackOf(std::span<const MeasuredExposure> measured,
                              const rtcore::FlightCourse& course) {
    std::vector<double> times, roots;
    for (const MeasuredExposure& each : measured) {
        times.push_back(each.time);
        roots.push_back(adapted(each.time, measured, course));
    }
    const bool round = course.goesRound();
    if (round) {
        times.push_back(times.front() + course.seconds());
        roots.push_back(roots.front());
    }
    return {times, roots, round};
}

} // namespace

std::vector<int> framesToMeasure(const rtcore::FlightCourse& course, int frames) {
    const int wanted =
        course.isTurntable()
            ? kOfTurntable
            : std::clamp(static_cast<int>(std::min(course.seconds(), double{kMax})) + 1, kMin, kMax);
    const int count = std::min(wanted, frames);
    std::vector<int> chosen;
    for (int i = 0; i < count; ++i) {
        // What goes round comes back to its first frame after the last one.
        const std::int64_t steps = course.goesRound() || count == 1 ? count : count - 1;
        const std::int64_t last = course.goesRound() || count == 1 ? frames : frames - 1;
        chosen.push_back(static_cast<int>(i * last / steps));
    }
    return chosen;
}

FilmExposure::FilmExposure(std::span<const MeasuredExposure> measured, const rtcore::FlightCourse& course)
    : track_(trackOf(measured, course)) {}

float FilmExposure::at(double time) const { return static_cast<float>(power16(track_.at(time))); }

} // namespace app

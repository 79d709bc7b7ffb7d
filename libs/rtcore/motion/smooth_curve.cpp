#include "rtcore/motion/smooth_curve.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

/// The derivative at the middle one of three points, by a parameter that grows with the root of distances.
Vec3d tangent(Vec3d before, Vec3d here, Vec3d after) {
    const double a = std::sqrt(length(here - before)), b = std::sqrt(length(after - here));
    return (here - before) * (1 / a) - (after - before) * (1 / (a + b)) + (after - here) * (1 / b);
}

/// The derivative at the end of an open curve: as a parabola through it has, that has `inner` at the next
/// point.
Vec3d endTangent(Vec3d from, Vec3d to, Vec3d inner) {
    return (to - from) * (2 / std::sqrt(length(to - from))) - inner;
}

/// How far a cubic from 0 to 1 with these slopes goes beyond its ends: below 0, and above 1.
std::array<double, 2> overshoots(double leaving, double arriving) {
    const auto value = [&](double t) {
        return leaving * (t * (1 - t) * (1 - t)) + t * t * (3 - 2 * t) - arriving * (t * t * (1 - t));
    };
    // Where the derivative a t^2 + b t + c is zero.
    const double a = 3 * (leaving + arriving) - 6, b = 6 - 4 * leaving - 2 * arriving, c = leaving;
    std::array<double, 2> result{0, 0};
    const auto look = [&](double t) {
        if (!(t > 0 && t < 1)) return;
        result[0] = std::max(result[0], -value(t));
        result[1] = std::max(result[1], value(t) - 1);
    };
    const double root = b * b - 4 * a * c;
    if (root < 0) return result;
    // Both roots without the difference of numbers that are nearly equal.
    const double q = -0.5 * (b + std::copysign(std::sqrt(root), b));
    look(q / a);
    look(c / q);
    return result;
}

/// Gauss-Legendre quadrature with five points (Abramowitz and Stegun, 25.4.30).
template <typename Speed>
double integral(double from, double to, Speed speed) {
    constexpr std::array<double, 3> kAt{0, 0.53846931010568309, 0.90617984593866399};
    constexpr std::array<double, 3> kWeight{0.56888888888888889, 0.47862867049936647, 0.23692688505618909};
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double sum = kWeight[0] * speed(middle);
    for (std::size_t i = 1; i < kAt.size(); ++i)
        sum += kWeight.at(i) * (speed(middle - half * kAt.at(i)) + speed(middle + half * kAt.at(i)));
    return sum * half;
}

} // namespace

Vec3d SmoothCurve::Segment::at(double t) const {
    const double rest = 1 - t;
    return from * (rest * rest * (1 + 2 * t)) + leaving * (t * rest * rest) + to * (t * t * (1 + 2 * rest)) -
           arriving * (t * t * rest);
}

Vec3d SmoothCurve::Segment::slope(double t) const {
    const double rest = 1 - t;
    return (to - from) * (6 * t * rest) + leaving * (rest * (1 - 3 * t)) + arriving * (t * (3 * t - 2));
}

void SmoothCurve::shorten(Segment& segment) {
    constexpr int kSteps = 60;
    constexpr double kStep = 0.85;
    const Vec3d chord = segment.to - segment.from;
    const double square = dot(chord, chord);
    for (int i = 0; i < kSteps; ++i) {
        const auto [below, above] =
            overshoots(dot(segment.leaving, chord) / square, dot(segment.arriving, chord) / square);
        if (below <= kMaxOvershoot && above <= kMaxOvershoot) return;
        if (below > kMaxOvershoot) segment.leaving = segment.leaving * kStep;
        if (above > kMaxOvershoot) segment.arriving = segment.arriving * kStep;
    }
}

void SmoothCurve::measure(Segment& segment) {
    const auto speed = [&](double t) { return rtcore::length(segment.slope(t)); };
    for (std::size_t i = 0; i < kParts; ++i) {
        const double from = static_cast<double>(i) / kParts, to = static_cast<double>(i + 1) / kParts;
        segment.lengths.at(i + 1) = segment.lengths.at(i) + integral(from, to, speed);
    }
}

SmoothCurve::SmoothCurve(std::span<const Vec3d> points, bool closed) : first_(points[0]), begins_{0} {
    const std::size_t count = points.size();
    const auto tangentAt = [&](std::size_t i) {
        if (closed) return tangent(points[(i + count - 1) % count], points[i], points[(i + 1) % count]);
        const auto inner = [&](std::size_t j) { return tangent(points[j - 1], points[j], points[j + 1]); };
        if (i > 0 && i + 1 < count) return inner(i);
        const Vec3d straight =
            (points[1] - points[0]) * (1 / std::sqrt(rtcore::length(points[1] - points[0])));
        if (count == 2) return straight;
        return i == 0 ? endTangent(points[0], points[1], inner(1))
                      : endTangent(points[i - 1], points[i], inner(i - 1));
    };
    for (std::size_t i = 0; i < (closed ? count : count - 1); ++i) {
        const std::size_t next = (i + 1) % count;
        Segment segment{.from = points[i], .to = points[next], .leaving = {}, .arriving = {}};
        const double parameter = std::sqrt(rtcore::length(segment.to - segment.from));
        segment.leaving = tangentAt(i) * parameter;
        segment.arriving = tangentAt(next) * parameter;
        shorten(segment);
        measure(segment);
        segments_.push_back(segment);
        begins_.push_back(begins_.back() + segment.lengths.back());
    }
}

Vec3d SmoothCurve::at(double along) const {
    if (segments_.empty() || !(along > 0)) return first_;
    if (along >= length()) return segments_.back().to;
    const auto next = std::upper_bound(begins_.begin(), begins_.end(), along);
    const auto index = static_cast<std::size_t>(next - begins_.begin()) - 1;
    const Segment& segment = segments_[index];
    const double wanted = along - begins_[index];
    if (wanted <= 0) return segment.from;
    const auto part = std::upper_bound(segment.lengths.begin(), segment.lengths.end() - 1, wanted);
    const auto i = static_cast<std::size_t>(part - segment.lengths.begin()) - 1;
    const double low = static_cast<double>(i) / kParts, high = static_cast<double>(i + 1) / kParts;
    const double left = wanted - segment.lengths.at(i),
                 whole = segment.lengths.at(i + 1) - segment.lengths.at(i);
    const auto speed = [&](double t) { return rtcore::length(segment.slope(t)); };
    // By Newton's steps, between bounds.
    double t = whole > 0 ? low + (high - low) * (left / whole) : low, lower = low, upper = high;
    constexpr int kSteps = 8;
    for (int step = 0; step < kSteps; ++step) {
        const double off = integral(low, t, speed) - left;
        (off > 0 ? upper : lower) = t;
        const double slope = speed(t);
        const double better = slope > 0 ? t - off / slope : lower;
        t = better >= lower && better <= upper ? better : 0.5 * (lower + upper);
    }
    return segment.at(t);
}

} // namespace rtcore

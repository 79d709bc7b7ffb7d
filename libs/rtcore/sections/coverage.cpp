#include "rtcore/sections/coverage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rtcore {

namespace {

/// Where the line from a to b has this x.
FlatPoint atColumn(const FlatPoint& a, const FlatPoint& b, double x) {
    return {x, a[1] + (b[1] - a[1]) * ((x - a[0]) / (b[0] - a[0]))};
}

} // namespace

Coverage::Coverage(int width, int height)
    : width_(width), height_(height), stride_(static_cast<std::size_t>(width) + 2),
      sums_(stride_ * static_cast<std::size_t>(height)) {
    forget();
}

void Coverage::forget() {
    left_ = width_;
    right_ = 0;
    top_ = height_;
    bottom_ = 0;
}

Coverage::Area Coverage::area() const { return {left_, top_, right_, bottom_}; }

float Coverage::clampedPart(float sum) {
    constexpr float kNothing = 1e-3F; // what sums of floats are off
    const float part = std::min(std::fabs(sum), 1.0F);
    return part > kNothing ? part : 0;
}

void Coverage::add(std::span<const FlatPoint> loop) {
    const auto finite = [](const FlatPoint& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); };
    if (!std::ranges::all_of(loop, finite)) return;
    for (std::size_t i = 0; i < loop.size(); ++i) addLine(loop[i], loop[(i + 1) % loop.size()]);
}

/// What is left of the image counts at its edge, what is right of it not at all.
void Coverage::addLine(FlatPoint a, FlatPoint b) {
    const double right = width_;
    if (a[1] == b[1] || std::min(a[0], b[0]) >= right) return;
    if (std::max(a[0], b[0]) <= 0) return addInside({0, a[1]}, {0, b[1]});
    for (const double edge : {0.0, right}) {
        if (std::min(a[0], b[0]) >= edge || std::max(a[0], b[0]) <= edge) continue;
        const FlatPoint middle = atColumn(a, b, edge);
        addLine(a, {edge, middle[1]});
        addLine({edge, middle[1]}, b);
        return;
    }
    addInside(a, b);
}

void Coverage::addInside(FlatPoint a, FlatPoint b) {
    const double sign = a[1] < b[1] ? 1 : -1;
    if (sign < 0) std::swap(a, b);
    const double slope = (b[0] - a[0]) / (b[1] - a[1]);
    const double from = std::max(a[1], 0.0), to = std::min(b[1], static_cast<double>(height_));
    if (!(from < to)) return;
    const auto columnAt = [&](double y) {
        return std::clamp(a[0] + slope * (y - a[1]), 0.0, static_cast<double>(width_));
    };
    const int first = static_cast<int>(from), end = static_cast<int>(std::ceil(to));
    top_ = std::min(top_, first);
    bottom_ = std::max(bottom_, end);
    left_ = std::min(left_, static_cast<int>(std::min(a[0], b[0])));
    right_ = std::max(right_, std::min(width_, static_cast<int>(std::max(a[0], b[0])) + 1));
    for (int y = first; y < end; ++y) {
        const double upper = std::max(from, static_cast<double>(y)), lower = std::min(to, y + 1.0);
        addRow(y, sign * (lower - upper), columnAt(upper), columnAt(lower));
    }
}

/// A piece of a line within one row: all pixels to the right of it get `height`, those under it the part of
/// it that is to its right.
void Coverage::addRow(int y, double height, double x0, double x1) {
    float* const row = sums_.data() + static_cast<std::size_t>(y) * stride_;
    const auto [left, right] = std::minmax(x0, x1);
    const int first = static_cast<int>(left);
    const int last = std::max(first, static_cast<int>(std::ceil(right)) - 1);
    for (int x = first; x <= last; ++x) {
        // The part of the line within the pixel, and its mean distance from the pixel's right edge.
        const double a = std::max(left, static_cast<double>(x)), b = std::min(right, x + 1.0);
        const double part = first == last ? height : height * (b - a) / (right - left);
        const double covered = part * (x + 1 - (a + b) / 2);
        row[x] += static_cast<float>(covered);
        row[x + 1] += static_cast<float>(part - covered);
    }
}

} // namespace rtcore

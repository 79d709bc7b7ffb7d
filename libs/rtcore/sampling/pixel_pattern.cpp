#include "rtcore/sampling/pixel_pattern.h"

#include "rtcore/sampling/poisson_disc.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr float kBelowOne = 1 - 0x1p-24F;

SquarePoint gridPoint(int column, int row, int n, SquarePoint inCell) {
    const auto side = static_cast<float>(n);
    return {std::min((static_cast<float>(column) + inCell.u) / side, kBelowOne),
            std::min((static_cast<float>(row) + inCell.v) / side, kBelowOne)};
}

template <typename Point>
std::vector<SquarePoint> pointsOfCells(int n, Point&& point) {
    std::vector<SquarePoint> points;
    points.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) points.push_back(point(column, row));
    }
    return points;
}

std::vector<SquarePoint> sharedPoints(SamplingPattern pattern, int n) {
    switch (pattern) {
    case SamplingPattern::Grid:
        return pointsOfCells(n, [n](int i, int k) { return gridPoint(i, k, n, {0.5F, 0.5F}); });
    case SamplingPattern::Rotated:
        return pointsOfCells(n, [n](int i, int k) { return rotatedGridPoint(i, k, n); });
    case SamplingPattern::Poisson:
        return poissonDisc(n * n);
    case SamplingPattern::Random:
    case SamplingPattern::Jittered:
        return {};
    }
    return {};
}

} // namespace

SquarePoint rotatedGridPoint(int column, int row, int n) {
    const auto side = static_cast<float>(n);
    return gridPoint(
        column, row, n,
        {(static_cast<float>(row) + 0.5F) / side, (static_cast<float>(n - 1 - column) + 0.5F) / side});
}

void PixelPattern::prepare(SamplingPattern pattern, int n) {
    if (pattern_ == pattern && n_ == n) return;
    points_ = sharedPoints(pattern, n);
    pattern_ = pattern;
    n_ = n;
}

SquarePoint PixelPattern::at(SampleId id) const {
    const int sub = static_cast<int>(id.sub);
    switch (pattern_) {
    case SamplingPattern::Grid:
    case SamplingPattern::Rotated:
        return points_[id.sub];
    case SamplingPattern::Random:
        return randomShift(id, SampleDimension::Position);
    case SamplingPattern::Jittered:
        return gridPoint(sub % n_, sub / n_, n_, randomShift(id, SampleDimension::Position));
    case SamplingPattern::Poisson: {
        const SquarePoint shift = randomShift({id.x, id.y, 0}, SampleDimension::Position);
        return {wrapped(points_[id.sub].u, shift.u), wrapped(points_[id.sub].v, shift.v)};
    }
    }
    return {};
}

} // namespace rtcore

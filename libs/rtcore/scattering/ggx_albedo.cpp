#include "rtcore/scattering/ggx_albedo.h"

#include "rtcore/scattering/ggx.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rtcore {

namespace {

/// A point of the unit disc, and the area that it stands for, as a fraction.
struct DiscPoint {
    double x, y;
    double height; ///< of the sphere's point above (x, 0)
    double weight;
};

constexpr int kDiscPoints = 610; ///< a number of Fibonacci

/// A lattice in angles: on the sphere over the disc, rings lie close where facets are steep.
std::array<DiscPoint, kDiscPoints> discPoints() {
    std::array<DiscPoint, kDiscPoints> points;
    double total = 0;
    for (int i = 0; i < kDiscPoints; ++i) {
        const double ring = 90 * (i + 0.5) / kDiscPoints;
        const double turn = 360.0 * (i * 377 % kDiscPoints) / kDiscPoints;
        const double radius = portableSinOfDegrees(ring);
        const double x = radius * portableCosOfDegrees(turn), y = radius * portableSinOfDegrees(turn);
        points[static_cast<std::size_t>(i)] = {x, y, std::sqrt(1 - x * x),
                                               radius * portableCosOfDegrees(ring)};
        total += radius * portableCosOfDegrees(ring);
    }
    for (DiscPoint& p : points) p.weight /= total;
    return points;
}

struct Albedo {
    double straight = 0, grazing = 0;
};

/// The mean of G2 / G1 over the facets that the viewer sees, those of sampleFacet() in ggx-inl.h.
Albedo albedoOf(double cosine, double alpha, const std::array<DiscPoint, kDiscPoints>& points) {
    const double square = alpha * alpha;
    const auto root = [&](double c) { return std::sqrt(square + (1 - square) * c * c); };
    const double sine = std::sqrt(1 - cosine * cosine), viewerRoot = root(cosine);
    // The viewer in the stretched surface is (x, 0, z); across it are (0, 1, 0) and (-z, 0, x).
    const double length = std::sqrt(square * sine * sine + cosine * cosine);
    const double x = alpha * sine / length, z = cosine / length;
    const double seen = (1 + z) / 2;
    Albedo sum;
    for (const DiscPoint& p : points) {
        const double along = (1 - seen) * p.height + seen * p.y;
        const double out = std::sqrt(std::max(0.0, 1 - p.x * p.x - along * along));
        const double fx = alpha * (x * out - z * along), fy = alpha * p.x;
        const double fz = std::max(0.0, x * along + z * out);
        const double facet = std::sqrt(fx * fx + fy * fy + fz * fz);
        const double half = (sine * fx + cosine * fz) / facet; // cosine of the viewer with the facet
        const double light = 2 * half * (fz / facet) - cosine;
        if (light <= 0) continue;
        const double passing =
            p.weight * (viewerRoot + cosine) * light / (viewerRoot * light + root(light) * cosine);
        const double rest = 1 - half;
        const double fresnel = rest * rest * rest * rest * rest;
        sum.straight += passing * (1 - fresnel);
        sum.grazing += passing * fresnel;
    }
    return sum;
}

/// The integral of 2 c E(c) over the cosines c, where E is linear in the square root of c between the columns
/// of a row, as ggxAlbedo() has it: 4 r^3 E over the roots r.
double meanOfRow(const GgxAlbedoTable& table, int row) {
    constexpr int kSteps = kGgxAlbedoSide - 1;
    const auto albedo = [&](int column) {
        const int at = row * kGgxAlbedoSide + column;
        return double{table.straight[at]} + double{table.grazing[at]};
    };
    double sum = 0;
    for (int column = 0; column < kSteps; ++column) {
        const double from = static_cast<double>(column) / kSteps;
        const double to = static_cast<double>(column + 1) / kSteps;
        const double slope = (albedo(column + 1) - albedo(column)) * kSteps;
        const double fourth = to * to * to * to - from * from * from * from;
        const double fifth = to * to * to * to * to - from * from * from * from * from;
        sum += (albedo(column) - slope * from) * fourth + slope * 0.8 * fifth;
    }
    return sum;
}

GgxAlbedoTable madeTable() {
    const std::array<DiscPoint, kDiscPoints> points = discPoints();
    GgxAlbedoTable table;
    for (int row = 0; row < kGgxAlbedoSide; ++row) {
        const double roughness = static_cast<double>(row) / (kGgxAlbedoSide - 1);
        const double alpha = std::max(roughness * roughness, static_cast<double>(kMinAlpha));
        for (int column = 0; column < kGgxAlbedoSide; ++column) {
            const double root = static_cast<double>(column) / (kGgxAlbedoSide - 1);
            const Albedo albedo = albedoOf(root * root, alpha, points);
            table.straight[row * kGgxAlbedoSide + column] = static_cast<float>(albedo.straight);
            table.grazing[row * kGgxAlbedoSide + column] = static_cast<float>(albedo.grazing);
        }
        table.mean[row] = static_cast<float>(meanOfRow(table, row));
    }
    return table;
}

} // namespace

const GgxAlbedoTable& ggxAlbedoTable() {
    static const GgxAlbedoTable table = madeTable();
    return table;
}

} // namespace rtcore

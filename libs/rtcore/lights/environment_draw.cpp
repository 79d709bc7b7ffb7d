#include "rtcore/lights/environment_draw.h"

#include "rtcore/lights/brightest_cells.h"
#include "rtcore/lights/environment_draw-inl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

namespace rtcore {

namespace {

namespace plain = HWY_NAMESPACE;

constexpr int kLeastSide = 64, kMostSide = 2048;
/// Of the mean luminance: cells count as at least that bright, so that rays in all directions have a density.
constexpr double kLeastBrightness = 1e-3;

/// At most as many cells as there are texels, but for small images.
int sideFor(const BackgroundLight& light) {
    if (light.environment == nullptr) return kLeastSide;
    double texels = 0;
    for (const HdrImage& image : light.environment->images())
        texels += static_cast<double>(image.width - 2) * (image.height - 2);
    const auto side = static_cast<unsigned>(std::min<double>(std::sqrt(texels), kMostSide));
    return std::max(static_cast<int>(std::bit_floor(side)), kLeastSide);
}

/// Times the solid angles of the cells, but for a common factor.
std::vector<double> weightsOf(const std::vector<float>& brightness, int side, double least) {
    std::vector<double> weights;
    weights.reserve(brightness.size());
    const float step = 1 / static_cast<float>(side);
    std::size_t i = 0;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column, ++i) {
            const Vec3 middle = plain::octahedronDirection<float>((static_cast<float>(column) + 0.5F) * step,
                                                                  (static_cast<float>(row) + 0.5F) * step);
            const auto square = static_cast<double>(dot(middle, middle));
            const double solidAngle = 1 / (square * std::sqrt(square));
            weights.push_back(std::max(static_cast<double>(brightness[i]), least) * solidAngle);
        }
    }
    return weights;
}

std::vector<float> brightnessOf(const BackgroundLight& light, int side) {
    if (light.environment != nullptr)
        return brightestAround(brightestInCells(*light.environment, side), side);
    return std::vector<float>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 1.0F);
}

} // namespace

void EnvironmentDraw::prepare(const BackgroundLight& light) {
    *this = {};
    const auto mean = static_cast<double>(luminance(light.mean()));
    if (!(mean > 0) || !std::isfinite(mean)) return;
    side_ = sideFor(light);
    sideBits_ = std::countr_zero(static_cast<unsigned>(side_));
    scalarIrradiance_ = 4 * std::numbers::pi * mean;
    const double scale =
        light.environment != nullptr ? static_cast<double>(light.environment->intensity) : mean;
    table_ = AliasTable(weightsOf(brightnessOf(light, side_), side_, kLeastBrightness * mean / scale));
}

DrawnDirection EnvironmentDraw::draw(SquarePoint point, std::uint32_t bits) const {
    const auto drawn = plain::drawEnvironment<float>(rows(), point.u, point.v, bits);
    return {drawn.direction, drawn.density};
}

float EnvironmentDraw::density(Vec3 direction) const {
    return empty() ? 0.0F : plain::environmentDensity<float>(rows(), direction);
}

} // namespace rtcore

#include "rtcore/scene/environment_light.h"

#include "rtcore/math/constants.h"
#include "rtcore/math/octahedron-inl.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

constexpr int kSide = 64;
constexpr std::size_t kTexels = std::size_t{kSide} * kSide;
/// Steps each way between normals. They lie on the octahedron's edges, too, where its image has a crease.
constexpr int kSteps = 32;
constexpr int kStride = kSteps + 1;
/// Times the mean luminance: brighter texels are spread.
constexpr double kMax = 4;
/// Half-angles of the cones, in degrees, one after another while there are such texels.
constexpr double kCones[] = {5, 10, 20, 40, 80};
constexpr float kMaxCorrection = 2;

/// Light from a part of all directions, in double so that nothing depends on how it is added up.
struct Energy {
    double r = 0, g = 0, b = 0; ///< radiance times solid angle

    void add(const Energy& e, double part) {
        r += e.r * part;
        g += e.g * part;
        b += e.b * part;
    }
    double luminance() const {
        return static_cast<double>(kLuminance.r) * r + static_cast<double>(kLuminance.g) * g +
               static_cast<double>(kLuminance.b) * b;
    }
    Colour colour(double scale) const {
        return {static_cast<float>(r * scale), static_cast<float>(g * scale), static_cast<float>(b * scale)};
    }
};

struct Texel {
    Energy energy;
    Vec3d towards; ///< where its light comes from on the mean, times 1 or a little less
};

Vec3d unitOf(Vec3d d) { return d / std::sqrt(dot(d, d)); }

Vec3d middleOf(int column, int row) {
    return HWY_NAMESPACE::octahedronDirection<double>((column + 0.5) / kSide, (row + 0.5) / kSide);
}

/// The solid angle of each texel; all of them sum to 4 pi. A face of the octahedron lies 1 / sqrt(3) away,
/// and its area is sqrt(3) times that of the square it unfolds to.
std::vector<double> solidAngles() {
    std::vector<double> angles;
    double sum = 0;
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            const Vec3d d = middleOf(column, row);
            const double square = dot(d, d);
            angles.push_back(1 / (square * std::sqrt(square)));
            sum += angles.back();
        }
    }
    for (double& angle : angles) angle *= 4 * static_cast<double>(kPi) / sum;
    return angles;
}

std::vector<Vec3d> middles() {
    std::vector<Vec3d> directions;
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) directions.push_back(unitOf(middleOf(column, row)));
    }
    return directions;
}

/// The cells by texel. What falls into one counts as if it came from all of its solid angle.
std::vector<Texel> gather(std::span<const EnvironmentCell> cells, const std::vector<double>& angles) {
    struct Sum {
        Energy energy;
        Vec3d moment;
        double solidAngle = 0, luminance = 0;
        Vec3d middle;
    };
    std::vector<Sum> sums(kTexels);
    for (const EnvironmentCell& cell : cells) {
        Sum& sum =
            sums[static_cast<std::size_t>(HWY_NAMESPACE::octahedronTexel<float>(cell.direction, kSide))];
        const double angle = static_cast<double>(cell.solidAngle);
        const Vec3d direction{cell.direction.x, cell.direction.y, cell.direction.z};
        const Energy energy{static_cast<double>(cell.radiance.r), static_cast<double>(cell.radiance.g),
                            static_cast<double>(cell.radiance.b)};
        const double luminance = energy.luminance() * angle;
        sum.energy.add(energy, angle);
        sum.moment = sum.moment + direction * luminance;
        sum.middle = sum.middle + direction * angle;
        sum.luminance += luminance;
        sum.solidAngle += angle;
    }
    std::vector<Texel> texels(kTexels);
    for (std::size_t i = 0; i < kTexels; ++i) {
        const Sum& sum = sums[i];
        if (!(sum.solidAngle > 0)) continue;
        texels[i].energy.add(sum.energy, angles[i] / sum.solidAngle);
        texels[i].towards = sum.luminance > 0 ? sum.moment / sum.luminance : sum.middle / sum.solidAngle;
    }
    return texels;
}

/// Spreads what exceeds `max` (luminance) in each texel over the cone around it.
void spread(std::vector<Energy>& energies, const std::vector<double>& angles,
            const std::vector<Vec3d>& directions, double max, double cosine) {
    std::vector<Energy> added(kTexels);
    std::vector<double> weights(kTexels);
    for (std::size_t i = 0; i < kTexels; ++i) {
        const double luminance = energies[i].luminance(), allowed = max * angles[i];
        if (!(luminance > allowed)) continue;
        double sum = 0;
        for (std::size_t k = 0; k < kTexels; ++k) {
            weights[k] = std::max(dot(directions[i], directions[k]) - cosine, 0.0) * angles[k];
            sum += weights[k];
        }
        const double excess = 1 - allowed / luminance;
        for (std::size_t k = 0; k < kTexels; ++k)
            if (weights[k] > 0) added[k].add(energies[i], excess * weights[k] / sum);
        energies[i] = {energies[i].r * (1 - excess), energies[i].g * (1 - excess),
                       energies[i].b * (1 - excess)};
    }
    for (std::size_t i = 0; i < kTexels; ++i) energies[i].add(added[i], 1);
}

std::vector<Energy> spreadBrightSpots(const std::vector<Texel>& texels, const std::vector<double>& angles,
                                      const std::vector<Vec3d>& directions) {
    std::vector<Energy> energies;
    double sum = 0;
    for (const Texel& texel : texels) {
        energies.push_back(texel.energy);
        sum += texel.energy.luminance();
    }
    const double max = kMax * sum / (4 * static_cast<double>(kPi));
    for (const double cone : kCones) {
        const float radians = static_cast<float>(cone) * kPi / 180;
        spread(energies, angles, directions, max, static_cast<double>(portableCos(radians)));
    }
    return energies;
}

/// Irradiance over pi, by normal.
std::vector<Colour> openOf(const std::vector<Energy>& energies, const std::vector<Vec3d>& towards) {
    std::vector<Colour> open;
    for (int row = 0; row <= kSteps; ++row) {
        for (int column = 0; column <= kSteps; ++column) {
            const Vec3d normal = unitOf(HWY_NAMESPACE::octahedronDirection<double>(
                static_cast<double>(column) / kSteps, static_cast<double>(row) / kSteps));
            Energy sum;
            for (std::size_t i = 0; i < kTexels; ++i) {
                const double cosine = dot(normal, towards[i]);
                if (cosine > 0) sum.add(energies[i], cosine);
            }
            open.push_back(sum.colour(1 / static_cast<double>(kPi)));
        }
    }
    return open;
}

float ratio(float a, float b) { return b > 0 ? std::min(a / b, kMaxCorrection) : 0; }

} // namespace

EnvironmentLight::EnvironmentLight() {
    for (std::vector<float>& channel : radiance_) channel.assign(1, 1.0F);
}

EnvironmentLight::EnvironmentLight(std::span<const EnvironmentCell> cells) : side_(kSide) {
    const std::vector<double> angles = solidAngles();
    const std::vector<Vec3d> directions = middles();
    const std::vector<Texel> texels = gather(cells, angles);
    const std::vector<Energy> energies = spreadBrightSpots(texels, angles, directions);
    for (std::vector<float>& channel : radiance_) channel.resize(kTexels);
    std::vector<Energy> own;
    std::vector<Vec3d> towards;
    for (std::size_t i = 0; i < kTexels; ++i) {
        const Colour colour = energies[i].colour(1 / angles[i]);
        radiance_[0][i] = colour.r;
        radiance_[1][i] = colour.g;
        radiance_[2][i] = colour.b;
        own.push_back(texels[i].energy);
        towards.push_back(texels[i].towards);
    }
    open_ = openOf(own, towards);
    spreadOpen_ = openOf(energies, directions);
}

Colour EnvironmentLight::lookUp(const std::vector<Colour>& byNormal, Vec3 normal) const {
    if (side_ == 1) return kWhite;
    const auto point = HWY_NAMESPACE::octahedronPoint<float>(normal);
    const float x = point.x * kSteps, y = point.y * kSteps;
    const int column = std::clamp(static_cast<int>(x), 0, kSteps - 1),
              row = std::clamp(static_cast<int>(y), 0, kSteps - 1);
    const float right = x - static_cast<float>(column), below = y - static_cast<float>(row);
    const Colour* const first = &byNormal[static_cast<std::size_t>(row * kStride + column)];
    return (first[0] * (1 - right) + first[1] * right) * (1 - below) +
           (first[kStride] * (1 - right) + first[kStride + 1] * right) * below;
}

Colour EnvironmentLight::correction(Vec3 normal) const {
    if (side_ == 1) return kWhite;
    const Colour own = open(normal), spread = lookUp(spreadOpen_, normal);
    return {ratio(own.r, spread.r), ratio(own.g, spread.g), ratio(own.b, spread.b)};
}

} // namespace rtcore

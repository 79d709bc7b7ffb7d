#include "support/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace test {

namespace {

// The paper's constants: of the eye's contrast sensitivity (table 1), of how differences are mapped, and of
// the width of features in degrees.
constexpr double kAchromatic = 0.0047, kRedGreen = 0.0053;
constexpr double kBlueYellowPart = 34.1, kBlueYellow = 0.04, kBlueYellowWidePart = 13.5,
                 kBlueYellowWide = 0.025;
constexpr float kColourPower = 0.7F, kBend = 0.4F, kBendValue = 0.95F, kFeaturePower = 0.5F;
constexpr double kFeatureWidth = 0.082;

struct Triple {
    float a = 0, b = 0, c = 0;
};
using Rows = std::array<std::array<double, 3>, 3>;

/// Linear sRGB to CIE XYZ, in parts of white.
constexpr Rows kToXyz = {{{10135552 / 23359437.0, 8788810 / 23359437.0, 4435075 / 23359437.0},
                          {2613072 / 12288897.0, 8788810 / 12288897.0, 887015 / 12288897.0},
                          {1425312 / 80288307.0, 8788810 / 80288307.0, 70074185 / 80288307.0}}};

constexpr Rows inverse(const Rows& m) {
    Rows result{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t r = (j + 1) % 3, s = (j + 2) % 3, p = (i + 1) % 3, q = (i + 2) % 3;
            result[i][j] = m[r][p] * m[s][q] - m[r][q] * m[s][p];
        }
    }
    const double determinant = m[0][0] * result[0][0] + m[0][1] * result[1][0] + m[0][2] * result[2][0];
    for (auto& row : result) {
        for (double& value : row) value /= determinant;
    }
    return result;
}
constexpr Rows kFromXyz = inverse(kToXyz);

Triple times(const Rows& m, Triple v) {
    const auto row = [&](std::size_t i) {
        return static_cast<float>(m[i][0]) * v.a + static_cast<float>(m[i][1]) * v.b +
               static_cast<float>(m[i][2]) * v.c;
    };
    return {row(0), row(1), row(2)};
}

float linear(std::uint8_t code) {
    const double x = code / 255.0;
    return static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
}

/// CIELAB with the chroma of dark colours reduced (Hunt).
Triple huntAdjusted(Triple rgb) {
    const auto curve = [](float t) {
        constexpr float kKnee = 6.0F / 29;
        return t > kKnee * kKnee * kKnee ? std::cbrt(t) : t / (3 * kKnee * kKnee) + 4.0F / 29;
    };
    const Triple xyz = times(kToXyz, rgb);
    const float x = curve(xyz.a), y = curve(xyz.b), z = curve(xyz.c);
    const float lightness = 116 * y - 16;
    return {lightness, 0.01F * lightness * 500 * (x - y), 0.01F * lightness * 200 * (y - z)};
}

/// The distance HyAB of large differences (Abasi et al. 2020), to the paper's power.
float colourDifference(Triple a, Triple b) {
    return std::pow(std::fabs(a.a - b.a) + std::hypot(a.b - b.b, a.c - b.c), kColourPower);
}

/// Small differences get most of 0..1.
float redistributed(float difference, float largest) {
    const float bend = kBend * largest;
    if (difference < bend) return kBendValue / bend * difference;
    return kBendValue + (difference - bend) / (largest - bend) * (1 - kBendValue);
}

std::vector<float> sampled(int radius, auto&& function) {
    std::vector<float> weights;
    for (int i = -radius; i <= radius; ++i) weights.push_back(static_cast<float>(function(i)));
    return weights;
}

double sumOf(const std::vector<float>& weights) {
    double sum = 0;
    for (const float w : weights) sum += static_cast<double>(w);
    return sum;
}

void scale(std::vector<float>& weights, double factor) {
    for (float& w : weights) w = static_cast<float>(static_cast<double>(w) * factor);
}

/// Positive and negative weights, each for itself, have the sum 1 or -1.
void normaliseParts(std::vector<float>& weights) {
    double above = 0, below = 0;
    for (const float w : weights) (w > 0 ? above : below) += static_cast<double>(w);
    for (float& w : weights) w = static_cast<float>(static_cast<double>(w) / (w > 0 ? above : -below));
}

} // namespace

float Flip::largestColourDifference() {
    return colourDifference(huntAdjusted({0, 1, 0}), huntAdjusted({0, 0, 1}));
}

Flip::Filters Flip::filtersFor(float pixelsPerDegree) {
    const auto density = static_cast<double>(pixelsPerDegree);
    constexpr double kPi = std::numbers::pi;
    Filters filters;
    // Equation 5: sums of Gaussians, out to three standard deviations of the widest.
    const int reach = static_cast<int>(std::ceil(3 * std::sqrt(kBlueYellow / (2 * kPi * kPi)) * density));
    const auto gaussian = [&](double b) {
        return sampled(reach,
                       [&](int i) { return std::exp(-kPi * kPi * (i / density) * (i / density) / b); });
    };
    filters.achromatic = gaussian(kAchromatic);
    filters.redGreen = gaussian(kRedGreen);
    filters.blueYellow = gaussian(kBlueYellow);
    filters.blueYellowWide = gaussian(kBlueYellowWide);
    const auto weightOf = [](double a, double b, double sum) { return a * std::sqrt(kPi / b) * sum * sum; };
    const double narrow = weightOf(kBlueYellowPart, kBlueYellow, sumOf(filters.blueYellow));
    const double wide = weightOf(kBlueYellowWidePart, kBlueYellowWide, sumOf(filters.blueYellowWide));
    filters.narrowPart = static_cast<float>(narrow / (narrow + wide));
    filters.widePart = static_cast<float>(wide / (narrow + wide));
    for (Weights* const weights :
         {&filters.achromatic, &filters.redGreen, &filters.blueYellow, &filters.blueYellowWide}) {
        scale(*weights, 1 / sumOf(*weights));
    }
    // Section 4.2: derivatives of a Gaussian find edges and points.
    const double deviation = 0.5 * kFeatureWidth * density;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const auto bell = [&](int i) { return std::exp(-i * i / (2 * deviation * deviation)); };
    filters.smooth = sampled(radius, bell);
    scale(filters.smooth, 1 / sumOf(filters.smooth));
    filters.slope = sampled(radius, [&](int i) { return -i * bell(i); });
    normaliseParts(filters.slope);
    filters.curvature =
        sampled(radius, [&](int i) { return (i * i / (deviation * deviation) - 1) * bell(i); });
    normaliseParts(filters.curvature);
    return filters;
}

/// Beyond the image its border goes on.
Flip::Plane Flip::filtered(const Plane& plane, const Weights& across, const Weights& down) const {
    const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_);
    Plane between(plane.size()), result(plane.size());
    const std::size_t side = across.size() / 2;
    std::vector<float> row(width + 2 * side);
    for (std::size_t y = 0; y < height; ++y) {
        const float* const from = &plane[y * width];
        std::fill_n(row.begin(), side, from[0]);
        std::copy_n(from, width, row.begin() + static_cast<std::ptrdiff_t>(side));
        std::fill_n(row.end() - static_cast<std::ptrdiff_t>(side), side, from[width - 1]);
        float* const to = &between[y * width];
        for (std::size_t k = 0; k < across.size(); ++k) {
            for (std::size_t x = 0; x < width; ++x) to[x] += across[k] * row[x + k];
        }
    }
    const int reach = static_cast<int>(down.size() / 2);
    for (int y = 0; y < height_; ++y) {
        float* const to = &result[static_cast<std::size_t>(y) * width];
        for (int k = -reach; k <= reach; ++k) {
            const auto line = static_cast<std::size_t>(std::clamp(y + k, 0, height_ - 1));
            const float weight = down[static_cast<std::size_t>(k + reach)];
            const float* const from = &between[line * width];
            for (std::size_t x = 0; x < width; ++x) to[x] += weight * from[x];
        }
    }
    return result;
}

Flip::Seen Flip::see(const rtcore::LdrImage& image) const {
    static const auto kLinear = [] {
        std::array<float, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i) table[i] = linear(static_cast<std::uint8_t>(i));
        return table;
    }();
    const std::size_t count = image.pixels.size();
    Plane luminance(count), redGreen(count), blueYellow(count); // YCxCz, the first in parts of white
    for (std::size_t i = 0; i < count; ++i) {
        const rtcore::Rgba8 p = image.pixels[i];
        const Triple xyz = times(kToXyz, {kLinear[p.r], kLinear[p.g], kLinear[p.b]});
        luminance[i] = xyz.b;
        redGreen[i] = xyz.a - xyz.b;
        blueYellow[i] = xyz.b - xyz.c;
    }
    Seen seen;
    seeFeatures(luminance, seen);
    seen.lightness = filtered(luminance, filters_.achromatic, filters_.achromatic);
    seen.redGreen = filtered(redGreen, filters_.redGreen, filters_.redGreen);
    seen.blueYellow = filtered(blueYellow, filters_.blueYellow, filters_.blueYellow);
    const Plane wide = filtered(blueYellow, filters_.blueYellowWide, filters_.blueYellowWide);
    for (std::size_t i = 0; i < count; ++i) {
        const float y = seen.lightness[i];
        const float z = y - (filters_.narrowPart * seen.blueYellow[i] + filters_.widePart * wide[i]);
        Triple rgb = times(kFromXyz, {seen.redGreen[i] + y, y, z});
        for (float* const part : {&rgb.a, &rgb.b, &rgb.c}) *part = std::clamp(*part, 0.0F, 1.0F);
        const Triple colour = huntAdjusted(rgb);
        seen.lightness[i] = colour.a;
        seen.redGreen[i] = colour.b;
        seen.blueYellow[i] = colour.c;
    }
    return seen;
}

void Flip::seeFeatures(const Plane& luminance, Seen& seen) const {
    const auto strength = [&](const Weights& derivative) {
        Plane result = filtered(luminance, derivative, filters_.smooth);
        const Plane down = filtered(luminance, filters_.smooth, derivative);
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = std::hypot(result[i], down[i]);
        return result;
    };
    seen.edges = strength(filters_.slope);
    seen.points = strength(filters_.curvature);
}

Flip::Flip(const rtcore::LdrImage& reference, float pixelsPerDegree)
    : width_(reference.width), height_(reference.height), filters_(filtersFor(pixelsPerDegree)),
      reference_(see(reference)) {}

std::vector<float> Flip::errors(const rtcore::LdrImage& image) const {
    const Seen seen = see(image);
    const float largest = largestColourDifference();
    std::vector<float> errors(image.pixels.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const Seen& r = reference_;
        const float colour =
            redistributed(colourDifference({r.lightness[i], r.redGreen[i], r.blueYellow[i]},
                                           {seen.lightness[i], seen.redGreen[i], seen.blueYellow[i]}),
                          largest);
        const float feature =
            std::max(std::fabs(r.edges[i] - seen.edges[i]), std::fabs(r.points[i] - seen.points[i]));
        const float seenFeature = std::pow(feature / std::numbers::sqrt2_v<float>, kFeaturePower);
        errors[i] = std::pow(colour, 1 - seenFeature);
    }
    return errors;
}

double Flip::mean(const rtcore::LdrImage& image) const {
    const std::vector<float> all = errors(image);
    double sum = 0;
    for (const float error : all) sum += static_cast<double>(error);
    return sum / static_cast<double>(std::max<std::size_t>(1, all.size()));
}

} // namespace test

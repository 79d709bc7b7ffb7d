#include "rtcore/lights/environment_sampler.h"

#include "rtcore/lights/environment_sampler-inl.h"
#include "rtcore/lights/interval_starts.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace rtcore {

namespace {

namespace plain = HWY_NAMESPACE;

/// How bright corners count that are so bright, both in means of the luminance: less by half a mean, since
/// what comes from all sides is found by scattered rays, too (Karlik, Sik, Vivoda, Skrivan and Krivanek 2019,
/// "MIS Compensation"). Some light is found by these rays alone, as that through windows and glass: so none
/// counts as less than a quarter of itself. And rays in all directions have a density.
double sampledBrightness(double brightness) {
    constexpr double kFoundOtherwise = 0.5, kMinFraction = 0.25, kMin = 1e-3;
    return std::max({brightness - kFoundOtherwise, kMinFraction * brightness, kMin});
}

/// The k-th corner along a side of `texels` texels with a border of one: the two texels between which it
/// lies, at the edges of the image, or the one in whose middle it lies; and its position, 0..1.
struct CornerPosition {
    int first, second;
    double position;

    CornerPosition(int k, int texels)
        : first(k == texels + 1 ? texels : k), second(k == 0 ? 1 : k),
          position(std::clamp(k - 0.5, 0.0, static_cast<double>(texels)) / texels) {}
};

/// Solid angle over area of a face of side 1, as six of them are seen: 1 where it does not matter.
double faceScale(bool cube, double s, double t) {
    if (!cube) return 1;
    const double x = 2 * s - 1, y = 2 * t - 1, square = 1 + x * x + y * y;
    return 1 / (square * std::sqrt(square));
}

/// Appends the brightness at the corners of all cells, in units of the mean.
void addCorners(const HdrImage& padded, bool cube, double mean, std::vector<float>& corners) {
    const int width = padded.width - 2, height = padded.height - 2;
    for (int y = 0; y < padded.height; ++y) {
        const CornerPosition down(y, height);
        for (int x = 0; x < padded.width; ++x) {
            const CornerPosition right(x, width);
            const Colour seen = (padded.at(right.first, down.first) + padded.at(right.second, down.first) +
                                 padded.at(right.first, down.second) + padded.at(right.second, down.second)) *
                                0.25F;
            const double brightness = std::fabs(static_cast<double>(luminance(seen))) / mean;
            const double scale = faceScale(cube, right.position, down.position);
            corners.push_back(static_cast<float>(sampledBrightness(brightness) * scale));
        }
    }
}

/// 1 - cosine where rows of cells begin that lie on a sphere, and where the last one ends.
std::vector<float> depthsOf(int height) {
    std::vector<float> depths;
    for (int k = 0; k <= height + 1; ++k) {
        const double sine = portableSinOfDegrees(90 * CornerPosition(k, height).position);
        depths.push_back(static_cast<float>(2 * sine * sine));
    }
    return depths;
}

float lengthOf(int cell, int cells) { return plain::cellSpan<float>(static_cast<float>(cell), cells).length; }

} // namespace

void EnvironmentSampler::prepare(const BackgroundLight& light) {
    *this = {};
    const auto mean = static_cast<double>(luminance(light.mean()));
    if (!(mean > 0) || !std::isfinite(mean)) return;
    scalarIrradiance_ = 4 * std::numbers::pi * mean;
    if (light.environment == nullptr) {
        takeImages(Environment::fromEquirectangular(HdrImage(1, 1, light.even), ""), mean);
    } else {
        takeImages(*light.environment, mean / static_cast<double>(light.environment->intensity));
    }
    setProbabilities();
}

/// `mean`: of the images' luminance.
void EnvironmentSampler::takeImages(const Environment& environment, double mean) {
    const std::span<const HdrImage> images = environment.images();
    cube_ = environment.isCube();
    columns_ = images[0].width - 1;
    rows_ = images[0].height - 1;
    corners_.reserve(images.size() * static_cast<std::size_t>(columns_ + 1) *
                     static_cast<std::size_t>(rows_ + 1));
    for (const HdrImage& image : images) addCorners(image, cube_, mean, corners_);
    const auto addAxis = [&](Vec3 ofImage) {
        const Vec3 axis = environment.turned(ofImage);
        axes_.insert(axes_.end(), {axis.x, axis.y, axis.z});
    };
    if (!cube_) {
        depths_ = depthsOf(images[0].height - 2);
        for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) addAxis(axis);
    }
    for (int face = 0; cube_ && face < 6; ++face) {
        const Vec3 middle = cubeDirection(face, 0.5F, 0.5F);
        addAxis(middle);
        addAxis(cubeDirection(face, 1, 0.5F) - middle);
        addAxis(cubeDirection(face, 0.5F, 1) - middle);
    }
}

/// Solid angle of a row of cells over its width, but for a common factor.
float EnvironmentSampler::heightOf(int row) const {
    if (cube_) return lengthOf(row, rows_);
    const auto edges = plain::rowDepths<float>(rows(), static_cast<float>(row));
    return edges.end - edges.start;
}

/// The probabilities of rows and columns.
void EnvironmentSampler::setProbabilities() {
    const auto columns = static_cast<std::size_t>(columns_);
    const std::size_t images = axes_.size() / 9;
    std::vector<double> ofRows, ofCells(columns);
    std::vector<float> widths(columns);
    for (std::size_t x = 0; x < columns; ++x) widths[x] = lengthOf(static_cast<int>(x), columns_);
    columnStarts_.reserve(images * static_cast<std::size_t>(rows_) * (columns + 1));
    const float* upper = corners_.data();
    for (std::size_t image = 0; image < images; ++image, upper += columns + 1) {
        for (int y = 0; y < rows_; ++y, upper += columns + 1) {
            const float* const lower = upper + columns + 1;
            double sum = 0;
            for (std::size_t x = 0; x < columns; ++x) {
                ofCells[x] = (static_cast<double>(upper[x]) + static_cast<double>(upper[x + 1]) +
                              static_cast<double>(lower[x]) + static_cast<double>(lower[x + 1])) *
                             static_cast<double>(widths[x]);
                sum += ofCells[x];
            }
            addStarts(ofCells, columnStarts_);
            ofRows.push_back(sum * static_cast<double>(heightOf(y)));
        }
    }
    addStarts(ofRows, rowStarts_);
}

EnvironmentRows EnvironmentSampler::rows() const {
    return {cube_,
            columns_,
            rows_,
            static_cast<int>(rowStarts_.size()) - 1,
            axes_.data(),
            depths_.data(),
            corners_.data(),
            rowStarts_.data(),
            columnStarts_.data()};
}

} // namespace rtcore

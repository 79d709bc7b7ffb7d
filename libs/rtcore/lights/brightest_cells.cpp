#include "rtcore/lights/brightest_cells.h"

#include "rtcore/math/constants.h"
#include "rtcore/math/octahedron-inl.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rtcore {

namespace {

namespace plain = HWY_NAMESPACE;

constexpr float kNotSeen = -1;

float brightness(Colour radiance) {
    const float l = std::fabs(luminance(radiance));
    return std::isfinite(l) ? l : 0;
}

class CellMaximum {
  public:
    explicit CellMaximum(int side)
        : side_(side), cells_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), kNotSeen) {}

    /// `direction`: of any length.
    void add(Vec3 direction, Colour radiance) {
        float& cell = cells_[static_cast<std::size_t>(plain::octahedronTexel<float>(direction, side_))];
        cell = std::max(cell, brightness(radiance));
    }
    void addSphere(const Environment& environment, const HdrImage& padded);
    void addFace(const Environment& environment, const HdrImage& padded, int face);
    void lookUpRest(const Environment& environment);
    std::vector<float> take() { return std::move(cells_); }

  private:
    int side_;
    std::vector<float> cells_;
};

void CellMaximum::addSphere(const Environment& environment, const HdrImage& padded) {
    const int width = padded.width - 2, height = padded.height - 2;
    std::vector<Vec3> across;
    for (int x = 0; x < width; ++x) {
        const float azimuth = (2 * (static_cast<float>(x) + 0.5F) / static_cast<float>(width) - 1) * kPi;
        across.push_back(environment.turned({portableSin(azimuth), 0, -portableCos(azimuth)}));
    }
    const Vec3 up = environment.turned({0, 1, 0});
    for (int y = 0; y < height; ++y) {
        const float polar = (static_cast<float>(y) + 0.5F) / static_cast<float>(height) * kPi;
        const Vec3 along = up * portableCos(polar);
        const float ring = portableSin(polar);
        for (int x = 0; x < width; ++x)
            add(along + across[static_cast<std::size_t>(x)] * ring, padded.at(x + 1, y + 1));
    }
}

void CellMaximum::addFace(const Environment& environment, const HdrImage& padded, int face) {
    const int side = padded.width - 2;
    const Vec3 corner = cubeDirection(face, 0, 0);
    const Vec3 right = environment.turned(cubeDirection(face, 1, 0) - corner) / static_cast<float>(side);
    const Vec3 down = environment.turned(cubeDirection(face, 0, 1) - corner) / static_cast<float>(side);
    const Vec3 first = environment.turned(corner) + (right + down) * 0.5F;
    for (int y = 0; y < side; ++y) {
        const Vec3 row = first + down * static_cast<float>(y);
        for (int x = 0; x < side; ++x) add(row + right * static_cast<float>(x), padded.at(x + 1, y + 1));
    }
}

/// Below which cosine with the axis of a map no cell is near its poles: within two rows and two cells of
/// them.
float leastPolarCosine(const Environment& environment, int side) {
    if (environment.isCube()) return 2;
    const float rows = 2 * 2 * kPi / static_cast<float>(environment.resolution()),
                cells = 2 * kPi / static_cast<float>(side);
    return portableCos(std::min(rows + cells, 0.5F * kPi));
}

void CellMaximum::lookUpRest(const Environment& environment) {
    Environment plainOne = environment;
    plainOne.intensity = 1;
    const float step = 1 / static_cast<float>(side_);
    const auto direction = [&](int column, int row, float right, float down) {
        return plain::octahedronDirection<float>((static_cast<float>(column) + right) * step,
                                                 (static_cast<float>(row) + down) * step);
    };
    const Vec3 up = environment.turned({0, 1, 0});
    const float polar = leastPolarCosine(environment, side_);
    std::size_t i = 0;
    for (int row = 0; row < side_; ++row) {
        for (int column = 0; column < side_; ++column, ++i) {
            const Vec3 middle = direction(column, row, 0.5F, 0.5F);
            const bool nearPole = std::fabs(dot(middle, up)) > polar * length(middle);
            if (!nearPole && cells_[i] != kNotSeen) continue;
            const int points = nearPole ? 8 : 1;
            for (int k = 0; k < points * points; ++k) {
                const auto place = [&](int number) {
                    return (static_cast<float>(number) + 0.5F) / static_cast<float>(points);
                };
                const Vec3 at = direction(column, row, place(k % points), place(k / points));
                cells_[i] = std::max(cells_[i], brightness(plainOne.radiance(at, TexelFilter::Bilinear)));
            }
        }
    }
}

} // namespace

std::vector<float> brightestInCells(const Environment& environment, int side) {
    CellMaximum most(side);
    const std::span<const HdrImage> images = environment.images();
    if (!environment.isCube()) most.addSphere(environment, images[0]);
    for (int face = 0; environment.isCube() && face < 6; ++face)
        most.addFace(environment, images[static_cast<std::size_t>(face)], face);
    most.lookUpRest(environment);
    return most.take();
}

// Beside an edge of the unfolded square lies the same edge from its other end.
std::vector<float> brightestAround(const std::vector<float>& cells, int side) {
    const auto n = static_cast<std::size_t>(side);
    std::vector<float> inRow(cells.size()), around(cells.size());
    for (std::size_t y = 0; y < n; ++y) {
        const float* const row = &cells[y * n];
        const float* const mirrored = &cells[(n - 1 - y) * n];
        for (std::size_t x = 0; x < n; ++x) {
            const float before = x > 0 ? row[x - 1] : mirrored[0];
            const float after = x + 1 < n ? row[x + 1] : mirrored[n - 1];
            inRow[y * n + x] = std::max({before, row[x], after});
        }
    }
    for (std::size_t y = 0; y < n; ++y) {
        const float* const row = &inRow[y * n];
        for (std::size_t x = 0; x < n; ++x) {
            const float above = y > 0 ? row[x - n] : row[n - 1 - x];
            const float below = y + 1 < n ? row[x + n] : row[n - 1 - x];
            around[y * n + x] = std::max({above, row[x], below});
        }
    }
    return around;
}

} // namespace rtcore

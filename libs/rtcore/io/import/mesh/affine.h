/// Transforms of a node graph, in double: chains of them are long, and what they place must meet.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/scene/local_origin.h"

#include <array>
#include <cmath>
#include <span>

namespace rtcore {

/// p -> linear part * p + last column.
struct Affine {
    std::array<std::array<double, 4>, 3> m{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

    bool identity() const { return m == Affine{}.m; }
    Vec3 point(Vec3 p) const { return {apply(0, p, m[0][3]), apply(1, p, m[1][3]), apply(2, p, m[2][3])}; }
    Vec3 vector(Vec3 v) const { return {apply(0, v, 0), apply(1, v, 0), apply(2, v, 0)}; }
    double determinant() const {
        double sum = 0;
        for (int c = 0; c < 3; ++c) sum += m[0][static_cast<std::size_t>(c)] * cofactor(0, c);
        return sum;
    }
    /// Along the inverse transpose of the linear part, which keeps normals perpendicular; not of unit length.
    /// Also for a linear part that cannot be inverted; may be zero then.
    Vec3 normal(Vec3 n) const {
        const double sign = determinant() < 0 ? -1 : 1;
        std::array<double, 3> r{};
        for (int i = 0; i < 3; ++i) {
            r[static_cast<std::size_t>(i)] =
                sign *
                (cofactor(i, 0) * double{n.x} + cofactor(i, 1) * double{n.y} + cofactor(i, 2) * double{n.z});
        }
        const double largest = std::fmax(std::fabs(r[0]), std::fmax(std::fabs(r[1]), std::fabs(r[2])));
        if (!(largest > 0) || !std::isfinite(largest)) return {};
        return {static_cast<float>(r[0] / largest), static_cast<float>(r[1] / largest),
                static_cast<float>(r[2] / largest)};
    }
    /// This after `inner`.
    Affine operator*(const Affine& inner) const {
        Affine r;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 4; ++j) {
                r.m[i][j] = m[i][0] * inner.m[0][j] + m[i][1] * inner.m[1][j] + m[i][2] * inner.m[2][j];
            }
            r.m[i][3] += m[i][3];
        }
        return r;
    }
    /// Adds `weight` times the matrix of `other`.
    void add(const Affine& other, double weight) {
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                m[row][column] += weight * other.m[row][column];
    }
    void scale(double factor) {
        for (auto& row : m)
            for (double& v : row) v *= factor;
    }

  private:
    float apply(std::size_t row, Vec3 v, double offset) const {
        return static_cast<float>(m[row][0] * double{v.x} + m[row][1] * double{v.y} +
                                  m[row][2] * double{v.z} + offset);
    }
    double cofactor(int row, int column) const {
        const auto a = static_cast<std::size_t>((row + 1) % 3), b = static_cast<std::size_t>((row + 2) % 3);
        const auto c = static_cast<std::size_t>((column + 1) % 3),
                   d = static_cast<std::size_t>((column + 2) % 3);
        return m[a][c] * m[b][d] - m[a][d] * m[b][c];
    }
};

/// From coordinates of a file to those with an origin taken off.
inline Affine lessOrigin(const LocalOrigin& origin) {
    Affine a;
    for (std::size_t row = 0; row < 3; ++row) a.m[row][3] = 0 - origin.at[row];
    return a;
}

/// Of positions in floats, where they stand: what floats cannot tell apart, times the scale.
inline double coarsenessOf(std::span<const Vec3> positions, const Affine& toWorld) {
    FileBounds bounds;
    for (const Vec3 p : positions) bounds.extend(p);
    return coarsenessAt(bounds.farthest()) * std::cbrt(std::fabs(toWorld.determinant()));
}

} // namespace rtcore

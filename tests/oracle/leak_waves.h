/// Waves of aimed rays that each go through one kernel.
#pragma once

#include "leak_aim.h"

#include "rtcore/kernels/ray_wave.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace test {

/// Which kernel answers (libs/rtcore/kernels/wave-inl.h chooses by the rays).
enum class Kernel {
    Single,
    Stream,       ///< rays of any directions, many
    Packet,       ///< rays of any directions, few
    AxisPacket,   ///< groups that share the axis along which they go farthest
    OriginPacket, ///< and their origin
};
inline constexpr Kernel kKernels[] = {Kernel::Single, Kernel::Stream, Kernel::Packet, Kernel::AxisPacket,
                                      Kernel::OriginPacket};
inline constexpr std::size_t kRaysOfGroup = 64;

inline const char* nameOf(Kernel kernel) {
    switch (kernel) {
    case Kernel::Single:
        return "single rays";
    case Kernel::Stream:
        return "streams";
    case Kernel::Packet:
        return "packets of any rays";
    case Kernel::AxisPacket:
        return "packets of one axis";
    default:
        return "packets of one origin";
    }
}

inline rtcore::Ray endless(rtcore::Vec3 origin, rtcore::Vec3 direction) {
    return {origin, 0, direction, std::numeric_limits<float>::infinity()};
}

/// From anywhere to anywhere; every fourth direction is normalised.
inline void pushScattered(const LeakAim& aim, std::size_t count, Random& random, rtcore::RayWave& wave) {
    for (std::size_t i = 0; i < count; ++i) {
        const rtcore::Vec3 origin = aim.start(aim.place(i / 4 % 2 == 1, random), random);
        const rtcore::Vec3 direction = aim.target(i, aim.anyTriangle(random), random) - origin;
        wave.push(endless(origin, i % 4 == 0 ? normalize(direction) : direction));
    }
}

/// Directions by the side of a cube that they go through and the square there; those of one square are
/// coherent.
class DirectionSquares {
  public:
    static constexpr int kSide = 11, kCount = 6 * kSide * kSide;

    /// kCount for none: between two sides.
    static int squareOf(rtcore::Vec3 direction) {
        int axis = 0;
        for (int i = 1; i < 3; ++i) {
            if (std::fabs(direction[i]) > std::fabs(direction[axis])) axis = i;
        }
        const float longest = std::fabs(direction[axis]);
        const float x = direction[(axis + 1) % 3] / longest;
        const float y = direction[(axis + 2) % 3] / longest;
        if (!(std::fabs(x) < 1 && std::fabs(y) < 1)) return kCount;
        const int side = 2 * axis + (direction[axis] < 0 ? 1 : 0);
        return (side * kSide + step(x)) * kSide + step(y);
    }

    /// Sorts the triangles of a mesh by where they are seen from `eye`.
    DirectionSquares(const rtcore::Mesh& mesh, rtcore::Vec3 eye) : triangles_(kCount) {
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const rtcore::Vec3 sum = mesh.position(i, 0) + mesh.position(i, 1) + mesh.position(i, 2);
            const int square = squareOf(sum * (1.0F / 3) - eye);
            if (square < kCount) triangles_[static_cast<std::size_t>(square)].push_back(i);
        }
    }
    const std::vector<std::uint32_t>& triangles(int square) const {
        return triangles_[static_cast<std::size_t>(square)];
    }

  private:
    static int step(float x) { return std::clamp(static_cast<int>((x + 1) * 0.5F * kSide), 0, kSide - 1); }

    std::vector<std::vector<std::uint32_t>> triangles_;
};

/// Adds a group that goes through one square, from one origin or from many; adds nothing and returns false
/// where too few aims pass. Directions are normalised, or 1 along their axis.
inline bool pushGroup(const LeakAim& aim, const StartPlace& place, rtcore::Vec3 eye, bool manyOrigins,
                      int square, const std::vector<std::uint32_t>& triangles, Random& random,
                      rtcore::RayWave& wave) {
    constexpr int kTries = 40 * static_cast<int>(kRaysOfGroup);
    const std::size_t begin = wave.size();
    const bool normalised = random.coin();
    for (int i = 0; i < kTries && wave.size() < begin + kRaysOfGroup; ++i) {
        const rtcore::Vec3 origin = manyOrigins ? aim.start(place, random) : eye;
        const rtcore::Vec3 target =
            aim.target(static_cast<std::uint64_t>(i), triangles[random.index(triangles.size())], random);
        const rtcore::Vec3 aimed = target - origin;
        const float longest = std::max({std::fabs(aimed.x), std::fabs(aimed.y), std::fabs(aimed.z)});
        if (!(longest > 0)) continue;
        const rtcore::Vec3 direction =
            normalised ? normalize(aimed)
                       : rtcore::Vec3{aimed.x / longest, aimed.y / longest, aimed.z / longest};
        if (DirectionSquares::squareOf(direction) == square) wave.push(endless(origin, direction));
    }
    if (wave.size() == begin + kRaysOfGroup) return true;
    wave.resize(begin);
    return false;
}

/// Groups of coherent rays that share an axis; `groups` from each place where they start.
inline void pushCoherent(const LeakAim& aim, bool manyOrigins, std::size_t count, Random& random,
                         rtcore::RayWave& wave) {
    constexpr std::size_t kGroupsOfPlace = 16;
    const std::size_t end = wave.size() + count / kRaysOfGroup * kRaysOfGroup;
    for (bool onSurface = random.coin(); wave.size() < end; onSurface = !onSurface) {
        const StartPlace place = aim.place(onSurface, random);
        const rtcore::Vec3 eye = aim.start(place, random);
        const DirectionSquares squares(aim.mesh(), eye);
        for (std::size_t groups = 0, tries = 0; groups < kGroupsOfPlace && tries < 200 && wave.size() < end;
             ++tries) {
            const int square = static_cast<int>(random.index(DirectionSquares::kCount));
            const auto& triangles = squares.triangles(square);
            if (triangles.empty()) continue;
            if (pushGroup(aim, place, eye, manyOrigins, square, triangles, random, wave)) ++groups;
        }
    }
}

/// Whether the group from ray `first` on is one that goes as a packet, and with all that `kernel` promises.
inline bool isFor(Kernel kernel, const rtcore::RayWave& wave, std::size_t first) {
    const std::vector<float>* const directions[3] = {&wave.dx, &wave.dy, &wave.dz};
    const std::vector<float>* const origins[3] = {&wave.ox, &wave.oy, &wave.oz};
    float spread = 0;
    float longest = 0;
    bool oneOrigin = true;
    const auto range = [&](const std::vector<float>& values) {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
        return std::minmax_element(begin, begin + kRaysOfGroup);
    };
    for (int axis = 0; axis < 3; ++axis) {
        const auto [lo, hi] = range(*directions[axis]);
        spread = std::max(spread, *hi - *lo);
        longest = std::max({longest, std::fabs(*lo), std::fabs(*hi)});
        const auto [from, to] = range(*origins[axis]);
        oneOrigin &= *from == *to;
    }
    const bool coherent = spread < 0.3F * longest;
    if (kernel == Kernel::Stream || kernel == Kernel::Packet) return !coherent;
    int axes = 0;
    for (std::size_t i = first; i < first + kRaysOfGroup; ++i) {
        const float x = std::fabs(wave.dx[i]);
        const float y = std::fabs(wave.dy[i]);
        const float z = std::fabs(wave.dz[i]);
        axes |= x > y && x > z ? 1 : y > x && y > z ? 2 : 4;
    }
    return coherent && (axes & (axes - 1)) == 0 && oneOrigin == (kernel == Kernel::OriginPacket);
}

} // namespace test

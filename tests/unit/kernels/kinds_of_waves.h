/// Waves of all kinds of rays: such as go as bundles, as packets and as streams.
#pragma once

#include "kernel_support.h"

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/vec.h"
#include "support/random_numbers.h"

#include <cstddef>
#include <cstdint>

namespace test {

inline constexpr std::size_t kGroup = 64; ///< rays that are judged together

/// The directions of a group agree within this share of their length, so that it goes as a packet.
inline constexpr float kNarrow = 0.08F;

inline rtcore::RayWave scattered(std::size_t count, Random& random) {
    rtcore::RayWave wave;
    for (std::size_t i = 0; i < count; ++i) wave.push(rayFrom(random.vector(1.2F), random.unitVector()));
    return wave;
}

/// Groups through one point, each within a narrow cone around a direction that `direction` chooses.
template <typename Direction>
rtcore::RayWave fromOnePoint(std::size_t groups, Random& random, Direction&& direction) {
    rtcore::RayWave wave;
    const rtcore::Vec3 eye = random.vector(1.5F);
    for (std::size_t g = 0; g < groups; ++g) {
        const rtcore::Vec3 forward = direction(random, eye);
        for (std::size_t i = 0; i < kGroup; ++i) wave.push(rayFrom(eye, forward + random.vector(kNarrow)));
    }
    return wave;
}

/// Like those of a camera: most groups share the axis along which they go.
inline rtcore::RayWave camera(std::size_t groups, Random& random) {
    return fromOnePoint(groups, random,
                        [](Random& r, rtcore::Vec3 eye) { return normalize(r.vector(0.5F) - eye); });
}

/// Rays of an image, a group for each 8 x 8 of its pixels: many successive groups go as one bundle.
inline rtcore::RayWave image(std::size_t groups, Random& random) {
    constexpr std::size_t kSide = 8, kAcross = 8;
    rtcore::RayWave wave;
    const rtcore::Vec3 eye = random.vector(1) + random.unitVector();
    const auto [right, down] = rtcore::basisAround(normalize(random.vector(0.5F) - eye));
    const rtcore::Vec3 corner = cross(right, down) - right * 0.5F - down * 0.5F;
    for (std::size_t i = 0; i < groups * kGroup; ++i) {
        const std::size_t g = i / kGroup, x = g % kAcross * kSide + i % kSide,
                          y = g / kAcross * kSide + i % kGroup / kSide;
        const float pixel = 1.0F / (kSide * kAcross);
        wave.push(rayFrom(eye, corner + right * (static_cast<float>(x) * pixel) +
                                   down * (static_cast<float>(y) * pixel)));
    }
    return wave;
}

/// Each group at corners and edges of triangles that follow each other in the mesh: `same` rays at the same
/// place, so that their beam is no wider than they are. From one point, or from places up to `apart` from it.
inline rtcore::RayWave aimed(const rtcore::Mesh& mesh, std::size_t groups, std::size_t same, Random& random,
                             float apart = 0) {
    constexpr std::size_t kApart = 24; // triangles at which a group aims
    rtcore::RayWave wave;
    const rtcore::Vec3 eye = random.unitVector() * 2;
    for (std::size_t g = 0; g < groups; ++g) {
        const std::size_t first = random.index(mesh.triangles.size());
        for (std::size_t i = 0; i < kGroup; ++i) {
            if (i % same != 0) {
                wave.push(wave.ray(wave.size() - 1));
                continue;
            }
            const auto triangle =
                static_cast<std::uint32_t>((first + random.index(kApart)) % mesh.triangles.size());
            const int corner = static_cast<int>(random.index(3));
            const rtcore::Vec3 a = mesh.position(triangle, corner),
                               b = mesh.position(triangle, (corner + 1) % 3);
            const rtcore::Vec3 from = apart > 0 ? eye + random.vector(apart) : eye;
            wave.push(rayFrom(from, a + (b - a) * (random.coin() ? random.number(0, 1) : 0) - from));
        }
    }
    return wave;
}

/// Around the diagonals: no axis in common.
inline rtcore::RayWave diagonal(std::size_t groups, Random& random) {
    return fromOnePoint(groups, random, [](Random& r, rtcore::Vec3) {
        const auto sign = [&] { return r.coin() ? 0.577F : -0.577F; };
        const float x = sign();
        const float y = sign();
        return rtcore::Vec3{x, y, sign()};
    });
}

/// Almost along an axis, so that directions differ in sign on the other two.
inline rtcore::RayWave alongAxes(std::size_t groups, Random& random) {
    return fromOnePoint(groups, random, [](Random& r, rtcore::Vec3) {
        rtcore::Vec3 direction;
        direction[static_cast<int>(r.index(3))] = r.coin() ? 1.0F : -1.0F;
        return direction;
    });
}

/// Neighbours that go the same way from points of their own.
inline rtcore::RayWave sameWay(std::size_t groups, Random& random) {
    rtcore::RayWave wave;
    for (std::size_t g = 0; g < groups; ++g) {
        const rtcore::Vec3 around = random.vector(1.2F);
        const rtcore::Vec3 forward = random.unitVector();
        for (std::size_t i = 0; i < kGroup; ++i) {
            wave.push(rayFrom(around + random.vector(0.1F), forward + random.vector(kNarrow)));
        }
    }
    return wave;
}

/// From points near each other to one light, which is t = 1.
inline rtcore::RayWave toLight(std::size_t groups, Random& random) {
    rtcore::RayWave wave;
    const rtcore::Vec3 light = random.unitVector() * 3;
    for (std::size_t g = 0; g < groups; ++g) {
        const rtcore::Vec3 around = random.vector(1);
        for (std::size_t i = 0; i < kGroup; ++i) {
            const rtcore::Vec3 from = around + random.vector(0.05F);
            wave.push({from, 0, light - from, 1});
        }
    }
    return wave;
}

inline rtcore::RayWave segments(rtcore::RayWave wave, Random& random) {
    for (std::size_t i = 0; i < wave.size(); ++i) {
        wave.tMin[i] = random.coin() ? random.number(0, 0.6F) : 0;
        wave.tMax[i] = wave.tMin[i] + random.number(0, 1.5F);
    }
    return wave;
}

inline void append(rtcore::RayWave& wave, const rtcore::RayWave& more) {
    for (std::size_t i = 0; i < more.size(); ++i) wave.push(more.ray(i));
}

/// Groups of all sorts by turns; `scatteredGroups` of them go any way.
inline rtcore::RayWave mixed(std::size_t scatteredGroups, Random& random) {
    rtcore::RayWave wave;
    for (std::size_t g = 0; g < scatteredGroups; ++g) {
        append(wave, camera(1 + g % 2, random));
        append(wave, scattered(kGroup, random));
        append(wave, toLight(g % 3, random));
        append(wave, diagonal(g % 2, random));
    }
    return wave;
}

} // namespace test

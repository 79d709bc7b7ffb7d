// Every kernel on every instruction set, from records or from the mesh, finds the bits that single rays find.
#include "wave_support.h"

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

using rtcore::Ray;
using rtcore::RayWave;
using rtcore::Vec3;
using test::kForever;
using test::Random;
using test::rayFrom;

namespace {

constexpr std::size_t kGroup = 64;      ///< rays that are judged together
constexpr std::size_t kFewGroups = 7;   ///< of any directions: go as packets
constexpr std::size_t kManyGroups = 40; ///< go as a stream

struct NamedMesh {
    const char* name;
    std::function<test::SampleMesh()> make;
    float intersectionCost;  ///< small: long leaves
    std::size_t longestLeaf; ///< at least
};

std::ostream& operator<<(std::ostream& out, const NamedMesh& mesh) { return out << mesh.name; }

const std::vector<NamedMesh>& meshes() {
    static const std::vector<NamedMesh> all{
        {"soup", [] { return test::soup(3000, 0.15F, 1); }, 0, 2},
        {"sphere", [] { return test::icosphere(4).rotate(2); }, 0, 2},
        {"box", [] { return test::boxGrid(12); }, 0, 2},
        {"torus", [] { return test::torus(40, 20).rotate(3); }, 2, 2},
        {"longLeaves", [] { return test::soup(1500, 0.4F, 4); }, 0.005F, 33},
        {"triangle", [] { return test::soup(1, 1, 5); }, 0, 1},
    };
    return all;
}

/// The directions of a group agree within this share of their length, so that it goes as a packet.
constexpr float kNarrow = 0.08F;

RayWave scattered(std::size_t count, Random& random) {
    RayWave wave;
    for (std::size_t i = 0; i < count; ++i) wave.push(rayFrom(random.vector(1.2F), random.unitVector()));
    return wave;
}

/// Groups through one point, each within a narrow cone around a direction that `direction` chooses.
template <typename Direction>
RayWave fromOnePoint(std::size_t groups, Random& random, Direction&& direction) {
    RayWave wave;
    const Vec3 eye = random.vector(1.5F);
    for (std::size_t g = 0; g < groups; ++g) {
        const Vec3 forward = direction(random, eye);
        for (std::size_t i = 0; i < kGroup; ++i) wave.push(rayFrom(eye, forward + random.vector(kNarrow)));
    }
    return wave;
}

/// Like those of a camera: most groups share the axis along which they go.
RayWave camera(std::size_t groups, Random& random) {
    return fromOnePoint(groups, random, [](Random& r, Vec3 eye) { return normalize(r.vector(0.5F) - eye); });
}

/// Of an image, a group for each 8 x 8 of its pixels: many follow each other that go as one bundle.
RayWave image(std::size_t groups, Random& random) {
    constexpr std::size_t kSide = 8, kAcross = 8;
    RayWave wave;
    const Vec3 eye = random.vector(1) + random.unitVector();
    const auto [right, down] = rtcore::basisAround(normalize(random.vector(0.5F) - eye));
    const Vec3 corner = cross(right, down) - right * 0.5F - down * 0.5F;
    for (std::size_t i = 0; i < groups * kGroup; ++i) {
        const std::size_t g = i / kGroup, x = g % kAcross * kSide + i % kSide,
                          y = g / kAcross * kSide + i % kGroup / kSide;
        const float pixel = 1.0F / (kSide * kAcross);
        wave.push(rayFrom(eye, corner + right * (static_cast<float>(x) * pixel) +
                                   down * (static_cast<float>(y) * pixel)));
    }
    return wave;
}

/// From one point, each group at corners and edges of triangles that follow each other in the mesh: `same`
/// rays at the same place, so that their beam is no wider than they are.
RayWave aimed(const rtcore::Mesh& mesh, std::size_t groups, std::size_t same, Random& random) {
    constexpr std::size_t kApart = 24; // triangles at which a group aims
    RayWave wave;
    const Vec3 eye = random.unitVector() * 2;
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
            const Vec3 a = mesh.position(triangle, corner), b = mesh.position(triangle, (corner + 1) % 3);
            wave.push(rayFrom(eye, a + (b - a) * (random.coin() ? random.number(0, 1) : 0) - eye));
        }
    }
    return wave;
}

/// Around the diagonals: no axis in common.
RayWave diagonal(std::size_t groups, Random& random) {
    return fromOnePoint(groups, random, [](Random& r, Vec3) {
        const auto sign = [&] { return r.coin() ? 0.577F : -0.577F; };
        const float x = sign();
        const float y = sign();
        return Vec3{x, y, sign()};
    });
}

/// Almost along an axis, so that directions differ in sign on the other two.
RayWave alongAxes(std::size_t groups, Random& random) {
    return fromOnePoint(groups, random, [](Random& r, Vec3) {
        Vec3 direction;
        direction[static_cast<int>(r.index(3))] = r.coin() ? 1.0F : -1.0F;
        return direction;
    });
}

/// Neighbours that go the same way from points of their own.
RayWave sameWay(std::size_t groups, Random& random) {
    RayWave wave;
    for (std::size_t g = 0; g < groups; ++g) {
        const Vec3 around = random.vector(1.2F);
        const Vec3 forward = random.unitVector();
        for (std::size_t i = 0; i < kGroup; ++i) {
            wave.push(rayFrom(around + random.vector(0.1F), forward + random.vector(kNarrow)));
        }
    }
    return wave;
}

/// From points near each other to one light, which is t = 1.
RayWave toLight(std::size_t groups, Random& random) {
    RayWave wave;
    const Vec3 light = random.unitVector() * 3;
    for (std::size_t g = 0; g < groups; ++g) {
        const Vec3 around = random.vector(1);
        for (std::size_t i = 0; i < kGroup; ++i) {
            const Vec3 from = around + random.vector(0.05F);
            wave.push({from, 0, light - from, 1});
        }
    }
    return wave;
}

RayWave segments(RayWave wave, Random& random) {
    for (std::size_t i = 0; i < wave.size(); ++i) {
        wave.tMin[i] = random.coin() ? random.number(0, 0.6F) : 0;
        wave.tMax[i] = wave.tMin[i] + random.number(0, 1.5F);
    }
    return wave;
}

void append(RayWave& wave, const RayWave& more) {
    for (std::size_t i = 0; i < more.size(); ++i) wave.push(more.ray(i));
}

/// Groups of all sorts by turns; `scatteredGroups` of them go any way.
RayWave mixed(std::size_t scatteredGroups, Random& random) {
    RayWave wave;
    for (std::size_t g = 0; g < scatteredGroups; ++g) {
        append(wave, camera(1 + g % 2, random));
        append(wave, scattered(kGroup, random));
        append(wave, toLight(g % 3, random));
        append(wave, diagonal(g % 2, random));
    }
    return wave;
}

class EveryKernel : public testing::TestWithParam<NamedMesh> {
  protected:
    EveryKernel() : scene_(GetParam().make(), options()) {}

    void SetUp() override { ASSERT_GE(scene_.longestLeaf(), GetParam().longestLeaf); }

    static rtcore::BuildOptions options() {
        rtcore::BuildOptions options;
        options.intersectionCost = GetParam().intersectionCost;
        return options;
    }

    /// The wave as it is, and cut short in the middle of a group.
    void expectSingleRays(const std::string& name, RayWave wave) {
        hits_ += scene_.expectSingleRays(name, wave);
        wave.resize(wave.size() - 1 - random_.index(kGroup - 1));
        scene_.expectSingleRays(name + " cut short", wave);
    }

    /// Rays of every second group end where they hit, those of others begin there.
    RayWave closed(RayWave wave) const {
        for (std::size_t i = 0; i < wave.size(); ++i) {
            rtcore::Hit hit;
            if (!intersect(scene_.tree(), scene_.mesh(), wave.ray(i), hit)) continue;
            (i / kGroup % 2 == 0 ? wave.tMax : wave.tMin)[i] = hit.t;
        }
        return wave;
    }

    Random random_{7};
    test::WaveScene scene_;
    std::size_t hits_ = 0;
};

std::string nameOfMesh(const testing::TestParamInfo<NamedMesh>& mesh) { return mesh.param.name; }

} // namespace

TEST_P(EveryKernel, TracesStreams) {
    expectSingleRays("stream", scattered(kManyGroups * kGroup, random_));
    expectSingleRays("stream of segments", segments(scattered(kManyGroups * kGroup, random_), random_));
    EXPECT_GT(hits_, 10U);
}

TEST_P(EveryKernel, TracesPacketsOfAnyDirections) {
    for (int i = 0; i < 4; ++i) {
        expectSingleRays("few", scattered(kFewGroups * kGroup, random_));
        expectSingleRays("few segments", segments(scattered(kFewGroups * kGroup, random_), random_));
    }
    EXPECT_GT(hits_, 10U);
}

TEST_P(EveryKernel, TracesPacketsOfOneOrigin) {
    for (int i = 0; i < 4; ++i) {
        expectSingleRays("camera", camera(8, random_));
        expectSingleRays("camera's segments", segments(camera(8, random_), random_));
        expectSingleRays("along axes", alongAxes(8, random_));
        expectSingleRays("diagonal", diagonal(8, random_));
    }
    EXPECT_GT(hits_, 10U);
}

TEST_P(EveryKernel, TracesBundles) {
    for (int i = 0; i < 2; ++i) {
        expectSingleRays("image", image(40, random_));
        expectSingleRays("image's segments", segments(image(40, random_), random_));
        expectSingleRays("image's rays that end or begin where they hit", closed(image(40, random_)));
        for (const std::size_t same : {std::size_t{1}, std::size_t{16}, kGroup})
            expectSingleRays("corners and edges", aimed(scene_.mesh(), 80, same, random_));
        RayWave several = image(20, random_);
        append(several, image(3, random_));
        append(several, scattered(kGroup, random_));
        append(several, image(17, random_));
        expectSingleRays("several images", several);
    }
    EXPECT_GT(hits_, 100U);
}

TEST_P(EveryKernel, TracesPacketsOfManyOrigins) {
    for (int i = 0; i < 4; ++i) {
        expectSingleRays("same way", sameWay(8, random_));
        expectSingleRays("same way, segments", segments(sameWay(8, random_), random_));
        expectSingleRays("to a light", toLight(8, random_));
    }
    EXPECT_GT(hits_, 10U);
}

TEST_P(EveryKernel, TracesMixedWaves) {
    expectSingleRays("packets in between", mixed(kFewGroups, random_));
    expectSingleRays("a stream in between", mixed(kManyGroups / 2, random_));
    EXPECT_GT(hits_, 10U);
}

TEST_P(EveryKernel, TracesWavesOfAnyLength) {
    for (const std::size_t count :
         {0U, 1U, 3U, 4U, 7U, 8U, 15U, 16U, 17U, 63U, 64U, 65U, 127U, 511U, 512U, 513U}) {
        scene_.expectSingleRays(std::to_string(count) + " rays", scattered(count, random_));
        RayWave narrow = camera(9, random_);
        narrow.resize(count);
        scene_.expectSingleRays(std::to_string(count) + " rays of a camera", narrow);
    }
}

INSTANTIATE_TEST_SUITE_P(Meshes, EveryKernel, testing::ValuesIn(meshes()), nameOfMesh);

TEST(InstructionSets, TraceMoreRaysThanOneStreamHolds) {
    const test::WaveScene scene(test::soup(2000, 0.15F, 8));
    Random random(9);
    RayWave wave = scattered(2 * 16384 + 100, random);
    EXPECT_GT(scene.expectSingleRays("long", wave), 10000U);
    append(wave, camera(3, random));
    append(wave, scattered(5 * kGroup + 9, random));
    scene.expectSingleRays("longer", wave);
}

// What a thread keeps from one wave to the next leaves no trace in what the next finds.
TEST(InstructionSets, DoNotRememberOtherScenes) {
    const test::WaveScene one(test::soup(500, 0.3F, 10));
    const test::WaveScene other(test::icosphere(3));
    Random random(11);
    for (int i = 0; i < 3; ++i) {
        const RayWave wave = mixed(10, random);
        one.expectSingleRays("one", wave);
        other.expectSingleRays("other", wave);
    }
}

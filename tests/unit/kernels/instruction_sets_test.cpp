// Every kernel on every instruction set, from records or from the mesh, finds the bits that single rays find.
#include "kinds_of_waves.h"
#include "wave_support.h"

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

using rtcore::RayWave;
using test::aimed;
using test::alongAxes;
using test::append;
using test::camera;
using test::diagonal;
using test::image;
using test::kGroup;
using test::mixed;
using test::Random;
using test::sameWay;
using test::scattered;
using test::segments;
using test::toLight;

namespace {

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
        for (const std::size_t same : {std::size_t{1}, std::size_t{16}, kGroup})
            expectSingleRays("corners and edges", aimed(scene_.mesh(), 40, same, random_, 0.02F));
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

// State that a thread keeps from one wave to the next leaves no trace in the next one's hits.
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

// Steps: their bits, means, memory, and edits between them.

#include "gathering_support.h"

#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

namespace rtcore {
namespace {

std::uint64_t hashOf(const IrradianceCache& cache) {
    std::uint64_t hash = cache.size();
    const auto add = [&](float x) { hash = (hash ^ std::bit_cast<std::uint32_t>(x)) * 1099511628211U; };
    for (std::uint32_t i = 0; i < cache.size(); ++i) {
        const IrradianceRecord& record = cache.record(i);
        for (const float x : {record.position.x, record.radius, record.irradiance.r, record.irradiance.g,
                              record.slant.y, record.distance, record.walls[0].offset})
            add(x);
    }
    return hash;
}

std::uint64_t hashAfter(int steps, int threads) {
    test::GatheringScene room(test::furnishedRoom());
    room.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 400, 0.006F);
    room.budget = {4096, 700};
    room.learn(steps, 600, threads);
    return hashOf(room.light.cache());
}

TEST(Steps, TheSameBitsForAllThreadsAndInstructionSets) {
    const std::uint64_t expected = hashAfter(6, 1);
    for (const int threads : {2, 7}) EXPECT_EQ(hashAfter(6, threads), expected) << threads;
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        EXPECT_EQ(hashAfter(6, 2), expected) << name;
    }
    useInstructionSet("auto");
}

TEST(Steps, LearnByAsManyRaysAsAreAllowedWhereNothingIsKnown) {
    for (const double max : {1.0, 2.5, GatherBudget::kMaxTimes}) {
        test::GatheringScene room(test::furnishedRoom());
        room.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 400, 0.006F);
        room.budget = {.rays = 4096, .paths = 700, .maxTimes = max};
        room.learn(1);
        EXPECT_EQ(room.light.learned().unknown, 1);
        EXPECT_LE(room.light.learned().rays, max * 4096);
        EXPECT_GT(room.light.learned().rays, 0.9 * max * 4096);
        room.learn(30);
        EXPECT_LT(room.light.learned().unknown, 0.2);
        EXPECT_LT(room.light.learned().rays, 1.5 * 4096);
    }
}

TEST(Steps, TheFirstHasTheRightMean) {
    // No dark youth: the cells are filled before they are read.
    test::GatheringScene room(test::furnishedRoom());
    room.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 1000, 0.006F);
    room.budget = {65536, 6000};
    room.learn(1);
    const double first = room.mean().g;
    room.budget = {16384, 1536};
    room.learn(40);
    EXPECT_NEAR(first / room.mean().g, 1, 0.1);
}

TEST(Steps, SettleAtRest) {
    test::GatheringScene room(test::furnishedRoom());
    room.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 600, 0.003F);
    room.budget = {16384, 1536};
    room.learn(64);
    const auto change = [&] {
        std::vector<float> before;
        for (const Receiver& receiver : room.receivers) before.push_back(room.at(receiver).g);
        room.learn(1);
        double sum = 0, all = 0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            sum += std::abs(room.at(room.receivers[i]).g - before[i]);
            all += before[i];
        }
        return sum / all;
    };
    EXPECT_LT(change(), 0.002);
}

TEST(Steps, ForgetLightThatIsSwitchedOff) {
    test::SceneBuilder b;
    test::addRoom(b, {0, 0, 0}, {4, 3, 4}, b.material(test::matte(0.7F)));
    Scene scene = b.finish();
    scene.lights = {test::pointLight({1, 2.5F, 2}, 5), test::pointLight({3, 2.5F, 2}, 5)};
    test::GatheringScene room(std::move(scene));
    room.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 600, 0.006F);
    room.budget = {32768, 3000};
    room.learn(40);
    const double before = room.mean().r;
    room.traced.scene.lights[1].light.on = 0;
    room.light.changeLight(room.traced.scene, room.traced.tracer, room.settings);
    room.learn(1); // coarse records tell of all that is seen at once
    EXPECT_NEAR(room.mean().r / before, 0.5, 0.05);
    room.learn(15);
    EXPECT_NEAR(room.mean().r / before, 0.5, 0.02);
}

TEST(Steps, RememberNoMoreRecordsThanTheyMay) {
    test::GatheringScene room(test::furnishedRoom());
    room.light.boundRecords(500);
    room.budget = {8192, 512};
    for (int k = 0; k < 8; ++k) { // from corner to corner
        room.receivers.clear();
        const float x = 0.5F * static_cast<float>(k);
        room.addReceivers({x, 0, 0}, {0.5F, 0, 0}, {0, 0, 4}, {0, 1, 0}, 1500, 0.002F);
        room.learn(3);
        EXPECT_LE(room.light.cache().size(), 500U + 8192 / kPassRays * 4);
    }
    EXPECT_GT(room.mean().g, 0.05); // what is seen last is known
    EXPECT_LT(room.light.memory(), 5'000'000U);
}

TEST(Steps, StopSoon) {
    test::GatheringScene room(test::furnishedRoom());
    room.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 100, 0.006F);
    std::vector<ArrivingLight> arriving(room.receivers.size());
    const std::atomic<bool> stop{true};
    EXPECT_FALSE(room.light.step(room.receivers, arriving, room.budget, 2, &stop));
    EXPECT_EQ(room.light.cache().size(), 0U);
    EXPECT_TRUE(room.light.step(room.receivers, arriving, room.budget, 2));
    EXPECT_GT(room.mean().g, 0.1);
    test::GatheringScene other(test::furnishedRoom());
    other.receivers = room.receivers;
    other.light.step(other.receivers, arriving, other.budget, 2);
    EXPECT_EQ(hashOf(other.light.cache()), hashOf(room.light.cache()));
}

TEST(Steps, GoOnAfterOneThatWasStoppedAsIfItHadNotBeen) {
    test::GatheringScene stopped(test::furnishedRoom()), other(test::furnishedRoom());
    stopped.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 300, 0.006F);
    other.receivers = stopped.receivers;
    std::vector<ArrivingLight> arriving(stopped.receivers.size()), expected = arriving;
    const std::atomic<bool> stop{true};
    for (int step = 0; step < 4; ++step) {
        EXPECT_FALSE(stopped.light.step(stopped.receivers, arriving, {4096, 512}, 2, &stop));
        EXPECT_TRUE(stopped.light.step(stopped.receivers, arriving, {4096, 512}, 2));
        EXPECT_TRUE(other.light.step(other.receivers, expected, {4096, 512}, 2));
        EXPECT_EQ(hashOf(stopped.light.cache()), hashOf(other.light.cache()));
    }
    for (std::size_t i = 0; i < arriving.size(); ++i)
        EXPECT_EQ(arriving[i].irradiance, expected[i].irradiance) << i;
}

TEST(Steps, TakeLightThatIsNoNumberForDarkness) {
    test::SceneBuilder b;
    test::addRoom(b, {0, 0, 0}, {4, 3, 4}, b.material(test::matte(0.5F)));
    b.box({1, 1, 1}, {1.2F, 1.2F, 1.2F}, b.material(test::emitter({1e38F, 1e38F, 1e38F})));
    Scene scene = b.finish();
    scene.lights = {test::pointLight({3, 2, 3}, 1)};
    test::GatheringScene room(std::move(scene));
    room.addReceiversOfBox({0, 0, 0}, {4, 3, 4}, 200, 0.006F);
    room.learn(3);
    for (const Receiver& receiver : room.receivers) EXPECT_TRUE(isFinite(room.at(receiver)));
}

TEST(Steps, WithoutReceiversOrRaysDoNothing) {
    test::GatheringScene room(test::furnishedRoom());
    EXPECT_TRUE(room.light.step({}, {}, {0, 0}, 2));
    EXPECT_TRUE(room.light.step({}, {}, room.budget, 2));
    EXPECT_EQ(room.light.cache().size(), 0U);
}

} // namespace
} // namespace rtcore

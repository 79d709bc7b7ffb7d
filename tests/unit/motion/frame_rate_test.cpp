// The same keys at the same moments give the same path, whatever the rate of frames.
#include "walk_world.h"

#include "support/key_script.h"
#include "support/random_numbers.h"

#include <cstdint>
#include <utility>
#include <vector>

using rtcore::MotionMode;
using test::kSecond;
using test::metres;
using test::WalkWorld;

namespace {

WalkWorld furnished() {
    WalkWorld world;
    world.floor(0, 8);
    test::Random random(5);
    for (int i = 0; i < 30; ++i) {
        const double x = 12 * test::fraction(random) - 6, y = 12 * test::fraction(random) - 6,
                     h = 1.5 * test::fraction(random);
        world.box(metres(x, y, -1), metres(x + 0.7, y + 0.9, h));
    }
    for (const double side : {-8.0, 8.0}) {
        world.box(metres(side - 0.1, -9, -1), metres(side + 0.1, 9, 6));
        world.box(metres(-9, side - 0.1, -1), metres(9, side + 0.1, 6));
    }
    return world;
}

template <typename NextFrame>
std::vector<rtcore::Camera> play(WalkWorld& world, MotionMode mode, NextFrame&& nextFrame) {
    const auto player = world.player(7, 7, 0.01);
    EXPECT_TRUE(player->setMode(mode));
    constexpr std::int64_t kUntil = 12 * kSecond;
    return test::playKeys(*player, test::randomEvents(9, kUntil), kUntil, nextFrame);
}

} // namespace

TEST(FrameRate, DoesNotChangeThePath) {
    WalkWorld world = furnished();
    for (const MotionMode mode : {MotionMode::Walk, MotionMode::View}) {
        const auto expected = play(world, mode, [] { return kSecond / 60; });
        ASSERT_EQ(expected.size(), 120U);
        EXPECT_NE(expected.front().eye, expected.back().eye);
        for (const double rate : {5.0, 7.3, 24.0, 59.94, 144.0, 500.0}) {
            const auto frame = static_cast<std::int64_t>(static_cast<double>(kSecond) / rate);
            EXPECT_EQ(play(world, mode, [=] { return frame; }), expected) << rate;
        }
        test::Random random(77);
        EXPECT_EQ(play(world, mode, [&] { return std::int64_t(1 + random.index(kSecond / 5)); }), expected);
    }
}

TEST(FrameRate, OrderOfTrianglesDoesNotMatter) {
    WalkWorld world = furnished(), shuffled = furnished();
    test::Random random(3);
    auto& triangles = shuffled.mesh().triangles;
    for (std::size_t i = triangles.size(); i > 1; --i)
        std::swap(triangles[i - 1], triangles[random.index(i)]);
    const auto a = play(world, MotionMode::Walk, [] { return kSecond / 60; });
    const auto b = play(shuffled, MotionMode::Walk, [] { return kSecond / 60; });
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT(length(a[i].eye - b[i].eye), 1e-5F);
}

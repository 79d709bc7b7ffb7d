// Floors among tables, roofs and slopes.
#include "rtcore/plans/storeys.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace rtcore;
using test::Solids;

constexpr Colour kConcrete{0.5F, 0.5F, 0.5F};

/// Slabs at -.2..0, 2.8..3 and 5.8..6 (the roof), a table on each, in metres times `unit`, up along z.
Scene house(float unit) {
    Solids solids;
    solids.begin("house", kConcrete);
    const auto box = [&](Vec3 lo, Vec3 hi) { solids.box(unit * lo, unit * hi); };
    for (const float height : {0.F, 3.F, 6.F}) box({0, 0, height - .2F}, {10, 8, height});
    for (const float height : {0.F, 3.F}) box({2, 2, height + .7F}, {4, 3, height + .75F});
    Scene scene = solids.scene();
    scene.up = {0, 0, 1};
    scene.metresPerUnit = 1 / unit;
    return scene;
}

TEST(Storeys, AreFloorsAndNeitherTablesNorTheRoof) {
    for (const float unit : {1.F, 1000.F, 0.5F}) {
        const std::vector<Storey> storeys = storeysOf(house(unit));
        ASSERT_EQ(storeys.size(), 2U) << unit;
        EXPECT_NEAR(storeys[0].height / unit, 0, 1e-5);
        EXPECT_NEAR(storeys[1].height / unit, 3, 1e-5);
        EXPECT_NEAR(storeys[1].area / unit / unit, 80, 1e-3);
    }
}

TEST(Storeys, HiddenPartsHaveNone) {
    Scene scene = house(1);
    scene.hiddenParts = std::make_shared<const std::vector<std::uint8_t>>(1, std::uint8_t{1});
    EXPECT_TRUE(storeysOf(scene).empty());
    EXPECT_TRUE(storeysOf(Scene{}).empty());
}

// By height a ramp has floors nowhere.
TEST(Storeys, OfARampAreNone) {
    Solids solids;
    solids.begin("ramp", kConcrete);
    solids.box({0, 0, 0}, {20, 5, 1}, false, false, test::turned({0, 1, 0}, -30, {0, 0, 10}));
    Scene scene = solids.scene();
    scene.up = {0, 0, 1};
    EXPECT_TRUE(storeysOf(scene).empty());
}

} // namespace

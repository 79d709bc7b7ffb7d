#include "rtcore/irradiance/outgoing_cells.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace rtcore {
namespace {

/// The finest cells have sides of 0.01.
OutgoingCells emptyCells() {
    OutgoingCells cells;
    cells.clear({{0, 0, 0}, {10.24F, 0, 0}});
    return cells;
}

OutgoingCells::Site siteAt(Vec3 point, float length, const OutgoingCells& cells, Vec3 normal = {0, 1, 0}) {
    return {cells.levelOf(length), point, normal, length};
}

TEST(OutgoingCells, AreAsLargeAsAnEighthOfTheRay) {
    const OutgoingCells cells = emptyCells();
    EXPECT_EQ(cells.levelOf(0), 0);
    EXPECT_EQ(cells.levelOf(0.15F), 0);
    EXPECT_EQ(cells.levelOf(0.17F), 1);
    EXPECT_EQ(cells.levelOf(0.33F), 2);
    EXPECT_EQ(cells.levelOf(1e30F), OutgoingCells::kLevels - 1);
    EXPECT_EQ(cells.levelOf(std::numeric_limits<float>::infinity()), OutgoingCells::kLevels - 1);
}

TEST(OutgoingCells, HoldTheMeanOfTheirSamples) {
    OutgoingCells cells = emptyCells();
    const OutgoingCells::Site site = siteAt({1.005F, 2.005F, 3.005F}, 0.1F, cells);
    EXPECT_TRUE(cells.empty());
    EXPECT_EQ(cells.samples(site), 0U);
    EXPECT_FALSE(cells.radiance(site));
    for (int i = 0; i < 10; ++i) cells.add(site, {static_cast<float>(i), 1, 0});
    EXPECT_EQ(cells.samples(site), 10U);
    EXPECT_FLOAT_EQ(cells.radiance(site)->r, 4.5F);
    EXPECT_FLOAT_EQ(cells.radiance(site)->g, 1);
}

TEST(OutgoingCells, SidesAreApart) {
    OutgoingCells cells = emptyCells();
    const Vec3 point{1.005F, 2.005F, 3.005F};
    for (int i = 0; i < 10; ++i) {
        cells.add(siteAt(point, 0.1F, cells, {0, 1, 0}), {1, 1, 1});
        cells.add(siteAt(point, 0.1F, cells, {0.1F, -0.9F, 0.1F}), {5, 5, 5});
    }
    EXPECT_FLOAT_EQ(cells.radiance(siteAt(point, 0.1F, cells, {0.2F, 0.8F, 0}))->r, 1);
    EXPECT_FLOAT_EQ(cells.radiance(siteAt(point, 0.1F, cells, {0, -1, 0}))->r, 5);
}

TEST(OutgoingCells, CoarserOnesStandInForThoseThatKnowLittle) {
    OutgoingCells cells = emptyCells();
    const Vec3 point{1.005F, 2.005F, 3.005F};
    const OutgoingCells::Site site = siteAt(point, 0.1F, cells);
    cells.add(site, {100, 100, 100}); // one in a cell, many beside it
    for (int i = 0; i < 99; ++i) cells.add(siteAt(point + Vec3{0.01F, 0, 0}, 0.1F, cells), {1, 1, 1});
    EXPECT_EQ(cells.samples(site), 1U);
    EXPECT_LT(cells.radiance(site)->r, 3);
    for (int i = 0; i < 5; ++i) cells.add(site, {100, 100, 100});
    EXPECT_FLOAT_EQ(cells.radiance({site.level, point, site.normal, 0.01F})->r, 100); // short: not another's
}

TEST(OutgoingCells, SurfacesAreApart) {
    OutgoingCells cells = emptyCells();
    OutgoingCells::Site one = siteAt({0, 0, 0}, 0.1F, cells), other = one;
    one.surface = 1;
    other.surface = 2;
    cells.add(one, {2, 2, 2});
    EXPECT_FLOAT_EQ(cells.radiance(one)->r, 2);
    EXPECT_FALSE(cells.radiance(other));
}

TEST(OutgoingCells, FinerOnesAreReadOnceTheyKnowMuch) {
    OutgoingCells cells = emptyCells();
    const Vec3 point{1.005F, 2.005F, 3.005F};
    const OutgoingCells::Site here = siteAt(point, 0.2F, cells),
                              beside = siteAt(point + Vec3{0.01F, 0, 0}, 0.2F, cells);
    ASSERT_EQ(here.level, 1);
    for (int i = 0; i < 20; ++i) {
        cells.add(here, {4, 4, 4});
        cells.add(beside, {2, 2, 2});
    }
    EXPECT_FLOAT_EQ(cells.radiance(here)->r, 3); // one cell of their level
    for (int i = 0; i < 20; ++i) cells.add(here, {4, 4, 4});
    EXPECT_FLOAT_EQ(cells.radiance(here)->r, 4);
}

TEST(OutgoingCells, FinerOnesAreReadSoonerWhereSamplesDiffer) {
    OutgoingCells cells = emptyCells();
    const Vec3 point{1.005F, 2.005F, 3.005F};
    const OutgoingCells::Site lit = siteAt(point, 0.2F, cells),
                              dark = siteAt(point + Vec3{0.01F, 0, 0}, 0.2F, cells);
    for (int i = 0; i < 8; ++i) {
        cells.add(lit, {4, 4, 4});
        cells.add(dark, {0, 0, 0});
    }
    EXPECT_FLOAT_EQ(cells.radiance(lit)->r, 4);
    EXPECT_FLOAT_EQ(cells.radiance(dark)->r, 0);
}

TEST(OutgoingCells, RaysReadTheLevelsFromTheirOwnOn) {
    OutgoingCells cells = emptyCells();
    const Vec3 point{1.005F, 2.005F, 3.005F};
    for (int i = 0; i < 20; ++i) cells.add(siteAt(point, 5, cells), {3, 3, 3});
    EXPECT_FLOAT_EQ(cells.radiance(siteAt(point, 0.1F, cells))->r, 3); // coarser than its own, but known
    EXPECT_EQ(cells.samples(siteAt(point, 0.1F, cells)), 0U);
    EXPECT_EQ(cells.samples(siteAt(point, 8, cells)), 20U);
}

TEST(OutgoingCells, ManyCellsAreFoundAgainAndTakeTwiceTheirBytes) {
    OutgoingCells cells = emptyCells();
    const auto pointOf = [](int i) {
        return Vec3{0.02F * static_cast<float>(i % 300), 0, 0.02F * static_cast<float>(i / 300)};
    };
    for (int i = 0; i < 60000; ++i) {
        for (int k = 0; k < 8; ++k)
            cells.add(siteAt(pointOf(i), 0.1F, cells), Colour{1, 1, 1} * static_cast<float>(i));
    }
    for (int i = 0; i < 60000; i += 101)
        EXPECT_FLOAT_EQ(cells.radiance(siteAt(pointOf(i), 0.1F, cells))->r, static_cast<float>(i));
    EXPECT_GT(cells.size(), 60000U);
    EXPECT_LE(cells.memory(), cells.size() * 4 * 32);
}

TEST(OutgoingCells, ForgetThoseThatAreOldest) {
    OutgoingCells cells = emptyCells();
    const auto pointOf = [](int i) { return Vec3{0.32F * static_cast<float>(i), 0, 0}; };
    for (int i = 0; i < 4000; ++i)
        cells.add(siteAt(pointOf(i), 0.1F, cells), {1, 1, 1}, static_cast<std::uint32_t>(i));
    const std::size_t before = cells.size();
    cells.bound(before);
    EXPECT_EQ(cells.size(), before);
    cells.bound(before - 1);
    EXPECT_LT(cells.size(), before * 2 / 3);
    EXPECT_GT(cells.size(), before / 3);
    EXPECT_EQ(cells.samples(siteAt(pointOf(0), 0.1F, cells)), 0U);
    EXPECT_EQ(cells.samples(siteAt(pointOf(3999), 0.1F, cells)), 1U);
    cells.bound(10); // all as old, in the end
    cells.bound(10);
    cells.bound(10);
    EXPECT_LE(cells.size(), before / 3);
}

TEST(OutgoingCells, GoOnAfterTheyWereRestored) {
    constexpr Box3 kFlat{{0, 0, 0}, {10.24F, 0, 0}};
    OutgoingCells cells = emptyCells(), restored;
    const auto addSome = [](OutgoingCells& to, int seed) {
        for (int i = 0; i < 3000; ++i) {
            const float x = 0.01F * static_cast<float>(i * seed % 997), light = static_cast<float>(i % 13);
            to.add(siteAt({x, x / 3, 1}, 0.1F + x, to), {light, 1, 2}, static_cast<std::uint32_t>(i));
        }
    };
    addSome(cells, 7);
    const std::vector<OutgoingCells::Cell> state = cells.state();
    EXPECT_TRUE(OutgoingCells::areKeys(state));
    restored.restore(kFlat, state);
    EXPECT_EQ(restored.state(), state);
    EXPECT_EQ(restored.size(), cells.size());
    addSome(cells, 5);
    addSome(restored, 5);
    EXPECT_EQ(restored.state(), cells.state());
    cells.bound(cells.size() - 1);
    restored.bound(restored.size() - 1);
    EXPECT_EQ(restored.state(), cells.state());
    restored.restore(kFlat, {});
    EXPECT_TRUE(restored.empty());
}

TEST(OutgoingCells, TakeNoKeysThatAreNone) {
    const auto areKeys = [](const std::vector<std::uint64_t>& keys) {
        std::vector<OutgoingCells::Cell> cells;
        for (const std::uint64_t key : keys) cells.push_back({key, {1, 1, 1}, 1, 1});
        return OutgoingCells::areKeys(cells);
    };
    EXPECT_TRUE(areKeys({}));
    EXPECT_TRUE(areKeys({1, 3, 5, 1001, ~std::uint64_t{0}}));
    EXPECT_FALSE(areKeys({1, 5, 3}));
    EXPECT_FALSE(areKeys({1, 3, 3}));
    EXPECT_FALSE(areKeys({0, 1}));
    EXPECT_FALSE(areKeys({1, 4}));
    std::vector<std::uint64_t> same; // all for one slot of a table of 2^20
    for (std::uint64_t i = 0; i < 100'000; ++i) same.push_back(i << 21 | 1);
    EXPECT_FALSE(areKeys(same));
    for (std::uint64_t& key : same) key |= (std::uint64_t{1} << 21) - 1; // the last one
    EXPECT_FALSE(areKeys(same));
    std::vector<std::uint64_t> beside;
    for (std::uint64_t i = 0; i < 100'000; ++i) beside.push_back(i << 1 | 1);
    EXPECT_TRUE(areKeys(beside));
}

TEST(OutgoingCells, TakeAnyNumbers) {
    OutgoingCells cells = emptyCells();
    const float infinite = std::numeric_limits<float>::infinity();
    for (const float odd : {infinite, -infinite, std::numeric_limits<float>::quiet_NaN(), 1e30F}) {
        const OutgoingCells::Site site = siteAt({odd, 0, odd}, odd, cells, {odd, 0, 0});
        cells.add(site, {1, 1, 1});
        EXPECT_FLOAT_EQ(cells.radiance(site)->r, 1);
    }
}

} // namespace
} // namespace rtcore

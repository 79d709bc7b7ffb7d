// Which of many lights are taken at a point, and how they are weighed.
#include "rtcore/shading/light/light_choice.h"

#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace rtcore {
namespace {

using Table = std::vector<std::vector<float>>; ///< what lights add, by light and point

/// Of each light, the points that take it and their weights; 0: not taken.
Table chosen(const Table& added, const std::vector<float>& shifts) {
    const std::size_t points = shifts.size(), room = points + kWaveBlock;
    LightChoice choice;
    choice.begin(points, added.size(), [&](std::size_t i) { return shifts[i]; });
    for (const std::vector<float>& light : added) {
        std::vector<float> grey(room);
        std::copy(light.begin(), light.end(), grey.begin());
        choice.weigh({grey.data(), grey.data(), grey.data()});
    }
    choice.end();
    Table weights;
    for (std::size_t light = 0; light < added.size(); ++light) {
        const LightChoice::Taken taken = choice.next();
        EXPECT_TRUE(std::ranges::is_sorted(taken.points));
        weights.emplace_back(points, 0.0F);
        for (std::size_t i = 0; i < taken.points.size(); ++i)
            weights.back().at(taken.points[i]) = taken.weights[i];
    }
    return weights;
}

/// Of very different strengths, some of them none.
Table manyLights(std::size_t lights, std::size_t points) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    Table added(lights, std::vector<float>(points));
    for (auto& light : added)
        for (float& each : light) each = unit(random) < 0.1F ? 0 : std::pow(unit(random), 6.0F);
    return added;
}

TEST(LightChoice, TakesFewAndTheMeanIsTheLightOfAll) {
    constexpr std::size_t kLights = 300, kShifts = 1024;
    const Table one = manyLights(kLights, 1);
    // The same point again and again, with all shifts.
    Table added;
    for (const auto& light : one) added.emplace_back(kShifts, light.front());
    std::vector<float> shifts(kShifts);
    for (std::size_t i = 0; i < kShifts; ++i) shifts[i] = (static_cast<float>(i) + 0.5F) / kShifts;
    const Table weights = chosen(added, shifts);
    double sum = 0, all = 0;
    for (const auto& light : one) all += light.front();
    for (std::size_t light = 0; light < kLights; ++light) {
        const double mean = std::accumulate(weights[light].begin(), weights[light].end(), 0.0) / kShifts;
        sum += mean * one[light][0];
        const double chance = LightChoice::kSteps * one[light][0] / all;
        if (chance == 0) continue;
        EXPECT_NEAR(mean, 1, 1.5 / (kShifts * chance)) << light << ": one shift more or less";
    }
    EXPECT_NEAR(sum, all, 1e-3 * all);
    for (std::size_t i = 0; i < kShifts; ++i) {
        const auto taken = std::ranges::count_if(weights, [&](const auto& light) { return light[i] > 0; });
        EXPECT_LE(static_cast<float>(taken), LightChoice::kSteps + 1);
        double value = 0;
        for (std::size_t light = 0; light < kLights; ++light) value += weights[light][i] * one[light][0];
        EXPECT_NEAR(value, all, 1.01 * all / LightChoice::kSteps) << "one step more or less";
    }
}

TEST(LightChoice, TakesWhatAddsMuchWithoutChance) {
    Table added(200, std::vector<float>(1, 1e-3F));
    added[150][0] = 5;
    added[20][0] = 3;
    for (const float shift : {0.0F, 0.3F, 0.999F}) {
        const Table weights = chosen(added, {shift});
        EXPECT_EQ(weights[150][0], 1);
        EXPECT_EQ(weights[20][0], 1);
        EXPECT_LE(std::ranges::count_if(weights, [](const auto& light) { return light[0] > 0; }), 3);
    }
}

TEST(LightChoice, TakesNothingWhereThereIsNoLight) {
    const Table weights = chosen(Table(50, std::vector<float>(3, 0.0F)), {0, 0.5F, 0.9F});
    for (const auto& light : weights) EXPECT_EQ(light, std::vector<float>(3, 0.0F));
}

TEST(LightChoice, IsTheSameForEachInstructionSet) {
    const Table added = manyLights(100, 131);
    std::vector<float> shifts(131);
    for (std::size_t i = 0; i < shifts.size(); ++i) shifts[i] = static_cast<float>(i) / 131;
    ASSERT_TRUE(useInstructionSet("scalar"));
    const Table expected = chosen(added, shifts);
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        EXPECT_EQ(chosen(added, shifts), expected) << name;
    }
    useInstructionSet("auto");
}

} // namespace
} // namespace rtcore

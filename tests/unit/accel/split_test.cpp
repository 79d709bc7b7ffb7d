#include "rtcore/accel/cost_model.h"
#include "rtcore/accel/events.h"
#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

using rtcore::Box3;
using rtcore::CostModel;
using rtcore::Event;
using rtcore::Split;

namespace {

struct Case {
    Box3 cell;
    std::vector<Box3> boxes;
    CostModel cost;
};

Case randomCase(test::Random& random, bool onLattice) {
    Case c;
    c.cell = {{-4, -2, -8}, {4, 2, 8}};
    c.cost = {1, random.number(0.1F, 3), random.number(0.2F, 1)};
    c.boxes.resize(1 + random.index(30)); // below and above what one vector holds
    for (Box3& box : c.boxes) {
        for (int axis = 0; axis < 3; ++axis) {
            float a = random.number(c.cell.lo[axis], c.cell.hi[axis]);
            float b = random.index(5) == 0 ? a : random.number(c.cell.lo[axis], c.cell.hi[axis]);
            if (onLattice) {
                a = std::floor(a);
                b = std::floor(b);
            }
            box.lo[axis] = std::min(a, b);
            box.hi[axis] = std::max(a, b);
        }
    }
    return c;
}

struct Sides {
    std::uint32_t lower = 0;
    std::uint32_t upper = 0;
};

Sides sidesOf(const Case& c, int axis, float position, bool planarLower) {
    Sides n;
    for (const Box3& box : c.boxes) {
        if (box.lo[axis] == position && box.hi[axis] == position) {
            (planarLower ? n.lower : n.upper) += 1;
            continue;
        }
        n.lower += box.lo[axis] < position ? 1 : 0;
        n.upper += box.hi[axis] > position ? 1 : 0;
    }
    return n;
}

/// The surface area heuristic from its definition, in double.
double costOf(const Case& c, int axis, float position, bool planarLower) {
    const auto [lower, upper] = sidesOf(c, axis, position, planarLower);
    const auto area = [&](float from, float to) {
        std::array<double, 3> d{};
        for (int a = 0; a < 3; ++a) {
            d[static_cast<std::size_t>(a)] = a == axis ? to - from : c.cell.hi[a] - c.cell.lo[a];
        }
        return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
    };
    const double whole = area(c.cell.lo[axis], c.cell.hi[axis]);
    const double expected =
        c.cost.traversal +
        c.cost.intersection *
            (area(c.cell.lo[axis], position) * lower + area(position, c.cell.hi[axis]) * upper) / whole;
    return lower == 0 || upper == 0 ? expected * c.cost.emptyFactor : expected;
}

double cheapestCost(const Case& c, int axis) {
    double best = std::numeric_limits<double>::infinity();
    for (const Box3& box : c.boxes) {
        for (const float position : {box.lo[axis], box.hi[axis]}) {
            if (position <= c.cell.lo[axis] || position >= c.cell.hi[axis]) continue;
            best = std::min({best, costOf(c, axis, position, false), costOf(c, axis, position, true)});
        }
    }
    return best;
}

Split sweep(const Case& c, int axis) {
    std::vector<Event> events(2 * c.boxes.size());
    Event* out = events.data();
    for (std::uint32_t i = 0; i < c.boxes.size(); ++i) {
        out = rtcore::writeEvents(c.boxes[i], axis, i, out);
    }
    std::sort(events.data(), out);
    return rtcore::cheapestSplit(events.data(), static_cast<std::size_t>(out - events.data()),
                                 static_cast<std::uint32_t>(c.boxes.size()), c.cell, axis, c.cost);
}

} // namespace

TEST(CheapestSplit, IsTheOneThatBruteForceFinds) {
    test::Random random(5);
    for (int round = 0; round < 2000; ++round) {
        const Case c = randomCase(random, round % 2 == 0);
        for (int axis = 0; axis < 3; ++axis) {
            const Split split = sweep(c, axis);
            const double expected = cheapestCost(c, axis);
            if (!split.valid()) {
                EXPECT_TRUE(std::isinf(expected));
                continue;
            }
            EXPECT_EQ(split.axis, axis);
            EXPECT_NEAR(split.cost, expected, 1e-5 * expected);
            EXPECT_NEAR(costOf(c, axis, split.position, split.planarLower), expected, 1e-5 * expected);
            const Sides sides = sidesOf(c, axis, split.position, split.planarLower);
            EXPECT_EQ(split.lower, sides.lower);
            EXPECT_EQ(split.upper, sides.upper);
        }
    }
}

TEST(CheapestSplit, IsStrictlyInsideTheCell) {
    Case c;
    c.cell = {{0, 0, 0}, {1, 1, 1}};
    c.boxes = {c.cell, {{0, 0, 0}, {0, 1, 1}}, {{1, 0, 0}, {1, 1, 1}}};
    for (int axis = 0; axis < 3; ++axis) EXPECT_FALSE(sweep(c, axis).valid());
    EXPECT_FALSE(rtcore::cheapestSplit(nullptr, 0, 0, c.cell, 0, c.cost).valid());
}

TEST(CheapestSplit, CutsOffEmptySpaceAtHalfTheBonus) {
    Case c;
    c.cell = {{0, 0, 0}, {4, 1, 1}};
    c.boxes.assign(3, {{3, 0, 0}, {4, 1, 1}});
    c.cost.emptyFactor = 0.5F;
    const Split split = sweep(c, 0);
    ASSERT_TRUE(split.valid());
    EXPECT_EQ(split.position, 3);
    // Areas: 3 of 9 for the upper cell; K_T 1, K_I 1, 3 triangles.
    EXPECT_FLOAT_EQ(split.cost, 0.5F * (1 + 3 * 3.0F / 9));
}

TEST(CheapestSplit, PutsAFlatTriangleOnTheCheaperSide) {
    Case c;
    c.cell = {{0, 0, 0}, {4, 1, 1}};
    c.boxes = {{{1, 0, 0}, {1, 1, 1}}};
    const Split split = sweep(c, 0);
    ASSERT_TRUE(split.valid());
    EXPECT_EQ(split.position, 1);
    EXPECT_TRUE(split.planarLower);
}

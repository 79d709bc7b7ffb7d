#include "rtcore/accel/events.h"

#include "rtcore/accel/event_sort.h"
#include "rtcore/simd/instruction_set.h"
#include "support/random_numbers.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

using rtcore::Box3;
using rtcore::Event;
using rtcore::EventKind;
using rtcore::Side;
using rtcore::Split;

namespace {

/// Boxes on a coarse lattice, so that planes coincide often; some are flat.
std::vector<Box3> latticeBoxes(std::size_t count, test::Random& random) {
    std::vector<Box3> boxes(count);
    for (Box3& box : boxes) {
        for (int axis = 0; axis < 3; ++axis) {
            box.lo[axis] = static_cast<float>(random.index(12)) - 6;
            box.hi[axis] = box.lo[axis] + static_cast<float>(random.index(4));
        }
    }
    return boxes;
}

std::vector<Event> eventsOf(const std::vector<Box3>& boxes, int axis) {
    std::vector<Event> events(2 * boxes.size());
    Event* out = events.data();
    for (std::uint32_t i = 0; i < boxes.size(); ++i) out = rtcore::writeEvents(boxes[i], axis, i, out);
    events.resize(static_cast<std::size_t>(out - events.data()));
    return events;
}

Side sideByDefinition(const Box3& box, const Split& split) {
    const float lo = box.lo[split.axis];
    const float hi = box.hi[split.axis];
    if (lo == split.position && hi == split.position) return split.planarLower ? Side::Lower : Side::Upper;
    if (hi <= split.position) return Side::Lower;
    return lo >= split.position ? Side::Upper : Side::Both;
}

} // namespace

TEST(Events, OrderedBitsSortAsFloatsDo) {
    const float infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> ascending{-infinity, -3e38F, -1.5F, -1, -1e-38F, -1e-45F, 0,
                                       1e-45F,    1e-38F, 1,     2,  3e38F,   infinity};
    for (std::size_t i = 0; i < ascending.size(); ++i) {
        EXPECT_EQ(rtcore::fromOrderedBits(rtcore::orderedBits(ascending[i])), ascending[i]);
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_LT(rtcore::orderedBits(ascending[j]), rtcore::orderedBits(ascending[i]));
        }
    }
    EXPECT_EQ(rtcore::orderedBits(-0.0F), rtcore::orderedBits(0.0F));
}

TEST(Events, AnEventHoldsPositionKindAndTriangle) {
    for (const EventKind kind : {EventKind::End, EventKind::Planar, EventKind::Start}) {
        const Event e = rtcore::makeEvent(-2.5F, kind, rtcore::kEventTriangleMask);
        EXPECT_EQ(rtcore::eventPosition(e), -2.5F);
        EXPECT_EQ(rtcore::eventKind(e), kind);
        EXPECT_EQ(rtcore::eventTriangle(e), rtcore::kEventTriangleMask);
    }
}

TEST(Events, EndsComeBeforePlanarOnesAndThoseBeforeStarts) {
    const Event end = rtcore::makeEvent(1, EventKind::End, 9);
    const Event planar = rtcore::makeEvent(1, EventKind::Planar, 5);
    const Event start = rtcore::makeEvent(1, EventKind::Start, 0);
    EXPECT_LT(end, planar);
    EXPECT_LT(planar, start);
    EXPECT_LT(start, rtcore::makeEvent(1.0000001F, EventKind::End, 0));
}

TEST(Events, AFlatBoxHasOneEvent) {
    const std::vector<Box3> boxes{{{0, 1, 2}, {0, 3, 4}}};
    ASSERT_EQ(eventsOf(boxes, 0).size(), 1U);
    EXPECT_EQ(rtcore::eventKind(eventsOf(boxes, 0)[0]), EventKind::Planar);
    EXPECT_EQ(eventsOf(boxes, 1).size(), 2U);
}

TEST(Events, ShortAndLongListsAreSorted) {
    test::Random random(1);
    for (const std::size_t count : {0UL, 1UL, 50UL, 900UL, 2000UL, 3000UL, 20000UL}) {
        for (const bool onLattice : {true, false}) {
            std::vector<Box3> boxes = latticeBoxes(count, random);
            for (Box3& box : boxes) {
                if (!onLattice) box.lo.x -= random.number(0, 1e-3F);
            }
            std::vector<Event> events = eventsOf(boxes, 0);
            std::vector<Event> expected = events;
            std::sort(expected.begin(), expected.end());
            rtcore::EventList scratch;
            rtcore::sortEvents(events.data(), events.size(), scratch);
            EXPECT_EQ(events, expected) << count;
        }
    }
}

TEST(Events, FewAreSortedInAnyOrderByEveryInstructionSet) {
    test::Random random(6);
    for (const std::string& name : rtcore::instructionSets()) {
        ASSERT_TRUE(rtcore::useInstructionSet(name));
        for (std::uint32_t count = 0; count < 130; ++count) {
            std::vector<Event> events;
            for (std::uint32_t i = 0; i < count; ++i) {
                const auto kind = static_cast<EventKind>(random.index(3));
                events.push_back(rtcore::makeEvent(random.number(-1, 1), kind, i));
            }
            std::vector<Event> expected = events;
            std::sort(expected.begin(), expected.end());
            rtcore::sortFewEvents(events.data(), events.size());
            EXPECT_EQ(events, expected) << name << ' ' << count;
        }
    }
    ASSERT_TRUE(rtcore::useInstructionSet("auto"));
}

TEST(Events, OfAMeshAreItsBoxesInOrder) {
    test::SampleMesh sample = test::soup(40'000, 0.1F, 3); // several slices, and more than one chunk
    sample.append(test::sheet(20, 1, 0.5F));
    sample.append(test::soup(100, 0.1F, 4).move({1000, 0, 0})); // most are in one slice
    const rtcore::Mesh mesh = sample.view();
    const auto lists = rtcore::makeEvents(mesh, mesh.bounds());
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<Box3> boxes(mesh.triangles.size());
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            for (int corner = 0; corner < 3; ++corner) boxes[i].extend(mesh.position(i, corner));
        }
        std::vector<Event> expected = eventsOf(boxes, axis);
        std::sort(expected.begin(), expected.end());
        const rtcore::EventList& list = lists[static_cast<std::size_t>(axis)];
        EXPECT_TRUE(std::equal(expected.begin(), expected.end(), list.data(), list.data() + list.size()));
    }
}

TEST(Events, AlongTheSplitTrianglesAreDividedByTheirBoxes) {
    test::Random random(2);
    for (int round = 0; round < 300; ++round) {
        const std::vector<Box3> boxes = latticeBoxes(40, random);
        const int axis = round % 3;
        std::vector<Event> events = eventsOf(boxes, axis);
        std::sort(events.begin(), events.end());
        const Split split{0, static_cast<float>(random.index(9)) - 5, axis, random.coin(), 0, 0};
        std::vector<Side> sides(boxes.size(), Side::Both);
        std::vector<std::uint32_t> straddling;
        std::vector<Event> expectedLower;
        std::vector<Event> expectedUpper;
        for (const Event e : events) {
            const Side side = sideByDefinition(boxes[rtcore::eventTriangle(e)], split);
            if (side == Side::Lower) expectedLower.push_back(e);
            if (side == Side::Upper) expectedUpper.push_back(e);
        }
        std::vector<Event> lower(events.size() + 1);
        const auto parts =
            rtcore::divideAlong(events.data(), events.size(), split, sides.data(), lower.data(), straddling);

        std::size_t both = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            EXPECT_EQ(sides[i], sideByDefinition(boxes[i], split));
            both += sides[i] == Side::Both ? 1 : 0;
        }
        ASSERT_EQ(straddling.size(), both);
        for (std::size_t i = 0; i < straddling.size(); ++i) {
            EXPECT_EQ(sides[straddling[i]], Side::Both);
            if (i == 0) continue;
            EXPECT_LE(boxes[straddling[i - 1]].lo[axis], boxes[straddling[i]].lo[axis]);
        }
        lower.resize(parts.lower);
        EXPECT_EQ(lower, expectedLower);
        const auto upper = events.begin() + static_cast<std::ptrdiff_t>(parts.upperFirst);
        EXPECT_EQ(std::vector<Event>(upper, upper + static_cast<std::ptrdiff_t>(parts.upper)), expectedUpper);
        EXPECT_LE(parts.upperFirst + parts.upper + 2 * both, events.size());
    }
}

TEST(Events, PartitionKeepsTheOrderAlsoInPlace) {
    test::Random random(3);
    const std::vector<Box3> boxes = latticeBoxes(200, random);
    std::vector<Event> events = eventsOf(boxes, 1);
    std::sort(events.begin(), events.end());
    std::vector<Side> sides(boxes.size());
    for (Side& side : sides) side = static_cast<Side>(random.index(3));
    std::vector<Event> expectedLower;
    std::vector<Event> expectedUpper;
    for (const Event e : events) {
        const Side side = sides[rtcore::eventTriangle(e)];
        if (side == Side::Lower) expectedLower.push_back(e);
        if (side == Side::Upper) expectedUpper.push_back(e);
    }

    std::vector<Event> lower(events.size() + 1);
    const auto counts =
        rtcore::partition(events.data(), events.size(), sides.data(), lower.data(), events.data());
    lower.resize(counts.lower);
    events.resize(counts.upper);
    EXPECT_EQ(lower, expectedLower);
    EXPECT_EQ(events, expectedUpper);
}

TEST(Events, MergingKeepsAllInOrder) {
    test::Random random(4);
    for (const std::size_t old : {0UL, 1UL, 100UL}) {
        for (const std::size_t added : {0UL, 1UL, 100UL}) {
            std::vector<Event> events(old);
            std::vector<Event> more(added);
            for (auto* list : {&events, &more}) {
                for (Event& e : *list) {
                    e = rtcore::makeEvent(static_cast<float>(random.index(9)), EventKind::Start,
                                          random.index(99));
                }
                std::sort(list->begin(), list->end());
            }
            std::vector<Event> expected = events;
            expected.insert(expected.end(), more.begin(), more.end());
            std::sort(expected.begin(), expected.end());
            events.resize(old + added);
            EXPECT_EQ(rtcore::mergeEvents(events.data(), old, more), old + added);
            EXPECT_EQ(events, expected);
        }
    }
}

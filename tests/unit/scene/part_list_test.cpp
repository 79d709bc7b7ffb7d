// The parts of a model by name: found, hidden, shown.
#include "rtcore/scene/part_list.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace {

using rtcore::HiddenParts;
using rtcore::Model;
using rtcore::NamedPart;
using Flags = std::vector<std::uint8_t>;

/// Ten triangles: door 0-2, wall 3-4, nothing 5, door 6-9.
Model house() {
    rtcore::ModelBuffers b;
    b.triangles.resize(10);
    const std::uint32_t door = b.addName("door"), wall = b.addName("wall"), again = b.addName("door");
    b.parts = {{door, 0, 3}, {wall, 3, 2}, {again, 6, 4}};
    return makeModel(std::move(b));
}

TEST(NamedParts, OfOneNameAreOne) {
    const Model model = house();
    const std::vector<NamedPart> parts = namedParts(model);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].name, "door");
    EXPECT_EQ(parts[0].pieces, (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(parts[0].triangles, 7U);
    EXPECT_EQ(parts[1].name, "wall");
}

TEST(NamedParts, AreHiddenAndShown) {
    const Model model = house();
    const std::vector<NamedPart> parts = namedParts(model);
    const HiddenParts door = withParts(model, parts, Flags{1, 0}, true, nullptr);
    EXPECT_TRUE(isIn(parts[0], door));
    EXPECT_FALSE(isIn(parts[1], door));
    EXPECT_EQ(partTriangles(model, door), (Flags{1, 1, 1, 0, 0, 0, 1, 1, 1, 1}));
    const HiddenParts both = withParts(model, parts, Flags{0, 1}, true, door);
    EXPECT_EQ(partTriangles(model, both), (Flags{1, 1, 1, 1, 1, 0, 1, 1, 1, 1}));
    const HiddenParts wall = withParts(model, parts, Flags{1, 0}, false, both);
    EXPECT_EQ(partTriangles(model, wall), (Flags{0, 0, 0, 1, 1, 0, 0, 0, 0, 0}));
    EXPECT_EQ(withParts(model, parts, Flags{1, 1}, false, both), nullptr) << "nothing is hidden";
    EXPECT_TRUE(rtcore::sameParts(door, withParts(model, parts, Flags{1, 0}, true, nullptr)));
    EXPECT_FALSE(rtcore::sameParts(door, both));
    EXPECT_FALSE(rtcore::sameParts(door, nullptr));
}

} // namespace

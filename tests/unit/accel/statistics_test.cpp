#include "rtcore/accel/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <vector>

using rtcore::KdNode;
using rtcore::KdTree;

namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

long bars(const std::string& line) { return std::count(line.begin(), line.end(), '#'); }

} // namespace

TEST(Statistics, OfAHandMadeTree) {
    // A 2 x 1 x 1 box, split at x = 1; the upper cube is split at y = 0.25 into an empty leaf and one with
    // two.
    const std::vector<KdNode> nodes{KdNode::inner(0, 1, 1), KdNode::leaf(0, 3), KdNode::inner(1, 0.25F, 3),
                                    KdNode::leaf(3, 0), KdNode::leaf(3, 2)};
    const std::vector<std::uint32_t> references{0, 1, 2, 2, 3};
    const KdTree tree{nodes, references, {{0, 0, 0}, {2, 1, 1}}, nullptr};
    const rtcore::KdStatistics s = rtcore::computeStatistics(tree, 1, 0.5F);
    EXPECT_EQ(s.nodes, 5U);
    EXPECT_EQ(s.leaves, 3U);
    EXPECT_EQ(s.emptyLeaves, 1U);
    EXPECT_EQ(s.references, 5U);
    EXPECT_EQ(s.largestLeaf, 3U);
    EXPECT_EQ(s.depth, 2);
    EXPECT_DOUBLE_EQ(s.averageLeafDepth, 5.0 / 3);
    EXPECT_DOUBLE_EQ(s.averageFilledLeaf, 2.5);
    EXPECT_EQ(s.bytes, 5 * 8U + 5 * 4U);
    // Half areas: whole 5, a cube 3, the leaf above y = 0.25: 1 * .75 + .75 * 1 + 1 * 1 = 2.5.
    EXPECT_DOUBLE_EQ(s.expectedCost, 1 + 3.0 / 5 * (0.5 * 3) + 3.0 / 5 * 1 + 2.5 / 5 * (0.5 * 2));
    EXPECT_EQ(s.leavesBySize, (std::vector<std::uint64_t>{1, 0, 1, 1}));
    EXPECT_EQ(s.leavesByDepth, (std::vector<std::uint64_t>{0, 1, 2}));
}

TEST(Statistics, OfTheEmptyTree) {
    const std::vector<KdNode> nodes{KdNode::leaf(0, 0)};
    const rtcore::KdStatistics s = rtcore::computeStatistics({nodes, {}, {}, nullptr}, 1, 1);
    EXPECT_EQ(s.leaves, 1U);
    EXPECT_EQ(s.emptyLeaves, 1U);
    EXPECT_EQ(s.depth, 0);
    EXPECT_EQ(s.averageFilledLeaf, 0);
    EXPECT_EQ(s.expectedCost, 0);
}

TEST(Histogram, HasOneLineForEachValueWhenTheyFit) {
    const auto lines = linesOf(rtcore::drawHistogram("leaves by size", {10, 5, 0, 20}, 8));
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_EQ(lines[0], "leaves by size");
    EXPECT_EQ(bars(lines[1]), 25);
    EXPECT_EQ(bars(lines[2]), 13); // 12.5
    EXPECT_EQ(bars(lines[3]), 0);
    EXPECT_EQ(bars(lines[4]), 50);
    EXPECT_NE(lines[4].find(" 3 "), std::string::npos);
    EXPECT_NE(lines[4].find("20"), std::string::npos);
}

TEST(Histogram, JoinsValuesIntoBandsWithoutLosingAny) {
    const std::vector<std::uint64_t> counts(10, 1);
    for (const int bands : {1, 2, 3, 4, 5, 7, 10}) {
        const auto lines = linesOf(rtcore::drawHistogram("title", counts, bands));
        EXPECT_LE(lines.size(), static_cast<std::size_t>(bands) + 1);
        std::uint64_t sum = 0;
        for (std::size_t i = 1; i < lines.size(); ++i) {
            std::istringstream line(lines[i]);
            std::string range;
            std::uint64_t count = 0;
            line >> range >> count;
            sum += count;
        }
        EXPECT_EQ(sum, 10U);
    }
    const auto three = linesOf(rtcore::drawHistogram("title", counts, 3));
    EXPECT_NE(three[1].find("0-3"), std::string::npos);
    EXPECT_NE(three[3].find("8-9"), std::string::npos);
}

TEST(Histogram, OfNothingIsEmptyButValid) {
    for (const int bands : {-1, 0, 1, 5}) {
        const auto lines = linesOf(rtcore::drawHistogram("nothing", {}, bands));
        ASSERT_EQ(lines.size(), 2U);
        EXPECT_EQ(bars(lines[1]), 0);
    }
}

#include "rtcore/io/import/mesh/first_use.h"
#include "support/random_numbers.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

using rtcore::Triangle;

namespace {

/// One corner after another.
std::vector<std::uint32_t> numberedOneByOne(std::vector<Triangle>& triangles, std::size_t vertices) {
    constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    std::vector<std::uint32_t> numbers(vertices, kNone);
    std::vector<std::uint32_t> order;
    for (Triangle& t : triangles) {
        for (std::uint32_t& v : t.v) {
            if (numbers[v] == kNone) {
                numbers[v] = static_cast<std::uint32_t>(order.size());
                order.push_back(v);
            }
            v = numbers[v];
        }
    }
    return order;
}

void expectAsOneByOne(std::vector<Triangle> triangles, std::size_t vertices) {
    std::vector<Triangle> expected = triangles;
    const std::vector<std::uint32_t> order = numberedOneByOne(expected, vertices);
    EXPECT_TRUE(rtcore::renumberByFirstUse(triangles, vertices) == order);
    EXPECT_TRUE(triangles == expected);
}

} // namespace

TEST(FirstUse, NumbersVerticesInTheOrderOfCorners) {
    expectAsOneByOne({}, 0);
    expectAsOneByOne({}, 3);
    expectAsOneByOne({{{4, 2, 0}}, {{0, 2, 5}}, {{5, 1, 4}}}, 7);
}

TEST(FirstUse, IsTheSameBySeveralThreads) {
    constexpr int kTriangles = 1'100'000;
    test::Random random(7);
    for (const std::size_t vertices : {3U, 1000U, 200'000U}) {
        const auto vertex = [&] { return random.index(vertices); };
        std::vector<Triangle> triangles;
        for (int i = 0; i < kTriangles; ++i) triangles.push_back({{vertex(), vertex(), vertex()}});
        expectAsOneByOne(std::move(triangles), vertices);
    }
}

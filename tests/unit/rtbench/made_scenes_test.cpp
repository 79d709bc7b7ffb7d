/// The scenes that are made for rtbench, and the views of all of them.
#include "bench/rtbench/bench_view.h"
#include "bench/scenes/crowd_hall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

TEST(MadeScenes, TheCrowdIsOfSmallTrianglesInAHallOfSlenderOnes) {
    constexpr std::size_t kFigures = 50, kOfOne = 20'000;
    const test::SampleMesh sample = bench::crowdInHall();
    const rtcore::Mesh mesh = sample.view();
    const std::size_t hall = mesh.triangles.size() - kFigures * kOfOne;
    EXPECT_GT(hall, 10'000U);
    std::size_t slender = 0, small = 0;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        float longest = 0;
        for (int k = 0; k < 3; ++k)
            longest = std::max(longest, length(mesh.position(i, (k + 1) % 3) - mesh.position(i, k)));
        const float area = length(cross(mesh.position(i, 1) - mesh.position(i, 0),
                                        mesh.position(i, 2) - mesh.position(i, 0))) *
                           0.5F;
        EXPECT_GT(area, 0) << i;
        slender += std::fabs(longest * longest / (2 * area) - 1500) < 15 ? 1U : 0U;
        small += longest < 0.1F ? 1U : 0U;
    }
    EXPECT_EQ(slender, hall);
    EXPECT_EQ(small, kFigures * kOfOne);
    const rtcore::Box3 box = mesh.bounds();
    EXPECT_GE(std::min({box.lo.x, box.lo.y, box.lo.z}), 0);
    EXPECT_LE(std::max({box.hi.x / 30, box.hi.y / 6, box.hi.z / 12}), 1.001F);
}

TEST(MadeScenes, EverySceneHasThreeViews) {
    const rtbench::ViewFile file(RT_SOURCE_FOLDER "/tests/bench/views.toml");
    for (const char* scene :
         {"sibenik", "sponza", "bunny", "dragon_res2", "dragon", "lamborghini", "nave", "crowd", "slats"})
        EXPECT_EQ(file.viewsOf(scene).size(), 3U) << scene;
}

} // namespace

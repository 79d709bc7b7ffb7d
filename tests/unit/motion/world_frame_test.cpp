#include "rtcore/motion/nearby_triangles.h"
#include "rtcore/motion/world_frame.h"

#include "walk_world.h"

#include <algorithm>
#include <set>
#include <vector>

using rtcore::Box3;
using rtcore::Vec3;
using rtcore::WorldFrame;

TEST(WorldFrame, GoesThereAndBack) {
    test::Random random(1);
    for (int i = 0; i < 300; ++i) {
        const Vec3 up = i == 0   ? Vec3{0, 1, 0}
                        : i == 1 ? Vec3{0, 0, 1}
                        : i == 2 ? Vec3{-1, 0, 0}
                                 : random.unitVector();
        const WorldFrame frame(up, 0.0254);
        const Vec3 p = random.vector(100);
        EXPECT_LT(length(frame.toScene(frame.toMetres(p)) - p), 1e-4F);
        EXPECT_NEAR(frame.toMetres(up).z, 0.0254, 1e-7);
        EXPECT_LT(length(frame.up() - up), 1e-6F);
    }
}

TEST(WorldFrame, WrongUpIsReplaced) { EXPECT_EQ(WorldFrame({0, 0, 0}, 1).up(), (Vec3{0, 1, 0})); }

TEST(NearbyTriangles, FindsAllThatReachIn) {
    test::WalkWorld world;
    world.add(test::soup(3000, 0.1F, 4));
    const rtcore::Mesh mesh = world.view();
    test::Random random(5);
    for (int i = 0; i < 300; ++i) {
        Box3 box;
        box.extend(random.vector(1));
        box.extend(random.vector(1));
        std::vector<std::uint32_t> found;
        rtcore::findTriangles(world.tree(), box, found);
        ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
        const std::set<std::uint32_t> set(found.begin(), found.end());
        ASSERT_EQ(set.size(), found.size());
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            // Its middle inside is enough to be sure that it reaches in.
            const Vec3 middle = (mesh.position(t, 0) + mesh.position(t, 1) + mesh.position(t, 2)) / 3;
            bool inside = true;
            for (int axis = 0; axis < 3; ++axis) {
                inside = inside && middle[axis] >= box.lo[axis] && middle[axis] <= box.hi[axis];
            }
            if (inside) {
                ASSERT_TRUE(set.contains(t));
            }
        }
    }
}

#include "rtcore/scene/closed_surfaces.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace rtcore {
namespace {

using test::SceneBuilder;

std::size_t countClosed(const Scene& scene) {
    return static_cast<std::size_t>(std::count(scene.closed->begin(), scene.closed->end(), 1));
}

TEST(ClosedSurfaces, NothingWithoutTransparentMaterials) {
    SceneBuilder b;
    b.box({0, 0, 0}, {1, 1, 1}, b.material(test::matte(0.5F)));
    EXPECT_EQ(b.finish().closed, nullptr);
}

TEST(ClosedSurfaces, ABoxAndASphereAreClosed) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    b.box({0, 0, 0}, {1, 1, 1}, glass);
    b.sphere({5, 0, 0}, 1, 6, glass);
    const Scene scene = b.finish();
    EXPECT_EQ(countClosed(scene), scene.mesh().triangles.size());
}

TEST(ClosedSurfaces, ABoxWithoutOneFaceIsOpenAndDoesNotOpenItsNeighbour) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    b.box({0, 0, 0}, {1, 1, 1}, glass, 5);
    b.box({2, 0, 0}, {3, 1, 1}, glass);
    const Scene scene = b.finish();
    ASSERT_EQ(scene.closed->size(), 22U);
    EXPECT_EQ(std::count(scene.closed->begin(), scene.closed->begin() + 10, 0), 10);
    EXPECT_EQ(std::count(scene.closed->begin() + 10, scene.closed->end(), 1), 12);
}

TEST(ClosedSurfaces, TwoBoxesJoinedAlongAnEdgeAreNot) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    b.box({0, 0, 0}, {1, 1, 1}, glass);
    b.box({1, 1, 0}, {2, 2, 1}, glass);
    // The second box's edge x=1, y=1 takes the vertices of the first.
    for (auto& triangle : b.buffers.triangles) {
        for (auto& v : triangle.v) {
            if (v == 8 + 0) v = 3;
            if (v == 8 + 4) v = 7;
        }
    }
    EXPECT_EQ(countClosed(b.finish()), 0U);
}

TEST(ClosedSurfaces, TwoBoxesThatShareOneVertexAreBothClosed) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    b.box({0, 0, 0}, {1, 1, 1}, glass);
    b.box({1, 1, 1}, {2, 2, 2}, glass);
    for (auto& triangle : b.buffers.triangles) {
        for (auto& v : triangle.v) v = v == 8 ? 7 : v;
    }
    EXPECT_EQ(countClosed(b.finish()), 24U);
}

TEST(ClosedSurfaces, ABoxWithOneTriangleTurnedOverIsNot) {
    for (std::size_t turned = 0; turned < 12; ++turned) {
        SceneBuilder b;
        b.box({0, 0, 0}, {1, 1, 1}, b.material(test::glass()));
        std::swap(b.buffers.triangles[turned].v[0], b.buffers.triangles[turned].v[1]);
        EXPECT_EQ(countClosed(b.finish()), 0U) << turned;
    }
}

TEST(ClosedSurfaces, OpaqueTrianglesDoNotCloseAGlassOne) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    const auto opaque = b.material(test::matte(0.5F));
    b.box({0, 0, 0}, {1, 1, 1}, glass);
    b.buffers.shading[0].material = opaque;
    b.buffers.shading[1].material = opaque;
    EXPECT_EQ(countClosed(b.finish()), 0U);
}

TEST(ClosedSurfaces, ATriangleTwiceIsNot) {
    SceneBuilder b;
    b.box({0, 0, 0}, {1, 1, 1}, b.material(test::glass()));
    b.buffers.triangles.push_back(b.buffers.triangles[3]);
    b.buffers.shading.push_back(b.buffers.shading[3]);
    EXPECT_EQ(countClosed(b.finish()), 0U);
}

TEST(ClosedSurfaces, DegenerateTrianglesAreSafe) {
    SceneBuilder b;
    const auto glass = b.material(test::glass());
    b.box({0, 0, 0}, {1, 1, 1}, glass);
    b.triangle({5, 5, 5}, {5, 5, 5}, {5, 5, 5}, glass);
    b.triangle({6, 6, 6}, {6, 6, 6}, {7, 6, 6}, glass);
    b.buffers.triangles[13].v[1] = b.buffers.triangles[13].v[0];
    const Scene scene = b.finish();
    EXPECT_EQ(countClosed(scene), 12U);
    EXPECT_FALSE(scene.isClosed(13));
}

} // namespace
} // namespace rtcore

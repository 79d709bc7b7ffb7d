#include "rtcore/kernels/watertight.h"

#include "kernel_support.h"
#include "support/mesh_triangle.h"

using rtcore::Hit;
using rtcore::RayShear;
using rtcore::Vec3;

namespace {

test::SampleMesh rightTriangle() {
    test::SampleMesh mesh;
    mesh.addTriangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    return mesh;
}

bool hits(const test::SampleMesh& mesh, Vec3 origin, Vec3 direction, Hit& hit) {
    hit.t = test::kForever;
    const RayShear shear(direction);
    return rtcore::alongAxis(shear.kz, [&](auto kz) {
        return test::testTriangle<kz>(mesh.view(), 0, {origin, 0, direction, test::kForever}, shear, hit);
    });
}

} // namespace

TEST(Watertight, BarycentricCoordinatesBelongToTheSecondAndThirdCorner) {
    const test::SampleMesh mesh = rightTriangle();
    for (const float side : {1.0F, -1.0F}) { // from in front and from behind
        Hit hit;
        ASSERT_TRUE(hits(mesh, {0.5F, 0.25F, 3 * side}, {0, 0, -2 * side}, hit));
        EXPECT_EQ(hit.t, 1.5F);
        EXPECT_EQ(hit.u, 0.25F);
        EXPECT_EQ(hit.v, 0.125F);
        EXPECT_EQ(hit.triangle, 0U);
    }
}

TEST(Watertight, EdgesAndCornersBelongToTheTriangle) {
    const test::SampleMesh mesh = rightTriangle();
    for (const Vec3 p : {Vec3{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}) {
        for (const Vec3 direction : {Vec3{0, 0, -1}, {1, 0, -1}, {-0.25F, 0.5F, -1}}) {
            Hit hit;
            EXPECT_TRUE(hits(mesh, p - direction, direction, hit));
            EXPECT_FLOAT_EQ(hit.t, 1);
        }
    }
    Hit hit;
    EXPECT_FALSE(hits(mesh, {-1e-7F, 1, 1}, {0, 0, -1}, hit));
    EXPECT_FALSE(hits(mesh, {1.000001F, 1, 1}, {0, 0, -1}, hit));
}

TEST(Watertight, ATriangleSeenEdgeOnIsNotHit) {
    const test::SampleMesh mesh = rightTriangle();
    Hit hit;
    EXPECT_FALSE(hits(mesh, {-1, 0.5F, 0}, {1, 0, 0}, hit));
    EXPECT_FALSE(hits(mesh, {-1, -1, 0}, {1, 1, 0}, hit));
}

TEST(Watertight, EveryAxisMayDominate) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {1.0F, -1.0F}) {
            test::SampleMesh mesh = rightTriangle();
            mesh.map([&](Vec3 p) {
                Vec3 turned;
                turned[axis] = p.z;
                turned[(axis + 1) % 3] = p.x;
                turned[(axis + 2) % 3] = p.y;
                return turned;
            });
            Vec3 origin;
            origin[axis] = 3 * sign;
            origin[(axis + 1) % 3] = 0.5F;
            origin[(axis + 2) % 3] = 0.25F;
            Vec3 direction;
            direction[axis] = -sign;
            Hit hit;
            ASSERT_TRUE(hits(mesh, origin, direction, hit));
            EXPECT_EQ(hit.t, 3);
            EXPECT_EQ(hit.u, 0.25F);
            EXPECT_EQ(hit.v, 0.125F);
        }
    }
}

TEST(Watertight, AtEqualDistanceTheLowerIndexStays) {
    test::SampleMesh mesh = rightTriangle();
    mesh.triangles.push_back(mesh.triangles[0]);
    const RayShear shear({0, 0, -1});
    const rtcore::Ray ray{{0.5F, 0.5F, 1}, 0, {0, 0, -1}, 1};
    for (const std::uint32_t first : {0U, 1U}) {
        Hit hit;
        hit.t = 1; // inclusive
        EXPECT_TRUE(test::testTriangle<2>(mesh.view(), first, ray, shear, hit));
        EXPECT_EQ(test::testTriangle<2>(mesh.view(), 1 - first, ray, shear, hit), first == 1);
        EXPECT_EQ(hit.triangle, 0U);
    }
}

TEST(Watertight, NonFiniteDistancesAreNoHits) {
    test::SampleMesh mesh;
    mesh.addTriangle({-3e38F, -3e38F, 3e38F}, {3e38F, -3e38F, 3e38F}, {0, 3e38F, 3e38F});
    Hit hit;
    EXPECT_FALSE(hits(mesh, {0, 0, -3e38F}, {0, 0, 1}, hit));
}

// Whether a model is looked at as a room or an object, and from where.
#include "rtcore/survey/default_view.h"
#include "rtcore/survey/framing.h"
#include "support/rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using rtcore::Axes;
using rtcore::Camera;
using rtcore::Survey;
using rtcore::Vec3;

const Vec3 kSky{0, 1, 0};

struct Seen {
    explicit Seen(test::SceneBuilder& builder, float metresPerUnit = 1)
        : scene(builder.finish()),
          survey(rtcore::survey(scene.tree, scene.scene.mesh(), Axes(kSky, metresPerUnit))),
          camera(rtcore::defaultCamera(scene.tree, scene.scene.mesh(), survey)) {}
    test::TracedScene scene;
    Survey survey;
    Camera camera;
};

/// A room of 4 x 2.7 x 5, from 0 on; a table of 2 x 1.2 in its middle.
test::SceneBuilder furnished(float scale = 1) {
    test::SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(0.7F));
    const auto box = [&](Vec3 low, Vec3 high) { b.box(low * scale, high * scale, white); };
    box({-2.2F, -0.2F, -2.7F}, {2.2F, 0, 2.7F});
    box({-2.2F, 2.7F, -2.7F}, {2.2F, 2.9F, 2.7F});
    for (const float side : {-1.0F, 1.0F}) {
        box({side * 2.1F - 0.1F, 0, -2.7F}, {side * 2.1F + 0.1F, 2.7F, 2.7F});
        box({-2, 0, side * 2.6F - 0.1F}, {2, 2.7F, side * 2.6F + 0.1F});
    }
    box({-1, 0.7F, -0.6F}, {1, 0.75F, 0.6F});
    return b;
}

TEST(FirstView, StandsInARoomAndNotUnderItsTable) {
    for (const float scale : {1.0F, 1000.0F, 3.28F}) {
        test::SceneBuilder room = furnished(scale);
        const Seen seen(room, 1 / scale);
        ASSERT_TRUE(seen.survey.inside()) << scale;
        EXPECT_NEAR(seen.camera.eye.y, 1.6F * scale, 0.01F * scale);
        EXPECT_NEAR(seen.camera.forward.y, 0, 1e-4);
        EXPECT_LT(std::fabs(seen.camera.eye.x), 1.7F * scale);
        EXPECT_LT(std::fabs(seen.camera.eye.z), 2.2F * scale);
    }
}

TEST(FirstView, IsFromOutsideWhereNobodyFits) {
    // The same as a box of centimetres.
    test::SceneBuilder box = furnished();
    const Seen seen(box, 0.01F);
    EXPECT_FALSE(seen.survey.inside());
    EXPECT_FALSE(seen.survey.subject.bounds.contains(seen.camera.eye));
}

TEST(FirstView, IsNotInTheVoidOfACeilingNorOfABuildingWithStoreys) {
    test::SceneBuilder b;
    const std::uint32_t white = b.material(test::matte(0.7F));
    for (int storey = 0; storey <= 3; ++storey) {
        const float z = 2.8F * static_cast<float>(storey);
        b.box({-5, z - 0.3F, -4}, {5, z, 4}, white);
        if (storey == 3) break;
        b.box({-4.9F, z + 2, -3.9F}, {4.9F, z + 2.02F, 3.9F}, white); // hung below
        for (const float side : {-1.0F, 1.0F}) {
            b.box({side * 4.9F - 0.1F, z, -4}, {side * 4.9F + 0.1F, z + 2.5F, 4}, white);
            b.box({-4.8F, z, side * 3.9F - 0.1F}, {4.8F, z + 2.5F, side * 3.9F + 0.1F}, white);
        }
    }
    const Seen seen(b);
    EXPECT_FALSE(seen.survey.inside());
    EXPECT_FALSE(seen.survey.subject.bounds.contains(seen.camera.eye));
}

TEST(FirstView, ShowsWhatStandsOnWideGroundOrUnderADome) {
    for (const bool dome : {false, true}) {
        test::SceneBuilder b = test::block();
        const std::uint32_t grey = b.material(test::matte(0.3F));
        b.square({0, -1, 0}, {0, 1, 0}, 100, grey);
        if (dome) b.sphere({0, 0, 0}, 200, 16, grey);
        const Seen seen(b);
        EXPECT_TRUE(seen.survey.subject.ground);
        EXPECT_EQ(!seen.survey.subject.domes.empty(), dome);
        EXPECT_EQ(seen.survey.subject.bounds.lo, Vec3(-1, -1, -1));
        EXPECT_EQ(seen.survey.subject.bounds.hi, Vec3(1, 1, 1));
        EXPECT_LT(length(seen.camera.eye), 10);
        EXPECT_GT(seen.camera.eye.y, -1);
    }
}

TEST(FirstView, TakesAPartOfAThingForNoSurroundings) {
    // A slab with a knob, and a tall cupboard with a knob.
    for (const Vec3 size : {Vec3{0.4F, 0.02F, 0.3F}, Vec3{0.6F, 1, 0.6F}}) {
        test::SceneBuilder b;
        const std::uint32_t grey = b.material(test::matte(0.3F));
        b.box(-size, size, grey);
        b.sphere({0, size.y, 0}, 0.02F, 8, grey);
        const Seen seen(b);
        EXPECT_GE(seen.survey.subject.bounds.size().x, 2 * size.x);
        EXPECT_FALSE(seen.survey.subject.ground);
    }
}

TEST(Framing, HasEqualMarginsOnOppositeSides) {
    test::SceneBuilder b;
    const std::uint32_t grey = b.material(test::matte(0.3F));
    b.box({-2, -1, -5}, {2, 1, 1}, grey);
    b.box({-0.3F, 1, 0.5F}, {0.3F, 1.6F, 1}, grey);
    const test::TracedScene s(b.finish());
    const rtcore::Mesh& mesh = s.scene.mesh();
    for (const float aspect : {0.5F, 16.0F / 9, 4.0F}) {
        for (const Vec3 forward : {Vec3{0, 0, -1}, {-0.4F, -0.3F, -0.9F}, {0.5F, -0.9F, -0.2F}}) {
            Camera camera;
            camera.forward = normalize(forward);
            camera.horizontalFov = 70;
            const Vec3 right = normalize(cross(camera.forward, {0, 1, 0}));
            camera.up = cross(right, camera.forward);
            camera = rtcore::framed(mesh, mesh.bounds(), camera, aspect);
            rtcore::Box3 image;
            for (const rtcore::Vertex& vertex : mesh.vertices) {
                const Vec3 p = vertex.position() - camera.eye;
                const float depth =
                    dot(p, camera.forward) * std::tan(0.5F * 70 * std::numbers::pi_v<float> / 180);
                image.extend(Vec3{dot(p, right) / depth, dot(p, camera.up) * aspect / depth, 0});
            }
            EXPECT_NEAR(image.lo.x, -image.hi.x, 1e-3F);
            EXPECT_NEAR(image.lo.y, -image.hi.y, 1e-3F);
            EXPECT_NEAR(std::max(image.hi.x, image.hi.y), 0.88F, 1e-3F);
        }
    }
}

TEST(FirstView, LeavesOutWhatLiesFarOff) {
    test::SceneBuilder b;
    const std::uint32_t grey = b.material(test::matte(0.3F));
    b.sphere({0, 0, 0}, 1, 24, grey);
    b.triangle({500, 0, 0}, {500.1F, 0, 0}, {500, 0.1F, 0}, grey);
    EXPECT_LT(Seen(b).survey.subject.bounds.hi.x, 1.1F);
}

TEST(FirstView, LeavesOutCrumbsThatLieApart) {
    for (const auto& [size, kept] : {std::pair{0.02F, false}, {0.3F, true}}) {
        test::SceneBuilder b;
        const std::uint32_t grey = b.material(test::matte(0.3F));
        b.sphere({0, 0, 0}, 1, 24, grey);
        b.box({0, 4, 0}, {size, 4 + size, size}, grey);
        EXPECT_EQ(Seen(b).survey.subject.bounds.hi.y > 4, kept) << size;
    }
}

TEST(FirstView, LooksOverAHillThatIsInTheWay) {
    test::SceneBuilder b = test::block();
    const std::uint32_t grey = b.material(test::matte(0.3F));
    b.square({0, -1, 0}, {0, 1, 0}, 60, grey);
    const Camera free = Seen(b).camera;
    // Before where it stood.
    b.box({-1.5F, -1, 1.6F}, {4, 1.4F, 2.6F}, grey);
    b.box({-60, -1, 3}, {60, -0.9F, 60}, grey);
    const Seen seen(b);
    EXPECT_FALSE(seen.survey.subject.bounds.empty());
    EXPECT_NE(seen.camera.eye, free.eye);
}

} // namespace

/// The ground of the sky: what it looks like in the light and in the shadow, and what rays find of it.
#include "rtcore/look/look.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/default_view.h"
#include "rtcore/render/ground_tracer.h"
#include "rtcore/render/seen_object.h"
#include "rtcore/sky/scene_sky.h"
#include "unit/look/rooms.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace {

using rtcore::Colour;
using rtcore::HitWave;
using rtcore::RayKind;
using rtcore::RayWave;
using rtcore::Vec3;

constexpr float kFar = std::numeric_limits<float>::max();

/// A block between -1 and 1 under the sky of its look, with the sun as high as on its right.
class GroundOfABlock : public testing::Test {
  protected:
    GroundOfABlock() : s(test::block().finish()) {
        rtcore::Sky sky;
        sky.date.reset();
        sky.direction = {1, 1, 0};
        sky.ground = true;
        rtcore::setSky(s.scene, sky);
        settings.skyLight = {.on = true, .samples = 64};
        tracer = rtcore::withGround(std::shared_ptr<const rtcore::RayTracer>(&s.tracer, [](const auto*) {}),
                                    s.scene);
    }

    HitWave trace(Vec3 eye, Vec3 target, RayKind kind = RayKind::Primary) const {
        RayWave ray;
        ray.push({eye, 0, target - eye, kFar});
        HitWave hit;
        tracer->intersect(kind, ray, hit);
        return hit;
    }
    Colour seen(Vec3 eye, Vec3 target) const {
        RayWave ray;
        ray.push({eye, 0, normalize(target - eye), kFar});
        rtcore::WhittedIntegrator integrator(s.scene, *tracer, settings);
        integrator.trace(ray, std::vector<rtcore::SampleId>{{0, 0, 0}});
        return integrator.radiance().colourAt(0);
    }

    test::TracedScene s;
    rtcore::RenderSettings settings = test::exactSettings();
    std::shared_ptr<const rtcore::RayTracer> tracer;
};

TEST_F(GroundOfABlock, LooksLikeTheMapsGroundWhereNothingShadesIt) {
    for (const Vec3 target : {Vec3{9, -1, 3}, {4, -1, -15}, {20, -1, 0.5F}}) {
        const Vec3 eye{8, 4, 9};
        ASSERT_GE(trace(eye, target).triangle[0], s.scene.model.mesh.triangles.size());
        const Colour ground = seen(eye, target),
                     map = s.scene.environment()->radiance(target - eye, rtcore::TexelFilter::Bilinear);
        EXPECT_NEAR(ground.r, map.r, 0.02F * map.r);
        EXPECT_NEAR(ground.g, map.g, 0.02F * map.g);
        EXPECT_NEAR(ground.b, map.b, 0.02F * map.b);
    }
}

TEST_F(GroundOfABlock, TakesItsShadow) {
    const Vec3 eye{-8, 6, 9};
    const Colour open = seen(eye, {-1.5F, -1, 2}), shaded = seen(eye, {-1.5F, -1, 0});
    EXPECT_LT(shaded.r, 0.3F * open.r);
    EXPECT_GT(shaded.b, 0.02F * open.b) << "the sky still lights it";
}

TEST_F(GroundOfABlock, IsMetFromAboveBehindAllElse) {
    const std::uint32_t first = 12;
    ASSERT_EQ(s.scene.model.mesh.triangles.size(), first);
    EXPECT_LT(trace({0, 5, 0}, {0, 0, 0}).triangle[0], first) << "the block is nearer";
    const HitWave beside = trace({4, 5, 2}, {4, -1, 2});
    EXPECT_GE(beside.triangle[0], first);
    EXPECT_NEAR(beside.t[0], 1, 1e-3F);
    EXPECT_FALSE(trace({4, -5, 2}, {4, 3, 2}).isHit(0)) << "from below";
    EXPECT_FALSE(trace({0, -1, 200}, {0, -4, 201}).isHit(0)) << "it ends";
    EXPECT_FALSE(trace({4, 5, 2}, {4, -1, 2}, RayKind::Shadow).isHit(0)) << "nothing is hidden by it";
}

TEST_F(GroundOfABlock, HasTheHitOfItsTriangles) {
    const rtcore::Mesh& mesh = s.scene.mesh();
    for (const Vec3 target : {Vec3{4, -1, 2}, {-7, -1, 3}, {3, -1, -9}, {-2, -1, -2.5F}}) {
        const rtcore::Hit hit = trace({target.x, 3, target.z}, target).hit(0);
        ASSERT_LT(hit.triangle, mesh.triangles.size());
        const Vec3 at = mesh.position(hit.triangle, 0) * (1 - hit.u - hit.v) +
                        mesh.position(hit.triangle, 1) * hit.u + mesh.position(hit.triangle, 2) * hit.v;
        EXPECT_NEAR(at.x, target.x, 1e-3F);
        EXPECT_NEAR(at.z, target.z, 1e-3F);
        EXPECT_GT(mesh.geometricNormal(hit.triangle).y, 0);
    }
}

TEST_F(GroundOfABlock, IsNoPartOfTheModel) {
    rtcore::Camera camera;
    camera.eye = {4, 5, 2};
    camera.forward = {0, -1, 0.01F};
    camera.up = {0, 0, -1};
    const rtcore::CameraRays view(camera, 32, 32);
    EXPECT_TRUE(trace({4, 5, 2}, {4, -1, 2}).isHit(0));
    EXPECT_FALSE(rtcore::seenObject(s.scene, *tracer, view, 16, 16));
}

TEST_F(GroundOfABlock, IsShownUnderItsSkyAlone) {
    EXPECT_TRUE(s.scene.showsGround());
    rtcore::Scene scene = s.scene;
    scene.activeEnvironment = rtcore::kNoEnvironment;
    EXPECT_FALSE(scene.showsGround());
    scene = s.scene;
    scene.sky->ground = false;
    EXPECT_FALSE(scene.showsGround());
    rtcore::setSky(scene, std::nullopt);
    EXPECT_FALSE(scene.showsGround());
    rtcore::setSky(scene, s.scene.sky);
    EXPECT_TRUE(scene.showsGround());
    EXPECT_EQ(scene.ground, s.scene.ground) << "it is made once";
}

TEST(GroundOfAnUpAxis, LiesBelowForEachOfThem) {
    for (const Vec3 up : {Vec3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
        test::TracedScene s(test::block().finish());
        const auto ground = rtcore::makeGround(s.scene.model, up, rtcore::kWhite);
        const auto t = rtcore::distanceToGround(*ground, up * 5.0F, -up);
        ASSERT_TRUE(t);
        EXPECT_NEAR(*t, 6, 1e-3F);
        EXPECT_TRUE(rtcore::pointOnGround(*ground, up * -1.0F));
        EXPECT_GT(dot(ground->mesh.geometricNormal(13), up), 0);
    }
}

TEST(GroundOfALook, LiesBelowObjectsNotInRooms) {
    const Vec3 up{0, 1, 0};
    const auto groundFor = [&](const test::TracedScene& s) {
        return rtcore::lookLights(
                   rtcore::Look::Sky, s.tree, s.scene.mesh(),
                   rtcore::survey(s.tree, s.scene.mesh(), rtcore::Axes(up)),
                   rtcore::defaultCamera(s.tree, s.scene.mesh(),
                                         rtcore::survey(s.tree, s.scene.mesh(), rtcore::Axes(up))))
            .sky->ground;
    };
    EXPECT_TRUE(groundFor(test::TracedScene(test::block().finish())));
    EXPECT_FALSE(groundFor(test::TracedScene(test::room().finish())));
}

} // namespace

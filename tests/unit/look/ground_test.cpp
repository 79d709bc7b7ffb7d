/// The ground of the sky: what it looks like in the light and in the shadow, and what rays find of it.
#include "rtcore/look/lighting_preset.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/ground_tracer.h"
#include "rtcore/sky/scene_sky.h"
#include "rtcore/survey/default_view.h"
#include "rtcore/survey/seen_object.h"
#include "support/rooms.h"

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

/// The corners of its cells, and points between them, are where the triangles that have them are.
TEST(GroundThatFades, HasItsPointsInItsTriangles) {
    test::TracedScene s(test::block().finish());
    const std::size_t own = s.scene.model.mesh.triangles.size();
    for (const auto edge : {rtcore::GroundEdge::Far, rtcore::GroundEdge::Fades}) {
        const auto ground = rtcore::makeGround(s.scene.model, {0, 0, 1}, rtcore::kWhite, edge);
        const rtcore::Mesh& mesh = ground->mesh;
        EXPECT_EQ(mesh.triangles.size(), own + std::size_t{2} * ground->cells * ground->cells);
        for (int i = 0; i <= 40; ++i) {
            for (int j = 0; j <= 40; ++j) {
                const Vec3 p = ground->corner + ground->right * (static_cast<float>(i) / 40) +
                               ground->front * (static_cast<float>(j) / 40);
                const auto point = rtcore::pointOnGround(*ground, p);
                ASSERT_TRUE(point);
                const auto t = static_cast<std::uint32_t>(own + point->triangle);
                const Vec3 a = mesh.position(t, 0), b = mesh.position(t, 1), c = mesh.position(t, 2);
                EXPECT_LT(rtcore::length(a + (b - a) * point->u + (c - a) * point->v - p), 1e-4F)
                    << i << " " << j;
                EXPECT_GT(dot(mesh.geometricNormal(t), Vec3{0, 0, 1}), 0);
            }
        }
    }
}

TEST(GroundThatFades, IsSolidBelowTheModelAndGoneAtItsSides) {
    test::TracedScene s(test::block().finish());
    const auto ground =
        rtcore::makeGround(s.scene.model, {0, 1, 0}, rtcore::kWhite, rtcore::GroundEdge::Fades);
    const rtcore::Mesh& mesh = ground->mesh;
    ASSERT_EQ(mesh.alphas.size(), mesh.normals.size());
    const Vec3 middle = ground->corner + (ground->right + ground->front) * 0.5F;
    const float diagonal = s.scene.model.mesh.bounds().diagonal();
    for (std::size_t t = mesh.triangles.size() - 1; mesh.shading[t].material == s.scene.materials.size();
         --t) {
        for (int corner = 0; corner < 3; ++corner) {
            const float away = rtcore::length(mesh.position(static_cast<std::uint32_t>(t), corner) - middle),
                        alpha = mesh.alphas[mesh.shading[t].v[static_cast<std::size_t>(corner)]];
            EXPECT_TRUE(away > 0.5F * diagonal || alpha == 1) << away;
            EXPECT_TRUE(away < 2.5F * diagonal || alpha == 0) << away;
        }
    }
}

TEST(GroundOfALook, LiesBelowObjectsNotInRooms) {
    const Vec3 up{0, 1, 0};
    const auto groundFor = [&](const test::TracedScene& s) {
        return rtcore::presetLighting(
                   rtcore::LightingPreset::Sky, s.tree, s.scene.mesh(),
                   rtcore::survey(s.tree, s.scene.mesh(), rtcore::Axes(up)),
                   rtcore::defaultCamera(s.tree, s.scene.mesh(),
                                         rtcore::survey(s.tree, s.scene.mesh(), rtcore::Axes(up))))
            .sky->ground;
    };
    EXPECT_TRUE(groundFor(test::TracedScene(test::block().finish())));
    EXPECT_FALSE(groundFor(test::TracedScene(test::room().finish())));
}

} // namespace

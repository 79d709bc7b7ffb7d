// Guides show what surfaces have, also in mirrors and behind glass, whatever lights them.
#include "rtcore/render/guides.h"

#include "rtcore/render/image_renderer.h"
#include "sample_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace rtcore {
namespace {

constexpr int kSide = 16;
constexpr Colour kGreen{0.1F, 0.6F, 0.2F};

RenderSettings small() { return test::sampleSettings(kSide, kSide); }

Guides guidesOf(const Scene& scene, const RenderSettings& settings = small(),
                const Camera& camera = test::sampleCamera(), int threads = 1,
                GuideRays rays = GuideRays::All) {
    const test::TracedScene traced(scene);
    RenderControl control{.threads = threads};
    Guides guides;
    EXPECT_TRUE(FrameRenderer().renderGuides({traced.scene, traced.tracer, camera, settings}, 1, rays,
                                             control, guides));
    return guides;
}

/// From between two walls, of which the camera sees the one at z = 0, which faces it.
Camera between() {
    Camera camera;
    camera.eye = {0, 0, 5};
    camera.forward = {0, 0, -1};
    camera.horizontalFov = 30;
    return camera;
}

/// Walls of these materials, the second behind the camera.
Scene walls(const Material& seen, const Material& behind) {
    test::SceneBuilder b;
    b.square({0.1F, 0, 0}, {0, 0, 1}, 50, b.material(seen));
    b.square({0.1F, 0, 12}, {0, 0, -1}, 50, b.material(behind));
    b.scene.lights = {test::pointLight({1, 1, 4}, 40)};
    return b.finish();
}

Material green() {
    Material m = test::matte(0);
    m.diffuse = kGreen;
    return m;
}

void expectNear(Colour found, Colour expected) {
    EXPECT_NEAR(found.r, expected.r, 1e-4F);
    EXPECT_NEAR(found.g, expected.g, 1e-4F);
    EXPECT_NEAR(found.b, expected.b, 1e-4F);
}

Colour middleOf(const Guides& guides) { return guides.albedo.at(kSide / 2, kSide / 2); }
Vec3 middleNormal(const Guides& guides) { return guides.normals[kSide * kSide / 2 + kSide / 2]; }

TEST(Guides, AreThoseOfASurfaceThatScatters) {
    const Guides guides = guidesOf(walls(green(), test::matte(0.3F)), small(), between());
    expectNear(middleOf(guides), kGreen);
    EXPECT_NEAR(middleNormal(guides).z, 1, 1e-5F);
    EXPECT_EQ(guides.covered[0], 255);
}

TEST(Guides, ShowInMirrorsWhatThoseShow) {
    const Guides guides = guidesOf(walls(test::mirror(0.8F), green()), small(), between());
    expectNear(middleOf(guides), kGreen * 0.8F);
    EXPECT_NEAR(middleNormal(guides).z, 0.2F - 0.8F, 1e-4F) << "the mirror's own, and that of the wall in it";
}

TEST(Guides, ShowWhatIsBehindGlass) {
    test::SceneBuilder b;
    Material pane = test::glass();
    pane.transmission = {1, 0.5F, 0.25F};
    b.square({0.1F, 0, 2}, {0, 0, 1}, 50, b.material(pane));
    b.square({0.1F, 0, 0}, {0, 0, 1}, 50, b.material(green()));
    const Colour seen = middleOf(guidesOf(b.finish(), small(), between()));
    EXPECT_NEAR(seen.g / seen.r, 0.5F * kGreen.g / kGreen.r, 0.2F);
    EXPECT_NEAR(seen.b / seen.r, 0.25F * kGreen.b / kGreen.r, 0.1F);
    EXPECT_GT(seen.r, 0.7F * kGreen.r);
}

TEST(Guides, DimWhatShinesAndTheBackgroundToWhatSurfacesHave) {
    expectNear(middleOf(guidesOf(walls(test::emitter({10, 5, 1}), green()), small(), between())),
               {1, 0.5F, 0.1F});
    test::SceneBuilder b;
    b.square({0, 0, 20}, {0, 0, 1}, 1, b.material(green()));
    b.scene.background = {8, 4, 2};
    const Guides nothing = guidesOf(b.finish(), small(), between());
    expectNear(middleOf(nothing), {1, 0.5F, 0.25F});
    EXPECT_EQ(middleNormal(nothing), (Vec3{}));
    EXPECT_EQ(nothing.covered[0], 0);
}

TEST(Guides, DimTheEnvironmentToAMeanOfOneHalf) {
    test::SceneBuilder b;
    b.square({0, 0, 20}, {0, 0, 1}, 1, b.material(green()));
    HdrImage sky(8, 4);
    for (Colour& texel : sky.pixels) texel = {40, 60, 100};
    b.scene.environments = {
        std::make_shared<const Environment>(Environment::fromEquirectangular(sky, "sky"))};
    b.scene.activeEnvironment = 0;
    const Colour seen = middleOf(guidesOf(b.finish(), small(), between()));
    EXPECT_NEAR(luminance(seen), 0.5F, 0.01F);
    EXPECT_NEAR(seen.b / seen.r, 2.5F, 0.01F) << "of its own hue";
}

TEST(Guides, AreTakenAwayByFog) {
    Scene scene = walls(green(), green());
    scene.fog = {.kind = FogKind::Homogeneous, .density = 0.2F, .emission = {1, 1, 1}};
    const Colour seen = middleOf(guidesOf(scene, small(), between()));
    EXPECT_NEAR(seen.g, kGreen.g * std::exp(-0.2F * 5), 0.02F);
}

TEST(Guides, AreTheSameInAnyLightAndForAnySeed) {
    const Scene scene = test::softlyLitScene();
    RenderSettings settings = small();
    settings.integrator = Integrator::Path;
    const Guides lit = guidesOf(scene, settings);
    Scene dark = scene;
    for (SceneLight& each : dark.lights) each.light.on = 0;
    settings.path.seed = 7;
    settings.path.samples = 3;
    settings.ambientOcclusion.on = true;
    const Guides other = guidesOf(dark, settings);
    EXPECT_EQ(lit.albedo.pixels, other.albedo.pixels);
    EXPECT_EQ(lit.normals, other.normals);
    EXPECT_EQ(lit.covered, other.covered);
}

TEST(Guides, HaveTheSameBitsForAnyNumberOfThreads) {
    const Scene scene = test::foggyScene(FogKind::Exponential);
    RenderSettings settings = test::sampleSettings(70, 41);
    const Guides one = guidesOf(scene, settings, test::sampleCamera(), 1);
    for (const int threads : {2, 3}) {
        const Guides many = guidesOf(scene, settings, test::sampleCamera(), threads);
        EXPECT_EQ(many.albedo.pixels, one.albedo.pixels) << threads;
        EXPECT_EQ(many.normals, one.normals) << threads;
    }
}

TEST(Guides, AreBlurredByALensWithMoreRays) {
    RenderSettings settings = small();
    EXPECT_EQ(guideSettings(settings, GuideRays::All).antialiasing, 4);
    EXPECT_EQ(guideSettings(settings, GuideRays::Few).antialiasing, 2);
    settings.depthOfField.on = true;
    EXPECT_EQ(guideSettings(settings, GuideRays::All).antialiasing, 8);
    settings.depthOfField.fNumber = 1;
    settings.depthOfField.focus = 20;
    EXPECT_NE(guidesOf(test::sampleScene(), settings).albedo.pixels,
              guidesOf(test::sampleScene()).albedo.pixels);
}

/// What the passes of an image by paths had beside it.
TEST(Guides, ComeWithImagesByPathsWhetherTheyAreShownOrNot) {
    const test::TracedScene traced(test::softlyLitScene());
    RenderSettings settings = test::sampleSettings(40, 30);
    settings.integrator = Integrator::Path;
    settings.denoise.net = DenoiseNet::Base;
    const Camera camera = test::sampleCamera();
    const View view{traced.scene, traced.tracer, camera, settings};
    for (const int samples : {1, 5}) {
        settings.path.samples = samples;
        const auto images = makeImageRenderer(Integrator::Path);
        RenderControl control{.threads = 1};
        Frame alone, shown;
        ASSERT_TRUE(images->render(view, control, {.guides = true}, alone));
        int passes = 0;
        double before = 0;
        const auto show = [&](const ImagePass& pass) {
            ++passes;
            ASSERT_NE(pass.guides, nullptr);
            EXPECT_EQ(pass.block, passes == 1 ? 2 : 1) << "a quarter of the pixels at first";
            EXPECT_EQ(pass.guides->albedo.width, 40 / pass.block);
            EXPECT_EQ(pass.frame.radiance.width, 40 / pass.block);
            EXPECT_EQ(pass.guides->albedo.pixels == alone.guides.albedo.pixels, pass.samples > 1)
                << "few rays for the first";
            EXPECT_EQ(pass.surfaces, nullptr);
            EXPECT_GE(images->fraction(control), before);
            before = images->fraction(control);
            EXPECT_LT(before, 1);
        };
        ASSERT_TRUE(images->render(view, control, {.guides = true, .show = show}, shown));
        EXPECT_EQ(passes, samples == 1 ? 1 : 4) << "after 1, 2 and 4 samples";
        EXPECT_EQ(alone.guides.albedo.pixels, shown.guides.albedo.pixels);
        EXPECT_EQ(alone.guides.normals, shown.guides.normals);
        EXPECT_EQ(alone.radiance.pixels, shown.radiance.pixels);
        ASSERT_TRUE(images->render(view, control, {}, shown));
        EXPECT_TRUE(shown.guides.empty()) << "which were not asked for";
    }
}

TEST(Guides, AreLeftWhenStopped) {
    const test::TracedScene traced(test::sampleScene());
    RenderControl control{.threads = 1};
    control.cancel = true;
    Guides guides;
    EXPECT_FALSE(FrameRenderer().renderGuides(
        {traced.scene, traced.tracer, test::sampleCamera(), test::sampleSettings(40, 30)}, 1, GuideRays::All,
        control, guides));
}

} // namespace
} // namespace rtcore

// Views that begin with the light of a scene that is known.
#include "rtcore/render/learned_light.h"
#include "rtcore/render/ray_images.h"
#include "rtcore/render/view_light.h"

#include "sample_view.h"

#include <gtest/gtest.h>

#include <memory>

namespace rtcore {
namespace {

/// A closed room with a light, seen along itself.
class KeptViewLight : public testing::Test {
  protected:
    static Scene room() {
        test::SceneBuilder b;
        b.box({-3, -2, -4}, {3, 2, 4}, b.material(test::matte(0.6F)));
        b.box({-1, -2, -2}, {0, -1, -1}, b.material(test::matte(0.3F)));
        b.scene.lights = {test::pointLight({1, 1.5F, 0}, 10)};
        return b.finish();
    }
    KeptViewLight() {
        settings = test::sampleSettings(64, 40);
        settings.indirect.mode = IndirectMode::Live;
    }
    static Camera cameraAt(float x) {
        Camera camera;
        camera.eye = {x, 0, 3};
        return camera;
    }
    View viewAt(const Camera& camera) const { return {scene.scene, scene.tracer, camera, settings}; }
    /// Of views from side to side.
    std::shared_ptr<const IndirectState> learned(int threads = 2) const {
        LearnedLight light;
        RenderControl control{.threads = threads};
        light.begin(scene.scene, scene.tracer, settings);
        for (int i = 0; i < 4; ++i) {
            const Camera camera = cameraAt(0.3F * static_cast<float>(i));
            EXPECT_TRUE(light.learn(viewAt(camera), control));
        }
        EXPECT_GT(light.records(), 50U);
        return std::make_shared<const IndirectState>(light.state());
    }
    HdrImage imageFrom(RayImages& images, float x, int threads = 2) const {
        RenderControl control{.threads = threads};
        Frame frame;
        const Camera camera = cameraAt(x);
        EXPECT_TRUE(images.render(viewAt(camera), control, {}, frame));
        return frame.radiance;
    }
    static double meanOf(const HdrImage& image) {
        double sum = 0;
        for (const Colour& pixel : image.pixels) sum += luminance(pixel);
        return sum / static_cast<double>(image.pixels.size());
    }

    test::TracedScene scene{room()};
    RenderSettings settings;
};

TEST_F(KeptViewLight, HasTheSameBitsForAnyNumberOfThreads) {
    const auto light = learned(1);
    EXPECT_EQ(*learned(3), *light);
    RayImages one, three;
    one.beginWith(light);
    three.beginWith(light);
    EXPECT_EQ(imageFrom(one, 0.5F, 1).pixels, imageFrom(three, 0.5F, 3).pixels);
}

/// Whatever was rendered before it.
TEST_F(KeptViewLight, OfAViewDependsOnThatAlone) {
    RayImages images, others;
    images.beginWith(learned());
    others.beginWith(learned());
    imageFrom(others, -1.5F);
    imageFrom(others, 0.1F);
    EXPECT_EQ(imageFrom(images, 0.5F).pixels, imageFrom(others, 0.5F).pixels);
}

TEST_F(KeptViewLight, IsAsBrightAsThatOfTheViewAlone) {
    RayImages kept, alone;
    kept.beginWith(learned());
    const double bright = meanOf(imageFrom(alone, 0.4F));
    EXPECT_NEAR(meanOf(imageFrom(kept, 0.4F)) / bright, 1, 0.02);
    kept.beginWith(nullptr);
    EXPECT_EQ(imageFrom(kept, 0.4F).pixels, imageFrom(alone, 0.4F).pixels);
}

/// The wall behind is in no view.
TEST_F(KeptViewLight, LearnsWhatIsMissing) {
    const auto light = learned();
    ViewLight view;
    view.beginWith(light);
    RenderControl control{.threads = 2};
    Camera back = cameraAt(0);
    back.forward = {0, 0, 1};
    back.eye.z = -1;
    ASSERT_TRUE(view.learn(viewAt(back), control));
    const std::size_t before = light->irradiance.records.size(), of = view.light().cache().size() - before;
    EXPECT_GT(of, 10U);
    ASSERT_TRUE(view.learn(viewAt(cameraAt(0.3F)), control));
    EXPECT_LT(view.light().cache().size() - before, of / 2) << "nearly all of that is known";
    EXPECT_EQ(view.fraction(), 1);
}

TEST_F(KeptViewLight, WhenStoppedSaysSo) {
    LearnedLight light;
    RenderControl control{.threads = 2};
    light.begin(scene.scene, scene.tracer, settings);
    const Camera camera = cameraAt(0);
    ASSERT_TRUE(light.learn(viewAt(camera), control));
    const std::size_t records = light.records();
    control.cancel = true;
    Camera back = camera;
    back.forward = {0, 0, 1};
    EXPECT_FALSE(light.learn(viewAt(back), control));
    EXPECT_EQ(light.records(), records) << "what was learned stays";
    EXPECT_EQ(checkIndirectState(light.state()), std::nullopt);
}

} // namespace
} // namespace rtcore

#include "rtcore/render/image_renderer.h"

#include "sample_view.h"

#include "rtcore/settings/integrator_traits.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace rtcore {
namespace {

/// An image of one integrator, with and without being shown.
struct ShownImage {
    Frame alone, shown;
    std::vector<std::uint32_t> samples; ///< of the passes before it
    bool surfaces = true;               ///< all passes had those of the view, or none
    double fraction = 0;
    std::vector<ImageRemark> remarks;
};

ShownImage imageOf(Integrator integrator) {
    const test::TracedScene traced(test::softlyLitScene());
    RenderSettings settings = test::sampleSettings(70, 41, 2);
    settings.integrator = integrator;
    settings.path.samples = 5;
    const Camera camera = test::sampleCamera();
    const View view{traced.scene, traced.tracer, camera, settings};
    ImageRenderers images;
    ImageRenderer& renderer = images.of(integrator);
    EXPECT_EQ(&images.of(integrator), &renderer);
    ShownImage result;
    RenderControl control{.threads = 2};
    EXPECT_TRUE(renderer.render(view, control, {.aovs = true}, result.alone));
    const auto show = [&](const ImagePass& pass) {
        result.samples.push_back(pass.samples);
        result.surfaces = result.surfaces && pass.surfaces != nullptr && !pass.surfaces->empty();
        EXPECT_LT(renderer.fraction(control), 1);
    };
    EXPECT_TRUE(renderer.render(view, control, {.aovs = true, .show = show}, result.shown));
    result.fraction = renderer.fraction(control);
    result.remarks = renderer.remarks();
    return result;
}

TEST(ImageRenderer, OfEachIntegratorShowsImagesBeforeTheOneThatItGives) {
    for (const IntegratorTraits& traits : kIntegratorTraits) {
        const ShownImage image = imageOf(traits.integrator);
        EXPECT_EQ(image.alone.radiance.pixels, image.shown.radiance.pixels);
        EXPECT_EQ(image.alone.covered, image.shown.covered);
        EXPECT_EQ(image.alone.aovs.width(), 70);
        EXPECT_EQ(image.shown.aovs.width(), 70);
        ASSERT_FALSE(image.samples.empty());
        EXPECT_TRUE(std::ranges::is_sorted(image.samples));
        EXPECT_EQ(image.samples.front(), 1U);
        EXPECT_EQ(image.surfaces, traits.samplesAllLight) << "whose noise is filtered before it is shown";
        EXPECT_NEAR(image.fraction, 1, 1e-9);
    }
}

TEST(ImageRenderer, TellsOfTheLightThatPathsHave) {
    EXPECT_TRUE(imageOf(Integrator::Whitted).remarks.empty());
    const std::vector<ImageRemark> remarks = imageOf(Integrator::Path).remarks;
    ASSERT_FALSE(remarks.empty());
    EXPECT_EQ(remarks.back().text.english().substr(0, 17), "paths are lit by ");
    EXPECT_TRUE(remarks.back().detail);
    EXPECT_TRUE(remarks.back().ofScene);
}

TEST(ImageRenderer, StopsWhenItIsTold) {
    const test::TracedScene traced(test::sampleScene());
    const Camera camera = test::sampleCamera();
    for (const IntegratorTraits& traits : kIntegratorTraits) {
        RenderSettings settings = test::sampleSettings(70, 41, 2);
        settings.integrator = traits.integrator;
        RenderControl control{.threads = 1};
        control.cancel = true;
        Frame frame;
        const auto renderer = makeImageRenderer(traits.integrator);
        EXPECT_FALSE(renderer->render({traced.scene, traced.tracer, camera, settings}, control, {}, frame));
    }
}

} // namespace
} // namespace rtcore

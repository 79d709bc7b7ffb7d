// Every instruction set that this processor has gives the same bits.
#include "rtcore/post/bloom.h"
#include "rtcore/post/denoise.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/light_probe.h"
#include "rtcore/sampling/sample_id.h"
#include "rtcore/simd/instruction_set.h"

#include "sample_view.h"
#include "support/one_frame.h"
#include "support/srgb_code.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace rtcore {
namespace {

class InstructionSets : public testing::Test {
  protected:
    ~InstructionSets() override { useInstructionSet("auto"); }

    /// Renders with each instruction set and compares the bits.
    static void compare(const test::TracedScene& traced, const RenderSettings& settings) {
        ASSERT_TRUE(useInstructionSet("scalar"));
        const Frame expected = test::render(traced, settings);
        for (const std::string& name : instructionSets()) {
            ASSERT_TRUE(useInstructionSet(name));
            const Frame frame = test::render(traced, settings);
            EXPECT_EQ(hashOf(frame), hashOf(expected)) << name;
            EXPECT_EQ(frame.covered, expected.covered) << name;
            EXPECT_EQ(frame.statistics.rays, expected.statistics.rays) << name;
        }
    }
    static std::uint64_t hashOf(const Frame& frame) {
        return test::hashOf(std::as_bytes(std::span(frame.radiance.pixels)));
    }
};

TEST_F(InstructionSets, GiveTheSamePictures) {
    const test::TracedScene traced(test::sampleScene());
    for (const int antialiasing : {1, 3}) compare(traced, test::sampleSettings(101, 67, antialiasing));
}

TEST_F(InstructionSets, GiveTheSameHighlights) {
    Scene scene = test::sampleScene();
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        scene.materials[i].specular = {0.2F, 0.1F, 0.3F};
        scene.materials[i].shininess = static_cast<float>(i * i * 7); // 0 among them
    }
    compare(test::TracedScene(scene), test::sampleSettings(101, 67));
}

TEST_F(InstructionSets, GiveTheSameSoftShadows) {
    compare(test::TracedScene(test::softlyLitScene()), test::sampleSettings(101, 67, 2));
}

TEST_F(InstructionSets, GiveTheSameFog) {
    for (const FogKind kind : {FogKind::Homogeneous, FogKind::Exponential}) {
        const test::TracedScene traced(test::foggyScene(kind));
        for (const int shafts : {0, 3}) {
            for (const bool refractions : {true, false}) { // without, shadows are not tinted
                RenderSettings settings = test::sampleSettings(101, 67);
                settings.fog.shafts = shafts;
                settings.refractions = refractions;
                compare(traced, settings);
            }
        }
    }
}

TEST_F(InstructionSets, GiveTheSameDirections) {
    Camera camera = test::sampleCamera();
    for (const float fov : {1e-3F, 60.0F, 179.999F}) {
        camera.horizontalFov = fov;
        const CameraRays rays(camera, 1920, 1080);
        for (const std::string& name : instructionSets()) {
            ASSERT_TRUE(useInstructionSet(name));
            constexpr float step = 1.0F / 3;
            std::array<float, 64> dx{}, dy{}, dz{};
            rays.directions({32, 96, 24, 8, step}, dx.data(), dy.data(), dz.data());
            for (std::size_t i = 0; i < 64; ++i) {
                const int index = static_cast<int>(i);
                ASSERT_EQ(indexInBlock(columnInBlock(index), rowInBlock(index)), index);
                const float x = 32 + (static_cast<float>(24 + columnInBlock(index)) + 0.5F) * step;
                const float y = 96 + (static_cast<float>(8 + rowInBlock(index)) + 0.5F) * step;
                ASSERT_EQ(rays.at(x, y).direction, (Vec3{dx[i], dy[i], dz[i]})) << name << " " << i;
            }
        }
    }
}

namespace formulas = HWY_NAMESPACE;

LdrImage developedOneByOne(const Frame& frame, const RenderSettings& settings, float exposure) {
    const SrgbCurve curve;
    LdrImage image(frame.radiance.width, frame.radiance.height);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Colour c = frame.radiance.at(x, y);
            const Vec3 seen{c.r, c.g, c.b};
            const Vec3 shown = settings.toneMapping == ToneMapping::Luminance
                                   ? formulas::toneMapLuminance<float>(seen, exposure)
                                   : formulas::toneMapChannels<float>(seen, exposure);
            const float threshold =
                settings.dithering ? formulas::ditherThreshold(static_cast<float>(x), static_cast<float>(y))
                                   : 0.5F;
            const auto code = [&](float light) {
                return static_cast<std::uint8_t>(formulas::quantise(test::srgbCode(curve, light), threshold));
            };
            image.at(x, y) = {code(shown.x), code(shown.y), code(shown.z), 255};
        }
    }
    return image;
}

TEST_F(InstructionSets, DevelopAlike) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const std::array<float, 15> odd{0,    1e-40F, 1e-5F, 0.001F, 0.18F, 1,  3,   7,
                                    1000, 1e25F,  3e38F, inf,    nan,   -1, -inf};
    Frame frame;
    frame.radiance = HdrImage(225, 15);
    frame.covered.assign(frame.radiance.pixels.size(), 255);
    for (std::size_t i = 0; i < frame.radiance.pixels.size(); ++i) {
        frame.radiance.pixels[i] = {odd[i % 15], odd[i / 15 % 15], odd[i / 225]};
    }
    for (const ToneMapping toneMapping : {ToneMapping::Luminance, ToneMapping::Channels}) {
        RenderSettings settings;
        settings.toneMapping = toneMapping;
        for (const bool dithering : {false, true}) {
            settings.dithering = dithering;
            ASSERT_TRUE(useInstructionSet("scalar"));
            const float exposure = test::exposureFor(frame, settings.exposure);
            const LdrImage expected = test::develop(frame, settings, exposure);
            ASSERT_EQ(expected.pixels, developedOneByOne(frame, settings, exposure).pixels);
            for (const std::string& name : instructionSets()) {
                ASSERT_TRUE(useInstructionSet(name));
                EXPECT_EQ(test::exposureFor(frame, settings.exposure), exposure) << name;
                EXPECT_EQ(test::develop(frame, settings, exposure).pixels, expected.pixels) << name;
            }
        }
    }
}

TEST_F(InstructionSets, BloomAlike) {
    HdrImage image(133, 74);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = {unitFloat(mixBits(static_cast<std::uint32_t>(3 * i))), i % 97 == 0 ? 1e5F : 0.0F,
                           1};
    }
    RenderSettings settings;
    settings.width = image.width;
    settings.bloom.radius = 4;
    for (const BloomKernel kernel : {BloomKernel::Gaussian, BloomKernel::Airy}) {
        settings.bloom.kernel = kernel;
        ASSERT_TRUE(useInstructionSet("scalar"));
        const HdrImage expected = Bloom().apply(image, {}, {.settings = settings, .threads = 1});
        for (const std::string& name : instructionSets()) {
            ASSERT_TRUE(useInstructionSet(name));
            EXPECT_EQ(Bloom().apply(image, {}, {.settings = settings, .threads = 1}).pixels, expected.pixels)
                << name;
        }
    }
}

TEST_F(InstructionSets, MeasureLightAlike) {
    const test::TracedScene traced(test::softlyLitScene());
    const ProbedLight whole{&traced.scene};
    const Box3& bounds = traced.tree.bounds;
    const WhitePoint above{bounds.centre() + Vec3{0, 0.3F * bounds.size().y, 0}, {0, 1, 0}};
    const auto measure = [&] {
        LightProbe probe;
        probe.begin({&whole, 1}, traced.tracer, {});
        RenderControl control;
        control.threads = 1;
        std::vector<MeasuredLight> measured;
        EXPECT_TRUE(probe.irradiance({&above, 1}, {.relativeError = 0.05}, control, measured));
        return measured.at(0);
    };
    ASSERT_TRUE(useInstructionSet("scalar"));
    const MeasuredLight expected = measure();
    EXPECT_GT(expected.error, 0) << "there is something to sample";
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        EXPECT_EQ(measure().colour, expected.colour) << name;
    }
}

TEST_F(InstructionSets, DenoiseAlike) {
    RenderSettings settings = test::sampleSettings(101, 67);
    settings.areaLights.samples = 2;
    settings.denoise.passes = 3;
    const Frame frame = test::render(test::TracedScene(test::softlyLitScene()), settings);
    ASSERT_TRUE(useInstructionSet("scalar"));
    const HdrImage expected =
        Denoiser().apply(frame.radiance, frame.aovs, {.settings = settings, .threads = 1});
    EXPECT_NE(expected.pixels, frame.radiance.pixels);
    for (const std::string& name : instructionSets()) {
        ASSERT_TRUE(useInstructionSet(name));
        EXPECT_EQ(Denoiser().apply(frame.radiance, frame.aovs, {.settings = settings, .threads = 1}).pixels,
                  expected.pixels)
            << name;
    }
}

} // namespace
} // namespace rtcore

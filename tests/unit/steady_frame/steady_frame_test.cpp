// A frame like the one before it allocates nothing: counted by replacing operator new.
#include "rtcore/live/live_renderer.h"
#include "rtcore/post/develop.h"
#include "rtcore/post/effects.h"
#include "rtcore/render/frame_renderer.h"
#include "support/every_effect.h"

#include "../render/sample_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace {

std::atomic<std::uint64_t> allocations{0};
std::atomic<std::size_t> bytesInUse{0}, maxBytes{0};

void* allocate(std::size_t bytes, std::size_t alignment) {
    allocations.fetch_add(1, std::memory_order_relaxed);
    const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
    void* const memory = std::aligned_alloc(alignment, rounded > 0 ? rounded : alignment);
    if (memory == nullptr) throw std::bad_alloc();
    const std::size_t taken = ::malloc_usable_size(memory), now = bytesInUse.fetch_add(taken) + taken;
    for (std::size_t max = maxBytes; now > max && !maxBytes.compare_exchange_weak(max, now);) {
    }
    return memory;
}

void release(void* memory) {
    bytesInUse -= ::malloc_usable_size(memory);
    std::free(memory);
}

} // namespace

// Inlined by halves, GCC 12 takes free() for a mismatch with operator new, or the other way round.
[[gnu::noinline]] void* operator new(std::size_t bytes) { return allocate(bytes, alignof(std::max_align_t)); }
[[gnu::noinline]] void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { release(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { release(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    release(memory);
}

namespace rtcore {
namespace {

/// Renders and develops; returns how often memory was allocated meanwhile.
class Pictures {
  public:
    explicit Pictures(const Scene& scene) : traced_(scene) {}

    std::uint64_t make(const RenderSettings& settings, int threads) {
        const std::uint64_t before = allocations;
        control_.threads = threads;
        renderer_.collectAovs(effectsNeedAovs(settings));
        EXPECT_TRUE(renderer_.render({traced_.scene, traced_.tracer, test::sampleCamera(), settings},
                                     control_, frame_));
        const float exposure = developer_.exposure(frame_, settings.exposure, threads);
        developer_.develop(frame_, settings, exposure, threads, image_);
        return allocations - before;
    }
    const LdrImage& image() const { return image_; }

  private:
    test::TracedScene traced_;
    FrameRenderer renderer_;
    PictureDeveloper developer_;
    RenderControl control_;
    Frame frame_;
    LdrImage image_;
};

RenderSettings settingsWith(int antialiasing, bool shadows, int maxDepth) {
    RenderSettings settings = test::sampleSettings(150, 101, antialiasing);
    settings.shadows = shadows;
    settings.maxDepth = maxDepth;
    return settings;
}

TEST(SteadyFrame, TheCountIsTrue) {
    const std::uint64_t before = allocations;
    int* volatile kept = new int; // volatile: a pair of new and delete may be left out
    delete kept;
    EXPECT_EQ(allocations - before, 1U);
}

TEST(SteadyFrame, OfOneThreadAllocatesNothing) {
    for (const RenderSettings& settings : {settingsWith(1, true, 5), settingsWith(2, true, 5),
                                           settingsWith(1, false, 0), settingsWith(1, true, 30)}) {
        Pictures pictures(test::sampleScene());
        EXPECT_GT(pictures.make(settings, 1), 0U);
        const std::vector<Rgba8> first = pictures.image().pixels;
        EXPECT_EQ(pictures.make(settings, 1), 0U);
        EXPECT_EQ(pictures.make(settings, 1), 0U);
        EXPECT_EQ(pictures.image().pixels, first);
    }
}

TEST(SteadyFrame, OfFalseColoursAllocatesNothing) {
    Pictures pictures(test::sampleScene());
    RenderSettings settings = settingsWith(1, true, 5);
    settings.falseColours.on = true;
    EXPECT_GT(pictures.make(settings, 1), 0U);
    EXPECT_EQ(pictures.make(settings, 1), 0U);
}

TEST(SteadyFrame, OfALiveWalkAllocatesNothing) {
    const test::TracedScene traced(test::sampleScene());
    const RenderSettings settings = settingsWith(1, true, 5);
    LiveRenderer live;
    RenderControl control{.threads = 1};
    Frame frame;
    const auto walk = [&] {
        live.forget();
        const std::uint64_t before = allocations;
        for (int i = 0; i < 8; ++i) {
            Camera camera = test::sampleCamera();
            camera.eye.x += 0.02F * static_cast<float>(i);
            EXPECT_TRUE(live.render({traced.scene, traced.tracer, camera, settings}, 0.2 - 0.1 * (i % 2),
                                    control, frame));
        }
        return allocations - before;
    };
    EXPECT_GT(walk(), 0U);
    EXPECT_EQ(walk(), 0U);
    EXPECT_EQ(walk(), 0U);
}

/// The most bytes that a walk kept which began with a whole frame, beside its frame.
double bytesOfAWalk(const test::TracedScene& traced, double newSamples, RenderSettings settings) {
    RenderControl control{.threads = 1};
    LiveRenderer live;
    Frame frame;
    const View view{traced.scene, traced.tracer, test::sampleCamera(), settings};
    {
        FrameRenderer renderer;
        renderer.collectSeen(true);
        EXPECT_TRUE(renderer.render(view, control, frame));
    }
    const std::size_t before = bytesInUse;
    maxBytes = before;
    live.seed(LiveRenderer::planeOf(view), frame, 1);
    for (int i = 1; i < 4; ++i) {
        Camera camera = test::sampleCamera();
        camera.eye.x += 0.05F * static_cast<float>(i);
        EXPECT_TRUE(live.render({traced.scene, traced.tracer, camera, settings}, newSamples, control, frame));
    }
    return static_cast<double>(maxBytes - before);
}

/// The same for each pixel, without what does not depend on their number.
double bytesOfAPixel(const Scene& scene, double newSamples) {
    const test::TracedScene traced(scene);
    const RenderSettings large = test::sampleSettings(800, 500);
    RenderSettings small = large;
    small.width /= 2;
    small.height /= 2;
    const double more = bytesOfAWalk(traced, newSamples, large) - bytesOfAWalk(traced, newSamples, small);
    return more / (0.75 * large.width * large.height);
}

TEST(SteadyFrame, LiveFramesKeepAsManyBytesAsTheySay) {
    test::SceneBuilder floor;
    floor.square({0, 0, 0}, {0, 1, 0}, 10, floor.material(test::matte(0.5F)));
    floor.scene.lights = {test::pointLight({0, 4, 0}, 20)};
    const double few = bytesOfAPixel(floor.finish(), 0.01), max = bytesOfAPixel(test::sampleScene(), 1);
    RecordProperty("few", std::to_string(few));
    RecordProperty("most", std::to_string(max));
    EXPECT_LE(few, LiveRenderer::kBytesPerPixel);
    EXPECT_GT(few, 0.8 * LiveRenderer::kBytesPerPixel);
    EXPECT_LE(max, LiveRenderer::kMaxBytesPerPixel);
    EXPECT_GT(max, 0.7 * LiveRenderer::kMaxBytesPerPixel);
}

TEST(SteadyFrame, WithALensAndAdaptiveSamplesAllocatesNothing) {
    RenderSettings settings = settingsWith(3, true, 5);
    settings.sampling = SamplingPattern::Poisson;
    settings.depthOfField = {.on = true, .blades = 6};
    for (const float adaptive : {0.0F, 0.05F}) {
        settings.adaptive = adaptive;
        Pictures pictures(test::sampleScene());
        pictures.make(settings, 1);
        EXPECT_EQ(pictures.make(settings, 1), 0U);
    }
}

TEST(SteadyFrame, WithAmbientOcclusionAllocatesNothing) {
    for (const OcclusionPattern pattern : {OcclusionPattern::Rotated, OcclusionPattern::Random}) {
        RenderSettings settings = settingsWith(1, true, 5);
        settings.ambientOcclusion.on = true;
        settings.ambientOcclusion.pattern = pattern;
        Pictures pictures(test::sampleScene());
        pictures.make(settings, 1);
        pictures.make(settings, 1);
        EXPECT_EQ(pictures.make(settings, 1), 0U);
    }
}

TEST(SteadyFrame, WithTheLightOfTheSkyAllocatesNothing) {
    Scene opaque = test::sampleScene();
    for (Material& m : opaque.materials) {
        m.opacity = 1;
        m.alphaTexture = kNoTexture;
    }
    for (const Scene& scene : {test::sampleScene(), opaque}) {
        RenderSettings settings = settingsWith(1, true, 5);
        settings.skyLight.on = true;
        Pictures pictures(scene);
        pictures.make(settings, 1);
        pictures.make(settings, 1);
        EXPECT_EQ(pictures.make(settings, 1), 0U);
    }
}

TEST(SteadyFrame, OfFogAllocatesNothing) {
    for (const FogKind kind : {FogKind::Homogeneous, FogKind::Exponential}) {
        for (const int shafts : {0, 4}) {
            RenderSettings settings = settingsWith(1, true, 5);
            settings.fog.shafts = shafts;
            Pictures pictures(test::foggyScene(kind));
            EXPECT_GT(pictures.make(settings, 1), 0U);
            EXPECT_EQ(pictures.make(settings, 1), 0U);
            EXPECT_EQ(pictures.make(settings, 1), 0U);
        }
    }
}

TEST(SteadyFrame, OfOpaqueSurfacesAllocatesNothing) {
    Scene scene = test::sampleScene();
    for (Material& m : scene.materials) {
        m.opacity = 1;
        m.alphaTexture = kNoTexture;
    }
    Pictures pictures(scene);
    pictures.make(settingsWith(1, true, 5), 1);
    EXPECT_EQ(pictures.make(settingsWith(1, true, 5), 1), 0U);
}

TEST(SteadyFrame, WithBloomAllocatesNothing) {
    Pictures pictures(test::sampleScene());
    RenderSettings settings = settingsWith(1, true, 5);
    settings.bloom.radius = 5;
    for (const BloomKernel kernel : {BloomKernel::Gaussian, BloomKernel::Airy}) {
        settings.bloom.kernel = kernel;
        pictures.make(settings, 1);
        pictures.make(settings, 1);
        EXPECT_EQ(pictures.make(settings, 1), 0U);
    }
}

TEST(SteadyFrame, WithEveryEffectAndWithoutEachAllocatesNothing) {
    const RenderSettings all = test::everyEffect(75, 50);
    std::vector<test::WithoutEffect> cases = test::withoutEachEffect(all);
    cases.push_back({"none", all});
    for (const test::WithoutEffect& without : cases) {
        Pictures pictures(test::foggyScene(FogKind::Exponential));
        pictures.make(without.settings, 1);
        pictures.make(without.settings, 1);
        EXPECT_EQ(pictures.make(without.settings, 1), 0U) << "without " << without.setting;
    }
}

// Threads share the tiles in another way each time, so that one may meet a larger wave than any before; but
// soon there is none larger.
TEST(SteadyFrame, OfManyThreadsSoonAllocatesNothing) {
    Pictures pictures(test::sampleScene());
    const RenderSettings settings = settingsWith(1, true, 5);
    int without = 0;
    for (int i = 0; i < 1000 && without < 5; ++i) without = pictures.make(settings, 3) == 0 ? without + 1 : 0;
    EXPECT_EQ(without, 5);
}

TEST(SteadyFrame, ChangesOfSettingsAndSizeAreFollowed) {
    const Scene scene = test::sampleScene();
    Pictures pictures(scene);
    pictures.make(settingsWith(3, true, 5), 2);
    pictures.make(settingsWith(1, false, 0), 1);
    const RenderSettings settings = test::sampleSettings(70, 40);
    pictures.make(settings, 2);
    Pictures fresh(scene);
    fresh.make(settings, 1);
    EXPECT_EQ(pictures.image().pixels, fresh.image().pixels);
}

} // namespace
} // namespace rtcore

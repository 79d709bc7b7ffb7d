// The time of each effect on a whole image: bench_post [WIDTH HEIGHT [THREADS]]
#include "rtcore/post/bloom.h"
#include "rtcore/post/denoise.h"
#include "rtcore/post/develop.h"
#include "rtcore/sampling/sample_id.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace {

using namespace rtcore;

/// Milliseconds of processor time: other work on the machine does not count.
double best(int turns, auto&& work) {
    double min = 1e9;
    for (int i = 0; i < turns; ++i) {
        const std::clock_t start = std::clock();
        work();
        min = std::min(min, 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return min;
}

HdrImage noise(int width, int height) {
    HdrImage image(width, height);
    std::uint32_t i = 0;
    for (Colour& c : image.pixels) c = Colour{1, 0.5F, 0.2F} * unitFloat(mixBits(i++));
    return image;
}

void benchBloom(const HdrImage& image, int threads) {
    RenderSettings settings;
    settings.width = image.width;
    settings.height = image.height;
    for (const BloomKernel kernel : {BloomKernel::Gaussian, BloomKernel::Airy}) {
        settings.bloom.kernel = kernel;
        for (const int sigma : {2, 20, 100}) {
            settings.bloom.radius = sigma;
            Bloom bloom;
            const double ms =
                best(7, [&] { bloom.apply(image, {}, {.settings = settings, .threads = threads}); });
            std::printf("bloom %s sigma %3d: %7.2f ms\n",
                        kernel == BloomKernel::Airy ? "airy    " : "gaussian", sigma, ms);
        }
    }
}

void benchLocalExposure(const Frame& frame, int threads) {
    RenderSettings settings;
    settings.width = frame.radiance.width;
    settings.height = frame.radiance.height;
    PictureDeveloper developer;
    LdrImage image;
    for (const float local : {0.0F, 0.5F}) {
        settings.exposure.local = local;
        const double ms = best(7, [&] { developer.develop(frame.radiance, settings, 1, threads, image); });
        std::printf("develop, local exposure %.1f: %7.2f ms\n", static_cast<double>(local), ms);
    }
}

void benchFalseColours(const Frame& frame, int threads) {
    RenderSettings settings;
    PictureDeveloper developer;
    LdrImage image;
    settings.falseColours.on = true;
    for (const bool isolines : {false, true}) {
        settings.falseColours.isolines = isolines;
        const double ms = best(7, [&] { developer.develop(frame.radiance, settings, 1, threads, image); });
        std::printf("false colours, %s isolines: %7.2f ms\n", isolines ? "with" : "without", ms);
    }
}

/// A wavy floor under noisy light.
void fillAovs(Frame& frame) {
    const int width = frame.radiance.width, height = frame.radiance.height;
    Camera camera;
    frame.aovs.begin(camera, width, height);
    std::vector<SampleId> samples(static_cast<std::size_t>(width));
    std::vector<PrimaryHit> hits(samples.size());
    for (int y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < samples.size(); ++x) {
            samples[x] = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0};
            PrimaryHit& hit = hits[x];
            hit.position = {static_cast<float>(x), -1, -1 - static_cast<float>(height - y)};
            hit.normal = {0, 1, 0};
            hit.albedo = {0.5F, 0.5F, 0.5F};
            hit.soft = frame.radiance.at(static_cast<int>(x), y);
            hit.wave = 1;
        }
        frame.aovs.add(hits, samples);
    }
    frame.aovs.finish(1);
}

void benchDenoise(const Frame& frame, int threads) {
    RenderSettings settings;
    for (const int passes : {1, 3, 5}) {
        settings.denoise.passes = passes;
        Denoiser denoiser;
        const double ms = best(5, [&] {
            denoiser.apply(frame.radiance, frame.aovs, {.settings = settings, .threads = threads});
        });
        std::printf("denoise, %d passes: %7.2f ms\n", passes, ms);
    }
}

} // namespace

int main(int count, char** arguments) {
    const int width = count > 2 ? std::atoi(arguments[1]) : 640;
    const int height = count > 2 ? std::atoi(arguments[2]) : 480;
    const int threads = count > 3 ? std::atoi(arguments[3]) : 1;
    if (width < 1 || height < 1) return 2;
    Frame frame;
    frame.radiance = noise(width, height);
    fillAovs(frame);
    benchBloom(frame.radiance, threads);
    benchLocalExposure(frame, threads);
    benchFalseColours(frame, threads);
    benchDenoise(frame, threads);
    return 0;
}

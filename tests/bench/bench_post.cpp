// What is done to a whole picture, and how long it takes: bench_post [WIDTH HEIGHT [THREADS]]
#include "rtcore/post/bloom.h"
#include "rtcore/sampling/sample_id.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace {

using namespace rtcore;

double best(int turns, auto&& work) {
    double least = 1e9;
    for (int i = 0; i < turns; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        least = std::min(
            least,
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    return least;
}

HdrImage grain(int width, int height) {
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
        settings.bloomKernel = kernel;
        for (const int sigma : {2, 20, 100}) {
            settings.bloom = sigma;
            Bloom bloom;
            const double ms = best(7, [&] { bloom.apply(image, settings, threads); });
            std::printf("bloom %s sigma %3d: %7.2f ms\n",
                        kernel == BloomKernel::Airy ? "airy    " : "gaussian", sigma, ms);
        }
    }
}

} // namespace

int main(int count, char** arguments) {
    const int width = count > 2 ? std::atoi(arguments[1]) : 640;
    const int height = count > 2 ? std::atoi(arguments[2]) : 480;
    const int threads = count > 3 ? std::atoi(arguments[3]) : 0;
    if (width < 1 || height < 1) return 2;
    const HdrImage image = grain(width, height);
    benchBloom(image, threads);
    return 0;
}

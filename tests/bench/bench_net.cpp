// The time and the memory of each net for an image of noise: bench_net [WIDTH HEIGHT [THREADS [TURNS]]]
// The kernels' instruction set is that of RT_ISA; weights are those that scripts/fetch-nets.sh brings.
#include "rtcore/neural/net_denoiser.h"
#include "rtcore/neural/nets.h"
#include "rtcore/platform/error.h"
#include "rtcore/sampling/sample_id.h"
#include "rtcore/simd/instruction_set.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace rtcore;

std::vector<float> noise(std::size_t count, std::uint32_t seed) {
    std::vector<float> numbers(count);
    for (float& number : numbers) number = unitFloat(mixBits(seed++));
    return numbers;
}

/// Most memory that this process has had, in millions of bytes.
double peakMemory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
}

void bench(const char* name, const std::shared_ptr<const UNet>& net, const NoisyImage& image, int threads,
           int turns) {
    std::vector<float> result(std::size_t{3} * static_cast<std::size_t>(image.width) *
                              static_cast<std::size_t>(image.height));
    const double before = peakMemory();
    NetDenoiser denoiser(net);
    double seconds = 1e9;
    for (int turn = 0; turn < turns; ++turn) {
        const auto start = std::chrono::steady_clock::now();
        denoiser.run(image, result.data(), threads);
        seconds = std::min(seconds,
                           std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    const auto bytes = static_cast<double>(denoiser.bytes());
    if (denoiser.bytes() > NetDenoiser::kMaxBytes) std::printf("more than NetDenoiser::kMaxBytes: ");
    std::printf("%-6s %8.3f s, keeps %6.1f MB (%5.1f bytes a pixel), the process grew by %6.1f MB\n", name,
                seconds, bytes / 1e6, 3 * bytes / static_cast<double>(result.size()), peakMemory() - before);
}

} // namespace

int main(int argc, char** argv) {
    useInstructionSetOfEnvironment();
    const auto argument = [&](int i, int usual) {
        return argc > i ? std::max(std::atoi(argv[i]), 1) : usual;
    };
    const int width = argument(1, 1280), height = argument(2, 720), threads = argument(3, 1),
              turns = argument(4, 3);
    const auto count = std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::vector<float> radiance = noise(count, 1), albedo = noise(count, 2), normal = noise(count, 3);
    const NoisyImage image{width, height, {radiance.data()}, {albedo.data()}, {normal.data()}};
    std::printf("%d x %d, %d threads\n", width, height, threads);
    try {
        Nets nets;
        // The first has the least memory: what the process grows by is that of each.
        bench("small", nets.of(Net::Small), image, threads, turns);
        bench("base", nets.of(Net::Base), image, threads, turns);
        bench("large", nets.of(Net::Large), image, threads, turns);
    } catch (const FileError& error) {
        std::fprintf(stderr, "bench_net: %s\n", error.what());
        return 66;
    }
    return 0;
}

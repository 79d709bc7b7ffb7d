// How the cost of a ray grows with the model: the same hills in ever finer triangles, the same coherent rays.
//   bench_growth [SIDE]     pixels of a side of the image (1024)
// One thread, the best of five, in processor time.
#include "rtcore/accel/builder.h"
#include "rtcore/kernels/ray_tracer.h"
#include "support/sample_meshes.h"
#include "support/view_rays.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

namespace {

constexpr int kRepeats = 5;
constexpr std::size_t kWave = 16384;

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

float heightAt(float x, float z) {
    float height = 0;
    float size = 0.2F;
    float wave = 2;
    for (int octave = 0; octave < 6; ++octave) {
        height += size * std::sin(wave * x + 1.3F * static_cast<float>(octave)) * std::cos(wave * 0.9F * z);
        size *= 0.5F;
        wave *= 2.1F;
    }
    return height;
}

/// Hills over [-2, 2] x [-2, 2], of 2 n^2 triangles.
test::SampleMesh hills(std::uint32_t n) {
    test::SampleMesh mesh;
    const float step = 4 / static_cast<float>(n);
    for (std::uint32_t row = 0; row <= n; ++row) {
        for (std::uint32_t column = 0; column <= n; ++column) {
            const float x = -2 + step * static_cast<float>(column);
            const float z = -2 + step * static_cast<float>(row);
            mesh.vertices.push_back({x, heightAt(x, z), z, 0});
        }
    }
    for (std::uint32_t row = 0; row < n; ++row) {
        for (std::uint32_t column = 0; column < n; ++column) {
            const std::uint32_t a = row * (n + 1) + column;
            mesh.triangles.push_back({{a, a + n + 1, a + 1}});
            mesh.triangles.push_back({{a + 1, a + n + 1, a + n + 2}});
        }
    }
    return mesh;
}

std::vector<rtcore::RayWave> inWaves(const std::vector<rtcore::Ray>& rays) {
    std::vector<rtcore::RayWave> waves;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (i % kWave == 0) waves.emplace_back();
        waves.back().push(rays[i]);
    }
    return waves;
}

template <typename Trace>
double nanoseconds(const std::vector<rtcore::RayWave>& waves, std::size_t rays, Trace&& trace) {
    double best = 1e30;
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        const double start = threadSeconds();
        for (const rtcore::RayWave& wave : waves) trace(wave);
        best = std::min(best, threadSeconds() - start);
    }
    return best / static_cast<double>(rays) * 1e9;
}

void measure(std::uint32_t n, int side) {
    const test::SampleMesh sample = hills(n);
    const rtcore::Mesh mesh = sample.view();
    const rtcore::KdTree tree = buildKdTree(mesh, {});
    const rtcore::KdRayTracer tracer(tree, mesh);
    const test::View view{"hills", "", {-1.6F, 0.9F, -1.7F}, {0.2F, -0.1F, 0.3F}, 50, {1, 3, -1}};
    const std::vector<rtcore::Ray> primary = primaryRays(view, side);
    rtcore::HitWave found;
    std::vector<rtcore::Hit> hits;
    const std::vector<rtcore::RayWave> waves = inWaves(primary);
    for (const rtcore::RayWave& wave : waves) {
        tracer.intersect(rtcore::RayKind::Primary, wave, found);
        for (std::size_t i = 0; i < wave.size(); ++i) hits.push_back(found.hit(i));
    }
    const std::vector<rtcore::Ray> shadow =
        test::shadowRays(test::surfacePoints(mesh, primary, hits), view.light);
    const std::vector<rtcore::RayWave> shadowWaves = inWaves(shadow);
    std::vector<std::uint8_t> occluded;
    const double first = nanoseconds(waves, primary.size(), [&](const rtcore::RayWave& wave) {
        tracer.intersect(rtcore::RayKind::Primary, wave, found);
    });
    const double second = nanoseconds(shadowWaves, shadow.size(), [&](const rtcore::RayWave& wave) {
        tracer.occluded(rtcore::RayKind::Shadow, wave, occluded);
    });
    std::printf("%9zu triangles: primary %6.1f ns, shadow %6.1f ns a ray\n", mesh.triangles.size(), first,
                second);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const int side = std::max(1, argc > 1 ? std::atoi(argv[1]) / 4 : 256) * 4;
    for (const std::uint32_t n : {71U, 224U, 707U, 2236U}) measure(n, side);
    return 0;
}

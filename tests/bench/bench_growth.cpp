// How the cost of a ray grows with the model: the same hills in ever finer triangles, the same rays, by our
// kernels and by Embree's best mode and its best robust one.
//   bench_growth [SIDE]     pixels of a side of the image (1024)
// One thread, processor time.
#include "bench/rtbench/contenders.h"
#include "bench/rtbench/race.h"
#include "bench/rtbench/ray_sets.h"
#include "rtcore/accel/builder.h"
#include "support/sample_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

constexpr int kRounds = 5;

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

void printKind(const rtbench::RayFigures& figures) {
    const auto nanoseconds = [](double megaraysPerSecond) { return 1e3 / megaraysPerSecond; };
    std::printf("  %s %.1f", figures.test->name.data(), nanoseconds(figures.speed));
    for (const auto& rival : {figures.best, figures.robust}) {
        if (rival) std::printf(" / %.1f", nanoseconds(rival->speed));
    }
}

void measure(std::uint32_t n, int side) {
    const test::SampleMesh sample = hills(n);
    const rtcore::Mesh mesh = sample.view();
    const rtcore::KdTree tree = buildKdTree(mesh, {});
    const std::vector<rtbench::Contender> contenders =
        rtbench::makeContenders(tree, mesh, rtbench::hasEmbree());
    const rtbench::BenchView view{.name = "hills",
                                  .eye = {-1.6F, 0.9F, -1.7F},
                                  .at = {0.2F, -0.1F, 0.3F},
                                  .fov = 50,
                                  .light = {1, 3, -1}};
    const rtbench::RaySource source(mesh, *contenders.front().tracer, view, side);
    std::printf("%9zu triangles:", mesh.triangles.size());
    rtbench::RaceOptions options;
    options.rounds = kRounds;
    for (const rtbench::RayTest& test : rtbench::kRayTests)
        printKind(rtbench::race(source.make(test), contenders, options));
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const int side = std::max(1, argc > 1 ? std::atoi(argv[1]) / 4 : 256) * 4;
    std::printf("nanoseconds a ray%s\n", rtbench::hasEmbree() ? ": ours / Embree's best / robust best" : "");
    for (const std::uint32_t n : {71U, 224U, 707U, 2236U}) measure(n, side);
    return 0;
}

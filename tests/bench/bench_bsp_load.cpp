// How long a .bsp of the size of the Stanford dragon takes to load from a warm cache.
//   bench_bsp_load [file.bsp]     without a file: one is made
#include "rtcore/io/bsp/bsp_checksum.h"
#include "rtcore/io/bsp/bsp_file.h"
#include "support/sample_tree.h"
#include "support/temporary_folder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

double milliseconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
}

/// A sheet of hills: 870 thousand triangles, half as many vertices.
rtcore::ModelBuffers makeSheet() {
    constexpr int side = 660;
    rtcore::ModelBuffers buffers;
    buffers.materials.emplace_back();
    for (int y = 0; y <= side; ++y) {
        for (int x = 0; x <= side; ++x) {
            const float u = static_cast<float>(x) / side, v = static_cast<float>(y) / side;
            buffers.vertices.push_back({u, v, 0.2F * std::sin(20 * u) * std::sin(15 * v), 0});
            buffers.normals.push_back(rtcore::normalize({-0.1F, 0.1F * u, 1}));
        }
    }
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t a = y * (side + 1) + x, b = a + side + 1;
            buffers.triangles.push_back({{a, a + 1, b}});
            buffers.triangles.push_back({{a + 1, b + 1, b}});
        }
    }
    for (const rtcore::Triangle& t : buffers.triangles)
        buffers.shading.push_back({{t.v[0], t.v[1], t.v[2]}, 0});
    return buffers;
}

void makeFile(const std::filesystem::path& path) {
    const rtcore::Model model = rtcore::makeModel(makeSheet());
    const test::SampleTree tree = test::sampleTree(model.mesh, 24, 40);
    const rtcore::KdTree view = tree.view();
    const double start = milliseconds();
    rtcore::writeBsp(path, model, &view, {});
    std::printf("%zu triangles, %zu nodes, %zu references; written in %.1f ms\n", model.mesh.triangles.size(),
                view.nodes.size(), view.references.size(), milliseconds() - start);
}

void measure(const std::filesystem::path& path) {
    std::vector<double> loads, checksums;
    for (int i = 0; i < 15; ++i) {
        double start = milliseconds();
        { const rtcore::BspContent content = rtcore::readBsp(path); }
        loads.push_back(milliseconds() - start);
        const rtcore::FileBytes file = rtcore::openFileBytes(path);
        start = milliseconds();
        const volatile std::uint32_t crc = rtcore::crc32Of(file.bytes);
        checksums.push_back(milliseconds() - start);
        static_cast<void>(crc);
    }
    std::sort(loads.begin(), loads.end());
    std::sort(checksums.begin(), checksums.end());
    std::printf("%.1f MB loaded in %.1f ms (median; best %.1f, worst %.1f); reading it and its checksum "
                "alone %.1f ms\n",
                static_cast<double>(std::filesystem::file_size(path)) / 1e6, loads[loads.size() / 2],
                loads.front(), loads.back(), checksums[checksums.size() / 2]);
}

} // namespace

int main(int argc, char** argv) {
    try {
        if (argc > 1) {
            measure(argv[1]);
            return 0;
        }
        const test::TemporaryFolder folder;
        makeFile(folder / "model.bsp");
        measure(folder / "model.bsp");
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_bsp_load: %s\n", error.what());
        return 1;
    }
}

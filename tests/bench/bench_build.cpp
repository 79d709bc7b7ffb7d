// The cost of building the kd-trees of model files, and statistics of the trees.
//   bench_build [--exact | --fast] [--threads N] [--quality N] [--equal N] FILE...     PLY or OBJ
// --equal adds a scene of N equal triangles.
// The best wall time of five, and the least processor time; peak memory above what the process held before,
// of the last.
#include "rtcore/accel/builder.h"
#include "rtcore/accel/statistics.h"
#include "support/mesh_files.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

constexpr int kRepeats = 5;

/// A line "VmHWM:  1234 kB" of this process; 0 where there is none.
double statusMegabytes(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.rfind(name + ":", 0) == 0) return std::atof(line.c_str() + name.size() + 1) / 1024;
    }
    return 0;
}

/// Gives free memory back and makes the present use the peak so far.
void resetPeak() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    std::ofstream("/proc/self/clear_refs") << "5";
}

/// A number that two equal trees share, to see that a change of the builder left its trees alone (FNV-1a).
std::uint64_t fingerprint(const rtcore::KdTree& tree) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    const auto add = [&](std::uint32_t word) { hash = (hash ^ word) * 0x100000001B3U; };
    for (const rtcore::KdNode& node : tree.nodes) {
        add(node.firstReference);
        add(node.bits);
    }
    for (const std::uint32_t triangle : tree.references) add(triangle);
    return hash;
}

void measure(const rtcore::Mesh& mesh, const char* name, const rtcore::BuildOptions& options) {
    rtcore::BuildTimes best;
    double bestSeconds = 1e30;
    double processor = 1e30;
    double peak = 0;
    rtcore::KdTree tree;
    for (int i = 0; i < kRepeats; ++i) {
        tree = {};
        resetPeak();
        const double before = statusMegabytes("VmRSS");
        rtcore::BuildTimes times;
        const std::clock_t processorStart = std::clock();
        const auto start = std::chrono::steady_clock::now();
        tree = buildKdTree(mesh, options, &times);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        processor = std::min(processor, static_cast<double>(std::clock() - processorStart) / CLOCKS_PER_SEC);
        peak = statusMegabytes("VmHWM") - before;
        if (seconds < bestSeconds) best = times;
        bestSeconds = std::min(bestSeconds, seconds);
    }
    const float cost = rtcore::automaticIntersectionCost(mesh.triangles.size());
    const rtcore::KdStatistics s = computeStatistics(tree, 1, cost);
    std::printf("  %-5s %d threads: %7.1f ms (prepare %.1f, split %.1f, emit %.1f; processor %.1f), peak "
                "%.0f MB = %.0f B/triangle; "
                "%llu nodes, %llu references, %.1f B/triangle, expected cost %.2f, tree %016llx\n",
                name, options.threads, bestSeconds * 1e3, best.prepare * 1e3, best.split * 1e3,
                best.emit * 1e3, processor * 1e3, peak,
                peak * 1048576 / static_cast<double>(mesh.triangles.size()),
                static_cast<unsigned long long>(s.nodes), static_cast<unsigned long long>(s.references),
                static_cast<double>(s.bytes) / static_cast<double>(mesh.triangles.size()), s.expectedCost,
                static_cast<unsigned long long>(fingerprint(tree)));
}

struct Selection {
    std::vector<rtcore::BuildMethod> methods{rtcore::BuildMethod::Exact, rtcore::BuildMethod::Fast};
    std::vector<int> threads{1, 2};
    int quality = rtcore::BuildOptions{}.fastQuality;
    std::size_t equalTriangles = 0;
    std::vector<const char*> files;
};

Selection parse(int argc, char** argv) {
    Selection selection;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--exact") {
            selection.methods = {rtcore::BuildMethod::Exact};
        } else if (word == "--fast") {
            selection.methods = {rtcore::BuildMethod::Fast};
        } else if (word == "--threads" && i + 1 < argc) {
            selection.threads = {std::atoi(argv[++i])};
        } else if (word == "--equal" && i + 1 < argc) {
            selection.equalTriangles = static_cast<std::size_t>(std::atoll(argv[++i]));
        } else if (word == "--quality" && i + 1 < argc) {
            selection.quality = std::atoi(argv[++i]);
        } else {
            selection.files.push_back(argv[i]);
        }
    }
    return selection;
}

void measureAll(const Selection& selection, const char* name, const test::SampleMesh& sample) {
    std::printf("%s: %zu triangles\n", name, sample.triangles.size());
    for (const auto method : selection.methods) {
        for (const int threads : selection.threads) {
            rtcore::BuildOptions options;
            options.method = method;
            options.threads = threads;
            options.fastQuality = selection.quality;
            measure(sample.view(), method == rtcore::BuildMethod::Exact ? "exact" : "fast", options);
        }
    }
}

/// One apart from all others makes a cell that could be split.
test::SampleMesh equalTriangles(std::size_t count) {
    test::SampleMesh sample;
    sample.addTriangle({0, 0, 0}, {1, 0.2F, 0.1F}, {0.3F, 1, 0.7F});
    sample.addTriangle({4, 4, 4}, {5, 4, 4}, {4, 5, 5});
    sample.triangles.insert(sample.triangles.end(), count - 1, sample.triangles[0]);
    return sample;
}

} // namespace

int main(int argc, char** argv) {
    const Selection selection = parse(argc, argv);
    if (selection.files.empty() && selection.equalTriangles == 0) {
        std::fprintf(stderr,
                     "bench_build [--exact | --fast] [--threads N] [--quality N] [--equal N] FILE...\n");
        return 2;
    }
    try {
        for (const char* file : selection.files) measureAll(selection, file, test::readMesh(file));
        if (selection.equalTriangles > 0) {
            measureAll(selection, "equal", equalTriangles(selection.equalTriangles));
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_build: %s\n", error.what());
        return 1;
    }
    return 0;
}

// How fast single rays are, beside Embree's on the same rays in the same run.
//   bench_rays FOLDER [VIEW [SIDE]]     the folder of scenes; one of its views or "all"; pixels of a side
//   (512)
// Methods take turns; the best of five, in the processor time of the one thread, counts.
#include "rtcore/accel/builder.h"
#include "rtcore/kernels/single_ray.h"
#ifdef RT_HAVE_EMBREE
#include "support/embree_scene.h"
#endif
#include "support/mesh_files.h"
#include "support/view_rays.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

using rtcore::Hit;
using rtcore::Ray;

namespace {

constexpr int kRepeats = 5;

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One way to trace all rays of a kind; returns how many hit.
struct Method {
    std::string name;
    std::function<std::size_t(const std::vector<Ray>&)> trace;
    double seconds = 1e30;
    std::size_t hits = 0;
};

void race(std::vector<Method>& methods, const std::vector<Ray>& rays) {
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        for (Method& method : methods) {
            const double start = threadSeconds();
            method.hits = method.trace(rays);
            method.seconds = std::min(method.seconds, threadSeconds() - start);
        }
    }
}

void report(const char* kind, const std::vector<Method>& methods, std::size_t rays) {
    std::printf("  %-8s %8zu rays", kind, rays);
    for (const Method& method : methods) {
        std::printf("   %s %6.2f Mrays/s (%zu hits)", method.name.c_str(),
                    static_cast<double>(rays) / method.seconds * 1e-6, method.hits);
    }
    if (methods.size() > 1) std::printf("   ratio %.2f", methods[1].seconds / methods[0].seconds);
    std::printf("\n");
}

template <typename Trace>
Method each(const char* name, Trace trace) {
    return {name, [trace](const std::vector<Ray>& rays) {
                std::size_t hits = 0;
                for (const Ray& ray : rays) hits += trace(ray) ? 1 : 0;
                return hits;
            }};
}

class Bench {
  public:
    Bench(const test::View& view, const std::filesystem::path& folder)
        : view_(view), sample_(test::readMesh(folder / view.file)), mesh_(sample_.view()),
          tree_(buildKdTree(mesh_, {}))
#ifdef RT_HAVE_EMBREE
          ,
          embree_(mesh_)
#endif
    {
    }

    void run(int side) const {
        std::printf("%s: %zu triangles, %zu nodes, %zu references\n", view_.name, mesh_.triangles.size(),
                    tree_.nodes.size(), tree_.references.size());
        const std::vector<Ray> primary = primaryRays(view_, side);
        std::vector<Hit> hits(primary.size());
        for (std::size_t i = 0; i < primary.size(); ++i) intersect(tree_, mesh_, primary[i], hits[i]);
        const auto points = test::surfacePoints(mesh_, primary, hits);
        closest("primary", primary);
        any("shadow", test::shadowRays(points, view_.light));
        closest("diffuse", test::diffuseRays(points, 1));
    }

  private:
    void closest(const char* kind, const std::vector<Ray>& rays) const {
        std::vector<Method> methods{each("kd", [this](const Ray& ray) {
            Hit hit;
            return intersect(tree_, mesh_, ray, hit);
        })};
#ifdef RT_HAVE_EMBREE
        methods.push_back(each("embree", [this](const Ray& ray) {
            Hit hit;
            return embree_.intersect(ray, hit);
        }));
#endif
        race(methods, rays);
        report(kind, methods, rays.size());
    }

    void any(const char* kind, const std::vector<Ray>& rays) const {
        std::vector<Method> methods{
            each("kd", [this](const Ray& ray) { return occluded(tree_, mesh_, ray); })};
#ifdef RT_HAVE_EMBREE
        methods.push_back(each("embree", [this](const Ray& ray) { return embree_.occluded(ray); }));
#endif
        race(methods, rays);
        report(kind, methods, rays.size());
    }

    const test::View& view_;
    test::SampleMesh sample_;
    rtcore::Mesh mesh_;
    rtcore::KdTree tree_;
#ifdef RT_HAVE_EMBREE
    test::EmbreeScene embree_;
#endif
};

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "bench_rays FOLDER [VIEW [SIDE]]\n");
        return 2;
    }
    const std::string wanted = argc > 2 ? argv[2] : "all";
    const int side = std::max(1, argc > 3 ? std::atoi(argv[3]) / 4 : 128) * 4;
    try {
        for (const test::View& view : test::kViews) {
            if (wanted == "all" || wanted == view.name) Bench(view, argv[1]).run(side);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_rays: %s\n", error.what());
        return 1;
    }
    return 0;
}

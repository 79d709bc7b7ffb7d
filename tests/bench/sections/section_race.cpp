#include "bench/sections/section_race.h"

#include "bench/sections/cut_model.h"

#include "rtcore/accel/builder.h"
#include "rtcore/accel/tree_within.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/kernels/section_clip.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/shown_tracer.h"
#include "rtcore/scene/closed_surfaces.h"
#include "rtcore/scene/glass_solids.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <ctime>

namespace rtbench {

namespace {

using namespace rtcore;

double processorSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double wallSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Of one scene, again and again.
class Runner {
  public:
    Runner(std::string name, const Scene& scene, std::shared_ptr<const RayTracer> surfaces)
        : Runner(std::move(name), scene, std::move(surfaces), SectionSurfaces()) {}
    /// `known`: the tracers that its sections need, as far as they are there.
    Runner(std::string name, Scene scene, std::shared_ptr<const RayTracer> surfaces, SectionSurfaces known)
        : name_(std::move(name)), scene_(std::move(scene)),
          tracer_(shownTracer(std::move(surfaces), scene_, known)) {
        control_.threads = 1;
    }

    void render(const Camera& camera, const RenderSettings& settings) {
        const double start = processorSeconds();
        renderer_.render({scene_, *tracer_, camera, settings}, control_, frame_);
        seconds_.push_back(processorSeconds() - start);
    }
    void forgetTimes() { seconds_.clear(); }

    const std::string& name() const { return name_; }
    const std::vector<double>& seconds() const { return seconds_; }
    const Frame& frame() const { return frame_; }

  private:
    std::string name_;
    Scene scene_;
    std::shared_ptr<const RayTracer> tracer_;
    FrameRenderer renderer_;
    RenderControl control_;
    Frame frame_;
    std::vector<double> seconds_;
};

double medianOf(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double ratio(const Runner& of, const Runner& to) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < of.seconds().size(); ++i) ratios.push_back(of.seconds()[i] / to.seconds()[i]);
    return medianOf(std::move(ratios));
}

/// How many pixels differ by more than a thousandth of white, in percent.
double differencePercent(const Frame& a, const Frame& b) {
    std::size_t differ = 0;
    const auto far = [](float x, float y) { return !(std::fabs(x - y) <= 1e-3F * std::max(1.0F, x)); };
    for (std::size_t i = 0; i < a.radiance.pixels.size(); ++i) {
        const Colour x = a.radiance.pixels[i], y = b.radiance.pixels[i];
        differ += far(x.r, y.r) || far(x.g, y.g) || far(x.b, y.b) ? 1U : 0U;
    }
    return 100 * static_cast<double>(differ) / static_cast<double>(a.radiance.pixels.size());
}

Scene withPlane(const Scene& whole, const SectionPlane& plane, SectionLight light) {
    Scene scene = whole;
    scene.sections.planes = {plane};
    scene.sections.light = light;
    return scene;
}

SectionPlane beyond(const Box3& bounds, Vec3 normal) {
    const Vec3 unit = normalize(normal);
    return {bounds.centre() + unit * bounds.diagonal(), unit};
}

/// The scene of triangles that were really cut, with its tracer.
struct CutScene {
    CutScene(const Scene& whole, const SectionPlane& plane) : scene(whole) {
        scene.model = cutModel(whole.model, plane);
        scene.closed = findClosedSurfaces(scene.model.mesh, scene.materials);
        scene.solids = findGlassSolids(scene.model.mesh, scene.materials, scene.closed);
        tree = buildKdTree(scene.model.mesh, {});
        tracer = std::make_shared<const KdRayTracer>(tree, scene.model.mesh);
    }
    Scene scene;
    KdTree tree;
    std::shared_ptr<const RayTracer> tracer;
};

double minOf(const Runner& runner) { return std::ranges::min(runner.seconds()); }

void print(const Runner& runner, const Runner& whole, const Runner& cut) {
    std::printf("  %-34s %8.2f %8.2f ms %8.3f %7.3f %8.3f %7.3f\n", runner.name().c_str(),
                medianOf(runner.seconds()) * 1e3, minOf(runner) * 1e3, ratio(runner, whole),
                minOf(runner) / minOf(whole), ratio(runner, cut), minOf(runner) / minOf(cut));
}

/// By a tree that is built of what the plane leaves.
SectionSurfaces rebuilt(const Scene& scene, const std::shared_ptr<const RayTracer>& surfaces) {
    const SectionClip clip(scene.sections, surfaces->bounds());
    const double start = wallSeconds();
    const KdTree tree = buildTreeWithin(scene.mesh(), {}, clip.halves(), surfaces->bounds());
    const KdRayTracer built(tree, scene.mesh());
    SectionSurfaces known;
    known.useLeft(surfaces, clip.halves(), built.within(clip.halves()));
    std::printf(
        "the tree of what is left: built in %.0f ms, all threads; %zu references, %.2f MB with copies\n",
        (wallSeconds() - start) * 1e3, tree.references.size(), static_cast<double>(built.memory()) / 1e6);
    return known;
}

/// The fastest of some times that the tracer of a section was made, in milliseconds of the processor.
double millisecondsOfTracer(const std::shared_ptr<const RayTracer>& surfaces, const Scene& scene) {
    constexpr int kTimes = 9;
    double best = 1e30;
    for (int i = 0; i < kTimes; ++i) {
        const double start = processorSeconds();
        const auto tracer = shownTracer(surfaces, scene);
        best = std::min(best, processorSeconds() - start);
    }
    return best * 1e3;
}

} // namespace

void raceSections(const LoadedScene& loaded, const RenderSettings& settings, const SectionPlane& plane,
                  int rounds, bool withRebuilt) {
    Scene whole = loaded.scene;
    whole.sections = {};
    whole.ground = nullptr;
    const auto surfaces = std::make_shared<const KdRayTracer>(loaded.tree, whole.mesh());
    const CutScene cut(whole, plane);
    const SectionPlane missing = beyond(surfaces->bounds(), plane.normal);
    std::deque<Runner> all; // which stay where they are
    const auto add = [&](const char* name, const Scene& scene, const std::shared_ptr<const RayTracer>& of) {
        all.emplace_back(name, scene, of);
        return &all.back();
    };
    const Runner* const none = add("no section", whole, surfaces);
    add("no section, once more", whole, surfaces);
    add("a plane that misses", withPlane(whole, missing, SectionLight::Cut), surfaces);
    const Runner* const through =
        add("a plane through, light falls in", withPlane(whole, plane, SectionLight::Cut), surfaces);
    const Scene cutOpen = withPlane(whole, plane, SectionLight::Cut);
    if (withRebuilt)
        all.emplace_back("the same, by a tree of what is left", cutOpen, surfaces,
                         rebuilt(cutOpen, surfaces));
    const Frame* const same = withRebuilt ? &all.back().frame() : nullptr;
    add("a plane through, rooms keep light", withPlane(whole, plane, SectionLight::Whole), surfaces);
    const Runner* const triangles = add("triangles cut", cut.scene, cut.tracer);
    for (Runner& runner : all) { // fetches memory
        runner.render(loaded.camera, settings);
        runner.forgetTimes();
    }
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < all.size(); ++i) // each is the first as often
            all[(i + static_cast<std::size_t>(round)) % all.size()].render(loaded.camera, settings);
    std::printf("sections, %d x %d, one thread, %d rounds: %zu triangles, %zu when cut\n", settings.width,
                settings.height, rounds, whole.mesh().triangles.size(), cut.scene.mesh().triangles.size());
    std::printf("  median and minimum: %28s, of no section, of the triangles cut\n", "frame");
    for (const Runner& runner : all) print(runner, *none, *triangles);
    std::printf("  the tracer of a plane through is made in %.2f ms, of %zu nodes\n",
                millisecondsOfTracer(surfaces, withPlane(whole, plane, SectionLight::Cut)),
                loaded.tree.nodes.size());
    std::printf("  pixels that differ, plane and triangles: %.3f %%\n",
                differencePercent(through->frame(), triangles->frame()));
    if (same != nullptr)
        std::printf("  bits of the image by the tree of what is left: %s\n",
                    same->radiance.pixels == through->frame().radiance.pixels ? "the same" : "others");
}

} // namespace rtbench

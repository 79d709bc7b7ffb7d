// The cost of a steady frame, stage by stage.
//   bench_frame SCENE [--view NAME] [--size WxH] [--mirror SHARE] [--specular SHARE] [--threads N] [--frames
//   N]
//               [--antialiasing N] [--no-shadows] [--setting NAME=VALUE]... [--shadow-maps]
//               [--replay-only] [--section X,Y,Z,NX,NY,NZ [--rebuilt]]
// SCENE is a .bsp, .scn or model. Without lights of its own it gets one at the eye's height; a view of that
// name (tests/support/view_rays.h) sets camera and light. The best of N frames (20) counts. The line `without
// tracing` renders the same frame with the answers of the tracer played back, by one thread: the time that
// no faster tracer can save. With --section: what it costs beside no section, and beside the same model whose
// triangles the plane has cut, in N rounds in turns (sections/section_race.h), and nothing else; --rebuilt:
// also by a tree that is built of what the plane leaves.
#include "bench/sections/section_race.h"

#include "rtcore/io/scene_loader.h"
#include "rtcore/post/develop.h"
#include "rtcore/post/effects.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/settings/settings_table.h"
#include "rtcore/simd/instruction_set.h"
#include "support/view_rays.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <ctime>

namespace {

using namespace rtcore;

struct Options {
    std::string scene, view;
    std::vector<std::string> settings; ///< "name=value"
    std::optional<SectionPlane> section;
    int width = 1920, height = 1080, threads = 1, frames = 20, antialiasing = 1;
    float mirror = 0, specular = 0;
    bool shadows = true, shadowMaps = false, replayOnly = false, rebuilt = false;
};

/// Processor time of all threads, so that other work on the machine does not count.
double processSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Keeps the answers of a tracer, then plays them back in the same order. For one thread.
class ReplayTracer final : public RayTracer {
  public:
    explicit ReplayTracer(const RayTracer& tracer) : tracer_(tracer) {}

    void rewind(bool recording) {
        recording_ = recording;
        if (recording) hits_.clear();
        if (recording) occluded_.clear();
        if (recording) obstacles_.clear();
        nextHits_ = nextOccluded_ = nextObstacles_ = 0;
    }
    void intersect(RayKind kind, const RayWave& rays, HitWave& hits) const override {
        if (recording_) {
            tracer_.intersect(kind, rays, hits);
            hits_.push_back(hits);
        } else {
            hits = hits_[nextHits_++];
        }
    }
    void occluded(RayKind kind, const RayWave& rays, std::vector<std::uint8_t>& occluded) const override {
        if (recording_) {
            tracer_.occluded(kind, rays, occluded);
            occluded_.push_back(occluded);
        } else {
            occluded = occluded_[nextOccluded_++];
        }
    }
    void findObstacles(const RayWave& rays, std::span<const std::uint8_t> clear,
                       std::vector<Obstacle>& found) const override {
        if (recording_) {
            tracer_.findObstacles(rays, clear, found);
            obstacles_.push_back(found);
        } else {
            found = obstacles_[nextObstacles_++];
        }
    }
    Box3 bounds() const override { return tracer_.bounds(); }

  private:
    const RayTracer& tracer_;
    bool recording_ = true;
    mutable std::vector<HitWave> hits_;
    mutable std::vector<std::vector<std::uint8_t>> occluded_;
    mutable std::vector<std::vector<Obstacle>> obstacles_;
    mutable std::size_t nextHits_ = 0, nextOccluded_ = 0, nextObstacles_ = 0;
};

Options parse(int argc, char** argv) {
    Options o;
    for (int i = 1; i < argc; ++i) {
        const std::string_view name = argv[i];
        if (name == "--no-shadows") {
            o.shadows = false;
        } else if (name == "--shadow-maps") {
            o.shadowMaps = true;
        } else if (name == "--replay-only") {
            o.replayOnly = true;
        } else if (name == "--rebuilt") {
            o.rebuilt = true;
        } else if (name.substr(0, 2) != "--") {
            o.scene = name;
        } else if (i + 1 < argc) {
            const char* const value = argv[++i];
            if (name == "--view") o.view = value;
            if (name == "--size") std::sscanf(value, "%dx%d", &o.width, &o.height);
            if (name == "--threads") o.threads = std::atoi(value);
            if (name == "--frames") o.frames = std::max(1, std::atoi(value));
            if (name == "--antialiasing") o.antialiasing = std::max(1, std::atoi(value));
            if (name == "--section") {
                SectionPlane& plane = o.section.emplace();
                std::sscanf(value, "%f,%f,%f,%f,%f,%f", &plane.point.x, &plane.point.y, &plane.point.z,
                            &plane.normal.x, &plane.normal.y, &plane.normal.z);
            }
            if (name == "--setting") o.settings.emplace_back(value);
            if (name == "--mirror") o.mirror = static_cast<float>(std::atof(value));
            if (name == "--specular") o.specular = static_cast<float>(std::atof(value));
        }
    }
    return o;
}

void applyView(const Options& o, LoadedScene& loaded) {
    Light light;
    light.position = loaded.camera.eye;
    for (const test::View& view : test::kViews) {
        if (o.view != view.name) continue;
        loaded.camera.eye = view.eye;
        loaded.camera.forward = view.at - view.eye;
        loaded.camera.up = {0, 1, 0};
        loaded.camera.horizontalFov = 75;
        light.position = view.light;
        const float distance = length(view.light - view.at);
        light.intensity = kWhite * (distance * distance * 3);
        loaded.scene.lights = {light};
    }
    if (loaded.scene.lights.empty()) loaded.scene.lights = {light};
    for (Material& m : loaded.scene.materials) {
        if (o.mirror > 0) m.mirror = kWhite * o.mirror;
        if (o.specular > 0) {
            m.specular = kWhite * o.specular;
            m.shininess = 20;
        }
    }
}

/// FNV-1a, to see whether two builds make the same image.
template <typename Pixel>
unsigned long long hashOf(const std::vector<Pixel>& pixels) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const std::byte b : std::as_bytes(std::span(pixels))) {
        hash = (hash ^ std::to_integer<std::uint64_t>(b)) * 0x100000001B3U;
    }
    return hash;
}

class Bench {
  public:
    Bench(const Options& o, const LoadedScene& loaded)
        : options_(o), loaded_(loaded), tracer_(loaded.tree, loaded.scene.mesh()), replay_(tracer_) {
        settings_.width = o.width;
        settings_.height = o.height;
        settings_.antialiasing = o.antialiasing;
        settings_.shadows = o.shadows;
        if (o.shadowMaps) makeMaps();
        for (const std::string& s : o.settings) {
            const std::size_t equals = std::min(s.find('='), s.size() - 1);
            setSettingFromText(settings_, s.substr(0, equals), s.substr(equals + 1));
        }
    }

    void run() {
        if (options_.section)
            return rtbench::raceSections(loaded_, settings_, *options_.section, options_.frames,
                                         options_.rebuilt);
        if (!options_.replayOnly) measureFrames();
        measureWithoutTracing();
    }

  private:
    void makeMaps() {
        const double start = processSeconds();
        maps_ = ShadowMaps::make(loaded_.scene, tracer_, control_.cancel);
        renderer_.takeShadowsFrom(maps_.get());
        std::printf("shadow maps of %zu lights: %.2f s\n", loaded_.scene.lights.size(),
                    processSeconds() - start);
    }
    double render(const RayTracer& tracer, int threads) {
        renderer_.collectAovs(effectsNeedAovs(settings_));
        const double start = processSeconds();
        control_.threads = threads;
        renderer_.render({loaded_.scene, tracer, loaded_.camera, settings_}, control_, frame_);
        return processSeconds() - start;
    }
    double exposure() {
        const double start = processSeconds();
        exposure_ = developer_.exposure(frame_, settings_.exposure, options_.threads);
        return processSeconds() - start;
    }
    double develop() {
        const double start = processSeconds();
        developer_.develop(frame_, settings_, exposure_, options_.threads, image_);
        return processSeconds() - start;
    }

    /// The least of each stage: the machine may do something else meanwhile, and a stage's clock does not
    /// stop.
    static StageTimes endless() {
        StageTimes times;
        times.seconds.fill(1e30);
        return times;
    }
    static void keepMin(StageTimes& min, const StageTimes& times) {
        for (std::size_t i = 0; i < kStages; ++i) min.seconds[i] = std::min(min.seconds[i], times.seconds[i]);
    }

    static void printStages(const char* what, const StageTimes& t) {
        std::printf("  %s, ms: rays %.2f, trace %.2f, surfaces %.2f, occlusion %.2f, light %.2f, shadows "
                    "%.2f, secondary rays "
                    "%.2f, store %.2f\n",
                    what, t.of(Stage::Rays) * 1e3, t.of(Stage::Trace) * 1e3, t.of(Stage::Surfaces) * 1e3,
                    t.of(Stage::Occlusion) * 1e3, t.of(Stage::Light) * 1e3, t.of(Stage::Shadows) * 1e3,
                    t.of(Stage::Secondary) * 1e3, t.of(Stage::Store) * 1e3);
    }

    void measureFrames() {
        double best = 1e30, bestExposure = 1e30, bestDevelop = 1e30, bestWall = 1e30;
        StageTimes stages = endless();
        for (int i = 0; i < options_.frames; ++i) {
            const auto start = std::chrono::steady_clock::now();
            renderer_.measureStages(false);
            render(tracer_, options_.threads);
            exposure();
            develop();
            bestWall = std::min(
                bestWall, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
            renderer_.measureStages(true);
            const double seconds = render(tracer_, options_.threads);
            keepMin(stages, renderer_.stageTimes());
            best = std::min(best, seconds);
            bestExposure = std::min(bestExposure, exposure());
            bestDevelop = std::min(bestDevelop, develop());
        }
        std::printf("%s, %d x %d, %d threads, %s: %.2f ms (wall clock)\n", options_.scene.c_str(),
                    settings_.width, settings_.height, options_.threads, instructionSet().c_str(),
                    bestWall * 1e3);
        printStages("processor time", stages);
        std::printf("  frame %.2f, exposure %.2f, develop %.2f\n", best * 1e3, bestExposure * 1e3,
                    bestDevelop * 1e3);
        const auto rays = frame_.statistics.rays;
        std::printf("  hashes: radiance %016llx, image %016llx\n", hashOf(frame_.radiance.pixels),
                    hashOf(image_.pixels));
        std::printf("  rays: primary %llu, shadow %llu, mirror %llu, refracted %llu, occlusion %llu\n",
                    static_cast<unsigned long long>(rays[0]), static_cast<unsigned long long>(rays[1]),
                    static_cast<unsigned long long>(rays[2]), static_cast<unsigned long long>(rays[3]),
                    static_cast<unsigned long long>(rays[4]));
    }

    void measureWithoutTracing() {
        replay_.rewind(true);
        render(replay_, 1);
        double best = 1e30, bestExposure = 1e30, bestDevelop = 1e30;
        StageTimes stages = endless();
        renderer_.measureStages(true);
        for (int i = 0; i < options_.frames; ++i) {
            replay_.rewind(false);
            const double seconds = render(replay_, 1);
            keepMin(stages, renderer_.stageTimes());
            best = std::min(best, seconds);
            bestExposure = std::min(bestExposure, exposure());
            bestDevelop = std::min(bestDevelop, develop());
        }
        printStages("without tracing", stages);
        std::printf("  without tracing, ms: frame %.2f, exposure %.2f, develop %.2f, all %.2f\n", best * 1e3,
                    bestExposure * 1e3, bestDevelop * 1e3, (best + bestExposure + bestDevelop) * 1e3);
    }

    const Options& options_;
    const LoadedScene& loaded_;
    KdRayTracer tracer_;
    ReplayTracer replay_;
    RenderSettings settings_;
    RenderControl control_;
    std::unique_ptr<const ShadowMaps> maps_;
    FrameRenderer renderer_;
    PictureDeveloper developer_;
    Frame frame_;
    LdrImage image_;
    float exposure_ = 1;
};

} // namespace

int main(int argc, char** argv) {
    const Options options = parse(argc, argv);
    if (options.scene.empty() || options.width < 1 || options.height < 1) {
        std::fprintf(stderr,
                     "bench_frame SCENE [--view NAME] [--size WxH] [--mirror SHARE] [--specular SHARE]\n"
                     "            [--threads N] [--frames N] [--antialiasing N] [--no-shadows]\n"
                     "            [--setting NAME=VALUE]... [--shadow-maps] [--replay-only]\n"
                     "            [--section X,Y,Z,NX,NY,NZ [--rebuilt]]\n");
        return 2;
    }
    try {
        useInstructionSetOfEnvironment();
        LoadedScene loaded = loadScene(options.scene);
        applyView(options, loaded);
        Bench(options, loaded).run();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_frame: %s\n", error.what());
        return 1;
    }
    return 0;
}

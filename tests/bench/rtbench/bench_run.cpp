#include "bench/rtbench/bench_run.h"

#include "bench/rtbench/agreement.h"
#include "bench/rtbench/bench_options.h"
#include "bench/rtbench/bench_view.h"
#include "bench/rtbench/contenders.h"
#include "bench/rtbench/frame_race.h"
#include "bench/rtbench/json_report.h"
#include "bench/rtbench/race.h"
#include "bench/rtbench/scene_loading.h"
#include "bench/rtbench/tables.h"

#include "common/process/stop.h"
#include "common/process/terminal.h"
#include "common/progress/progress.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/simd/instruction_set.h"

#include <algorithm>
#include <atomic>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace rtbench {

namespace {

constexpr int kFrameRounds = 7;

// A mistake in the output's name shows before minutes of work.
void checkJson(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.parent_path();
    std::error_code missing;
    if (folder.empty() || std::filesystem::is_directory(folder, missing)) return;
    throw rtcore::FileError(rtcore::FailureKind::CannotWrite, path.string(),
                            "there is no folder " + folder.string() + "; make it first");
}

void writeJson(const std::filesystem::path& path, const std::string& text) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(text));
    rtcore::writeFileAtomically(path, std::span(&bytes, 1));
}

std::vector<TreeFigures> treesOf(std::span<const Contender> contenders, std::size_t triangles) {
    std::vector<TreeFigures> trees;
    for (const Contender& one : contenders) {
        if (!trees.empty() && trees.back().name == one.tree) continue;
        trees.push_back({one.tree, static_cast<double>(one.memory) / static_cast<double>(triangles)});
    }
    return trees;
}

class Bench {
  public:
    Bench(const BenchOptions& options, app::Progress& progress)
        : options_(options), progress_(progress), embree_(options.embree && hasEmbree()) {}

    app::ExitCode run() {
        if (options_.json) checkJson(*options_.json);
        if (options_.views) views_ = ViewFile(*options_.views);
        if (options_.embree && !hasEmbree())
            progress_.print("this program was built without Embree; our figures alone follow");
        app::writeOutput(std::to_string(options_.threads) +
                         (options_.threads == 1 ? " thread, " : " threads, ") + rtcore::instructionSet() +
                         (embree_ ? ", beside " + embreeName() : "") + "\n\n");
        for (const std::filesystem::path& path : options_.scenes) runScene(path);
        app::writeOutput(meansTable(figures_));
        if (options_.json) writeJson(*options_.json, jsonReport(figures_));
        return agree_ ? app::ExitCode::Done : app::ExitCode::Failed;
    }

  private:
    void runScene(const std::filesystem::path& path) {
        const rtcore::LoadedScene loaded = loadForBench(path, options_, progress_);
        for (const rtcore::Sentence& warning : loaded.warnings)
            progress_.print("warning: " + warning.english());
        if (loaded.scene.mesh().triangles.empty())
            throw rtcore::FileError(rtcore::FailureKind::BadData, path.string(), "it has no triangles");
        std::vector<BenchView> views = views_.viewsOf(path);
        if (views.empty()) views.push_back(makeView(loaded));
        for (const BenchView& view : views) {
            SceneFigures figures{.scene = path.stem().string(),
                                 .view = view.name,
                                 .triangles = loaded.scene.mesh().triangles.size(),
                                 .rays = {},
                                 .frames = {}};
            if (!options_.tests.empty()) raceRays(loaded, view, figures);
            if (options_.frames) raceAllFrames(loaded, view, figures);
            app::writeOutput(sceneTable(figures, options_.modes));
            figures_.push_back(std::move(figures));
        }
    }

    void raceRays(const rtcore::LoadedScene& loaded, const BenchView& view, SceneFigures& figures) {
        const std::vector<Contender> contenders = makeContenders(loaded.tree, loaded.scene.mesh(), embree_);
        figures.trees = treesOf(contenders, figures.triangles);
        const RaySource source(loaded.scene.mesh(), *contenders.front().tracer, view, options_.size);
        for (const RayTest* test : options_.tests) {
            const RaySet rays = source.make(*test);
            if (rays.rays == 0) {
                progress_.print("warning: " + figures.name() + ": the view shows nothing, so there are no " +
                                std::string(test->name) + " rays");
                continue;
            }
            withProgress(figures.name() + " " + std::string(test->name), [&](auto onProgress) {
                RaceOptions race{.threads = options_.threads, .rounds = options_.rounds};
                race.onProgress = onProgress;
                figures.rays.push_back(rtbench::race(rays, contenders, race));
            });
            check(figures, figures.rays.back());
        }
    }

    void raceAllFrames(const rtcore::LoadedScene& loaded, const BenchView& view, SceneFigures& figures) {
        const std::vector<Contender> contenders =
            makeFrameContenders(loaded.tree, loaded.scene.mesh(), embree_);
        withProgress(figures.name() + " frames", [&](auto onProgress) {
            FrameOptions frames{.width = options_.frameWidth,
                                .height = options_.frameHeight,
                                .threads = options_.threads,
                                .rounds = std::min(kFrameRounds, options_.rounds)};
            frames.onProgress = onProgress;
            figures.frames = raceFrames(loaded.scene, view, contenders, frames);
        });
    }

    template <typename Work>
    void withProgress(const std::string& phase, Work&& work) {
        std::atomic<double> fraction{0};
        const app::ProgressScope scope(progress_, {phase, [&] { return fraction.load(); }, nullptr});
        work([&](double done) {
            app::throwIfStopped();
            fraction = done;
        });
    }

    void check(const SceneFigures& scene, const RayFigures& rays) {
        if (!rays.robust || !areMany(rays.robust->differences, rays.rays)) return;
        agree_ = false;
        progress_.print(scene.name() + ", " + std::string(rays.test->name) + ": " +
                        std::to_string(rays.robust->differences) + " of " + std::to_string(rays.rays) +
                        " rays hit something else than Embree's robust mode; one of the two is wrong");
    }

    const BenchOptions& options_;
    app::Progress& progress_;
    const bool embree_;
    ViewFile views_;
    std::vector<SceneFigures> figures_;
    bool agree_ = true;
};

} // namespace

app::ExitCode runBench(const app::Arguments& arguments) {
    BenchOptions options = readBenchOptions(arguments);
    app::Progress progress(benchSpec().name, options.progress);
#ifndef _OPENMP
    if (options.threads > 1) progress.print("warning: built without OpenMP, one thread traces");
    options.threads = 1;
#endif
    return Bench(options, progress).run();
}

} // namespace rtbench

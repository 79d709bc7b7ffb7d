#include "renderer/renderer_run.h"

#include "renderer/frame_list.h"
#include "renderer/load_phases.h"
#include "renderer/picture_maker.h"
#include "renderer/renderer_options.h"
#include "renderer/settings_list.h"

#include "common/run_program.h"
#include "common/terminal.h"
#include "common/threads.h"

#include "rtcore/io/text/camera_list.h"
#include "rtcore/io/text/set.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace renderer {

namespace {

using Paths = std::vector<std::filesystem::path>;

std::string seconds(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f s", value);
    return text;
}

// The patterns of the command line, else the .scn's output, else the scene's name in the current folder.
Paths outputPatterns(const RendererOptions& options, const rtcore::LoadedScene& loaded) {
    if (!options.outputs.empty()) return options.outputs;
    std::filesystem::path output = options.scene.stem().string() + ".png";
    if (loaded.sceneFile && loaded.sceneFile->output) output = *loaded.sceneFile->output;
    try {
        checkOutput(output);
    } catch (const app::UsageError& error) {
        throw rtcore::FileError(rtcore::FailureKind::BadData, options.scene.string(), error.what());
    }
    return {output};
}

// A run of the Renderer on a scene that is loaded.
class Run {
  public:
    Run(const RendererOptions& options, app::Progress& progress, PictureMaker& maker)
        : options_(options), progress_(progress), maker_(maker) {}

    app::ExitCode renderList(std::vector<FrameTask> frames) {
        const std::size_t all = frames.size();
        if (!options_.force) std::erase_if(frames, isFinished);
        if (frames.size() < all) {
            progress_.print(std::to_string(all - frames.size()) + " of " + std::to_string(all) +
                            " frames are there already (--force renders them again)");
        }
        const int count = static_cast<int>(frames.size());
        for (int i = 0; i < count; ++i) renderListed(frames[static_cast<std::size_t>(i)], i + 1, count);
        if (failed_ > 0) {
            progress_.print(std::to_string(failed_) + " of " + std::to_string(count) + " frames failed");
        }
        return result_;
    }

    void renderOne(const FrameTask& frame) { report(frame, maker_.make(frame, 1, 1)); }

  private:
    void renderListed(const FrameTask& frame, int index, int count) {
        try {
            report(frame, maker_.make(frame, index, count));
        } catch (const rtcore::FileError& error) {
            const bool ofThisFrame =
                error.kind == rtcore::FailureKind::BadData || error.kind == rtcore::FailureKind::NoInput;
            if (!ofThisFrame) throw;
            progress_.print(error.what());
            if (failed_++ == 0) {
                result_ = error.kind == rtcore::FailureKind::BadData ? app::ExitCode::BadData
                                                                     : app::ExitCode::NoInput;
            }
        }
    }

    void report(const FrameTask& frame, const FrameReport& report) {
        if (options_.verbose) {
            const double rays = static_cast<double>(report.rays.total());
            char figures[96];
            std::snprintf(figures, sizeof figures, "%.0f rays, %.2f Mrays/s", rays,
                          report.renderSeconds > 0 ? rays / report.renderSeconds * 1e-6 : 0.0);
            progress_.print("rendered " + std::to_string(report.width) + " x " +
                            std::to_string(report.height) + " in " + seconds(report.renderSeconds) + ", " +
                            figures);
        }
        const bool logged = options_.list && options_.progress == app::ProgressStyle::Plain;
        if (!options_.verbose && !logged) return;
        std::string where;
        for (const std::filesystem::path& output : frame.outputs) {
            where += (where.empty() ? "" : ", ") +
                     (isStandardOutput(output) ? "standard output" : output.string());
        }
        progress_.print("wrote " + where + " in " + seconds(report.writeSeconds));
    }

    const RendererOptions& options_;
    app::Progress& progress_;
    PictureMaker& maker_;
    int failed_ = 0;
    app::ExitCode result_ = app::ExitCode::Done;
};

app::ExitCode renderAll(const RendererOptions& options, app::Progress& progress) {
    // Small inputs first: a mistake in one shows before a big scene is loaded.
    std::vector<rtcore::SettingAssignment> settingsFile;
    if (options.settingsFile) settingsFile = rtcore::readSettingsFile(*options.settingsFile).still;
    Paths cameras;
    if (options.list) {
        cameras = rtcore::readCameraList(*options.list);
        if (cameras.empty()) {
            throw rtcore::FileError(rtcore::FailureKind::BadData, options.list->string(),
                                    "it names no .cam file; write one path a line");
        }
    }

    rtcore::LoadedScene loaded = loadWithProgress(options, progress);
    const Paths patterns = outputPatterns(options, loaded);
    const auto ofScene = loaded.sceneFile ? loaded.sceneFile->cameraFile : std::nullopt;
    const std::filesystem::path camera = options.camera.value_or(ofScene.value_or(""));
    PictureMaker maker(std::move(loaded), std::move(settingsFile), options, progress);
    Run run(options, progress, maker);
    if (options.list) return run.renderList(framesOfList(cameras, options.frames, patterns));
    run.renderOne(singleFrame(camera, patterns));
    return app::ExitCode::Done;
}

} // namespace

app::ExitCode runRenderer(const app::Arguments& arguments) {
    if (arguments.has("settings")) {
        app::writeOutput(settingsList());
        return app::ExitCode::Done;
    }
    const RendererOptions options = readRendererOptions(arguments);
    app::useThreads(options.threads);
    app::Progress progress(rendererSpec().name, options.progress);
    if (options.debugScene) progress.print("warning: the debug scene is not exported by this version yet");
    return renderAll(options, progress);
}

} // namespace renderer

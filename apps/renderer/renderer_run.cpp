#include "renderer/renderer_run.h"

#include "renderer/flight_list.h"
#include "renderer/frame_list.h"
#include "renderer/frame_run.h"
#include "renderer/list_run.h"
#include "renderer/load_phases.h"
#include "renderer/output_patterns.h"
#include "renderer/picture_maker.h"
#include "renderer/plan_making.h"
#include "renderer/preview.h"
#include "renderer/renderer_options.h"
#include "renderer/settings_list.h"
#include "renderer/stand_by.h"
#include "renderer/variant_choice.h"
#include "renderer/verify.h"

#include "common/cli/input_files.h"
#include "common/process/error_sentence.h"
#include "common/process/ipc_exit_code.h"
#include "common/process/parent.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"
#include "common/process/threads.h"

#include "rtcore/io/debug/debug_scene.h"
#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/set.h"
#include "rtcore/neural/net_files.h"
#include "rtcore/platform/error.h"

#include <optional>
#include <utility>
#include <vector>

namespace renderer {

namespace {

using Paths = std::vector<std::filesystem::path>;

/// All that is read, but for the cameras of a list that still grows.
app::InputFiles inputsOf(const RendererOptions& options, const rtcore::LoadedScene& loaded,
                         const Paths& cameras) {
    app::InputFiles inputs;
    inputs.add(loaded.files);
    inputs.add(cameras);
    for (const auto& named :
         {options.camera, options.list, options.settingsFile, options.light, options.backdropFile}) {
        if (named) inputs.add(*named);
    }
    return inputs;
}

void drawDebugScene(const std::filesystem::path& path, const std::filesystem::path& camera,
                    const app::InputFiles& inputs, PictureMaker& maker) {
    inputs.refuse(path);
    inputs.refuse(rtcore::debugMaterials(path));
    maker.writeDebugScene(camera, path);
}

app::ExitCode renderAll(const RendererOptions& options, app::Progress& progress) {
    // Small inputs first: a mistake in one shows before a big scene is loaded.
    std::vector<rtcore::SettingAssignment> settingsFile;
    if (options.settingsFile) settingsFile = rtcore::readSettingsFile(*options.settingsFile).still;
    Paths cameras;
    if (options.list && !options.follow) {
        cameras = rtcore::readCameraList(*options.list);
        if (cameras.empty()) {
            throw rtcore::FileError(rtcore::FailureKind::BadData, options.list->string(),
                                    "it names no .cam file; write one path a line");
        }
    }

    if (options.light && !options.hasFrames() && !std::filesystem::exists(*options.light))
        throw rtcore::FileError(rtcore::FailureKind::NoInput, options.light->string(), "no such file");

    const auto ffmpeg = findFilmMaker(options);
    std::optional<Preview> preview;
    if (options.preview) preview.emplace(*options.preview);
    if (preview && options.backdrop) preview->useBackdrop(*options.backdrop);
    if (options.standBy) return standBy(options, settingsFile, *preview, progress);

    rtcore::LoadedScene loaded = loadWithProgress(options, progress);
    const Paths patterns = outputPatterns(options, loaded.sceneFile ? &*loaded.sceneFile : nullptr);
    if (options.aovs && !options.makeList) checkAovs(patterns);
    if (options.alpha) checkAlpha(patterns, options.standardOutputFormat);
    if (options.backdrop) checkBackdrop(patterns);
    const auto ofScene = loaded.sceneFile ? loaded.sceneFile->cameraFile : std::nullopt;
    const std::filesystem::path camera = options.camera.value_or(ofScene.value_or(""));
    PictureMaker maker(std::move(loaded), std::move(settingsFile), options, progress);
    if (options.makeList) {
        makeList(options, maker, progress);
        return app::ExitCode::Done;
    }
    std::optional<FlightList> flight;
    if (options.flight) cameras = flight.emplace(options, maker).cameras();
    const app::InputFiles inputs = inputsOf(options, maker.loaded(), cameras);
    if (options.plan) {
        makePlan(*options.plan, maker, inputs, progress);
        return app::ExitCode::Done;
    }
    if (options.debugScene) {
        drawDebugScene(*options.debugScene, camera, inputs, maker);
        return app::ExitCode::Done;
    }
    if (options.makeLight) {
        inputs.refuse(*options.makeLight);
        maker.setList(cameras);
        maker.makeLight(options.camera.value_or(""), *options.makeLight);
        return app::ExitCode::Done;
    }
    if (options.report) inputs.refuse(*options.report);
    if (options.hasFrames()) return runList(options, cameras, patterns, inputs, ffmpeg, maker, progress);
    if (preview) maker.showOn(&*preview);
    const FrameTask frame = singleFrame(camera, patterns);
    refuseInputs(inputs, frame);
    FrameRun(options, progress, maker).renderOne(frame);
    if (preview) preview->linger();
    return app::ExitCode::Done;
}

app::ExitCode renderVariants(const RendererOptions& options, app::Progress& progress) {
    for (const RendererOptions& run : runsOf(options)) {
        const app::ExitCode code = renderAll(run, progress);
        if (code != app::ExitCode::Done) return code;
    }
    return app::ExitCode::Done;
}

} // namespace

app::ExitCode runRenderer(const app::Arguments& arguments) {
    if (arguments.has("settings")) {
        app::writeOutput(settingsList());
        return app::ExitCode::Done;
    }
    const RendererOptions options = readRendererOptions(arguments);
    if (options.parent) app::stopWithParent(*options.parent);
    app::useThreads(options.threads);
    app::Progress progress(rendererSpec().name, options.progress);
    if (options.verify) return verifyFrames(options, progress);
    try {
        return renderVariants(options, progress);
    } catch (const rtcore::FileError& error) {
        const bool terminated =
            error.kind == rtcore::FailureKind::Stopped && app::stopExitCode() == app::ExitCode::Terminated;
        if (!terminated || !options.requeue) throw;
        progress.tell(rtcore::form("stopped; try again"));
        return app::ExitCode::TryAgain;
    } catch (const ipc::Error& error) {
        progress.tell(app::sentenceOf(error));
        return app::exitCodeOf(error.problem);
    }
}

app::Feature netFeature() {
    const rtcore::FoundNet found = rtcore::findNet(rtcore::fileOf(rtcore::Net::Base));
    return {"weights of nets", !found.file.empty(), found.missing.english()};
}

} // namespace renderer

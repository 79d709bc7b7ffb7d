#include "renderer/picture_maker.h"

#include "common/settings_merge.h"
#include "renderer/load_phases.h"

#include "common/command_line.h"
#include "common/stop.h"
#include "common/terminal.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace renderer {

namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string_view asText(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

PictureMaker::PictureMaker(rtcore::LoadedScene scene, std::vector<rtcore::SettingAssignment> settingsFile,
                           const RendererOptions& options, app::Progress& progress)
    : loaded_(std::move(scene)), lights_(loaded_.scene.lights), environment_(loaded_.scene.activeEnvironment),
      settingsFile_(std::move(settingsFile)), options_(options), progress_(progress),
      tracer_(loaded_.tree, loaded_.scene.mesh(), chooseLeafRecords(loaded_.tree, knownRays(options))) {}

FrameReport PictureMaker::make(const FrameTask& task, int index, int count) {
    rtcore::Camera camera = loaded_.camera;
    const rtcore::RenderSettings settings = prepare(task, camera);
    warnOfWhatIsMissing(settings);

    FrameReport report{.width = settings.width, .height = settings.height, .rays = {}};
    auto start = std::chrono::steady_clock::now();
    render(camera, settings, index, count);
    report.renderSeconds = secondsSince(start);
    report.rays = frame_.statistics;

    start = std::chrono::steady_clock::now();
    const float exposure = develop(task, settings);
    write(task);
    // The last: who has seen it may end this process.
    if (preview_ != nullptr) preview_->finish(developed_, exposure);
    report.writeSeconds = secondsSince(start);
    return report;
}

rtcore::RenderSettings PictureMaker::prepare(const FrameTask& task, rtcore::Camera& camera) {
    loaded_.scene.lights = lights_;
    loaded_.scene.activeEnvironment = environment_;
    std::optional<rtcore::CameraFile> file;
    if (!task.camera.empty()) {
        file = rtcore::readCameraFile(task.camera);
        camera = file->camera;
        app::applyCameraToScene(*file, task.camera, loaded_.scene);
    }
    return app::mergeSettings({.scene = loaded_.still,
                               .settingsFile = settingsFile_,
                               .camera = file ? &*file : nullptr,
                               .commandLine = options_.settings});
}

void PictureMaker::render(const rtcore::Camera& camera, const rtcore::RenderSettings& settings, int index,
                          int count) {
    app::throwIfStopped();
    if (static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height) >
        rtcore::kMaxImagePixels) {
        throw app::UsageError("a picture of " + std::to_string(settings.width) + " x " +
                              std::to_string(settings.height) + " pixels is too large; " +
                              std::to_string(rtcore::kMaxImagePixels) + " pixels is the most");
    }
    rtcore::RenderControl control;
    const auto fraction = [this, &control] {
        if (preview_ != nullptr) return preview_->fraction(control);
        const std::uint64_t tiles = control.tiles.load();
        return tiles == 0 ? 0.0 : static_cast<double>(control.tilesDone.load()) / static_cast<double>(tiles);
    };
    const app::ProgressScope scope(progress_, {"rendering", fraction, &control.cancel}, index, count);
    const rtcore::Scene& scene = loaded_.scene;
    const bool whole = preview_ == nullptr ? renderer_.render(scene, tracer_, camera, settings,
                                                              options_.threads, control, frame_)
                                           : preview_->render(renderer_, scene, tracer_, camera, settings,
                                                              options_.threads, control, frame_);
    if (!whole) {
        throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    }
    app::throwIfStopped();
}

float PictureMaker::develop(const FrameTask& task, const rtcore::RenderSettings& settings) {
    const bool shown = std::any_of(task.outputs.begin(), task.outputs.end(), [](const auto& output) {
        return isStandardOutput(output) || !rtcore::isHdrFormat(output);
    });
    if (!shown && !task.filmed && preview_ == nullptr) return 0;
    const float exposure = developer_.exposure(frame_, settings.exposure, options_.threads);
    developer_.develop(frame_, settings, exposure, options_.threads, developed_);
    return exposure;
}

void PictureMaker::write(const FrameTask& task) {
    for (const std::filesystem::path& output : task.outputs) {
        app::throwIfStopped();
        if (isStandardOutput(output)) {
            app::writeOutput(asText(rtcore::encodeImage(developed_, options_.standardOutputFormat)));
        } else if (rtcore::isHdrFormat(output)) {
            rtcore::writeHdrImage(output, frame_.radiance);
        } else {
            rtcore::writeImage(output, developed_);
        }
    }
}

void PictureMaker::warnOfWhatIsMissing(const rtcore::RenderSettings& settings) {
    if (settings.bloom > 0) warnOnce("bloom is not rendered by this version yet");
    if (loaded_.scene.fog.kind != rtcore::FogKind::None) warnOnce("fog is not rendered by this version yet");
}

void PictureMaker::warnOnce(const std::string& text) {
    if (warned_.insert(text).second) progress_.print("warning: " + text);
}

} // namespace renderer

#include "renderer/picture_maker.h"

#include "common/settings/image_texts.h"
#include "common/settings/settings_merge.h"
#include "renderer/aov_file.h"
#include "renderer/exposure_scale.h"
#include "renderer/load_phases.h"
#include "renderer/unused_settings.h"

#include "common/cli/command_line.h"
#include "common/process/seconds_since.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"

#include "rtcore/io/debug/debug_scene.h"
#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/error.h"
#include "rtcore/post/effects.h"
#include "rtcore/render/ground_tracer.h"
#include "rtcore/render/visible_scene.h"
#include "rtcore/settings/settings_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace renderer {

namespace {

std::uint64_t allSamples(const rtcore::RenderSettings& settings) {
    const auto size = [](int number) { return static_cast<std::uint64_t>(number); };
    return size(settings.width) * size(settings.height) * size(settings.antialiasing) *
           size(settings.antialiasing);
}

/// A tree that was built for few rays tells that there are few.
rtcore::KdTree visibleTreeOf(const rtcore::LoadedScene& loaded, const RendererOptions& options) {
    rtcore::BuildOptions build;
    build.threads = options.threads;
    return loaded.fastTree ? rtcore::visibleTree(loaded.tree, loaded.scene)
                           : rtcore::buildVisibleTree(loaded.tree, loaded.scene, build);
}

int seedOfFrame(int seed, int number) {
    const int seeds = static_cast<int>(rtcore::requireSetting("path.seed").maximum) + 1;
    return (seed + number % seeds) % seeds;
}

std::string_view asText(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

PictureMaker::PictureMaker(rtcore::LoadedScene scene, std::vector<rtcore::SettingAssignment> settingsFile,
                           const RendererOptions& options, app::Progress& progress)
    : loaded_(std::move(scene)), lights_(loaded_.scene.lights), environment_(loaded_.scene.activeEnvironment),
      settingsFile_(std::move(settingsFile)), options_(options), progress_(progress),
      tree_(visibleTreeOf(loaded_, options)),
      surfaces_(std::make_shared<const rtcore::KdRayTracer>(tree_, loaded_.scene.model.mesh,
                                                            chooseLeafRecords(tree_, knownRays(options)))) {}

FrameReport PictureMaker::make(const FrameTask& task, int index, int count) {
    Shot shot = prepare(task);
    const rtcore::Camera& camera = shot.camera;
    rtcore::RenderSettings& settings = shot.settings;
    focus(camera, settings);

    FrameReport report{.width = settings.width, .height = settings.height, .rays = {}};
    auto start = std::chrono::steady_clock::now();
    render(camera, settings, index, count);
    report.renderSeconds = app::secondsSince(start);
    report.rays = frame_.statistics;
    if (rtcore::samplesAdaptively(settings)) report.samples = allSamples(settings);

    start = std::chrono::steady_clock::now();
    const rtcore::HdrImage& radiance = developer_.finish(frame_, settings, options_.threads);
    const float exposure = develop(task, radiance, settings);
    write(task, radiance, settings);
    // This must come last: a viewer that has seen it may end this process.
    if (preview_ != nullptr) preview_->finish(developed_, exposure);
    report.writeSeconds = app::secondsSince(start);
    return report;
}

void PictureMaker::writeDebugScene(const std::filesystem::path& cameraFile,
                                   const std::filesystem::path& path) {
    const Shot shot = prepare(cameraFile);
    rtcore::writeDebugScene(path, loaded_.scene, tree_, *surfaces_, shot.camera, shot.settings.width,
                            shot.settings.height);
}

PictureMaker::Shot PictureMaker::prepare(const std::filesystem::path& cameraFile) {
    Shot shot{.camera = loaded_.camera, .settings = {}};
    loaded_.scene.lights = lights_;
    loaded_.scene.activeEnvironment = environment_;
    std::optional<rtcore::CameraFile> file;
    if (!cameraFile.empty()) {
        file = rtcore::readCameraFile(cameraFile);
        shot.camera = file->camera;
        shot.recorded = hasRecordedExposure(*file, options_.settings);
        const std::string warning = app::applyCameraToScene(*file, cameraFile, loaded_.scene);
        app::selectLights(options_.selection, loaded_.scene);
        // Once: the other cameras of a list say the same.
        if (!warning.empty() && !warned_) progress_.print("warning: " + warning);
        warned_ = warned_ || !warning.empty();
    }
    shot.settings = app::mergeSettings({.scene = loaded_.still,
                                        .settingsFile = settingsFile_,
                                        .camera = file ? &*file : nullptr,
                                        .commandLine = options_.settings});
    const std::string unused = unusedSettingsWarning(shot.settings, settingsFile_, options_.settings);
    if (!unused.empty() && !std::exchange(warnedOfUnused_, true)) progress_.print(unused);
    return shot;
}

PictureMaker::Shot PictureMaker::prepare(const FrameTask& task) {
    Shot shot = prepare(task.camera);
    rtcore::PathSettings& path = shot.settings.path;
    if (options_.list && path.seedPerFrame) path.seed = seedOfFrame(path.seed, task.number);
    if (!shot.recorded) return shot;
    rtcore::ExposureSettings& exposure = shot.settings.exposure;
    if (exposure.recorded == rtcore::RecordedExposure::Automatic) exposure.mode = measured();
    const bool scaled = exposure.recorded == rtcore::RecordedExposure::Scaled &&
                        shot.settings.integrator == rtcore::Integrator::Path;
    if (scaled) exposure.value = exposure.value * recordedScale(task.camera);
    return shot;
}

/// How the scene's exposure is found anew, whatever a .cam says.
rtcore::ExposureMode PictureMaker::measured() const {
    const rtcore::RenderSettings settings = app::mergeSettings({.scene = loaded_.still,
                                                                .settingsFile = settingsFile_,
                                                                .camera = nullptr,
                                                                .commandLine = options_.settings});
    const bool incident = settings.exposure.mode == rtcore::ExposureMode::Incident;
    return incident ? rtcore::ExposureMode::Incident : rtcore::ExposureMode::Automatic;
}

/// Of the list's first frame, also where another machine renders that one.
float PictureMaker::recordedScale(const std::filesystem::path& cameraFile) {
    if (scale_) return *scale_;
    const std::filesystem::path& first = firstOfList_.empty() ? cameraFile : firstOfList_;
    const Shot shot = prepare(first);
    rtcore::RenderControl control{.threads = options_.threads};
    const app::ProgressScope scope(
        progress_, {"measuring the light", [&control] { return control.fraction(); }, &control.cancel});
    const auto tracer = rtcore::withGround(surfaces_, loaded_.scene);
    scale_ = exposureScale({loaded_.scene, *tracer, shot.camera, shot.settings}, control, renderer_, paths_);
    if (options_.verbose)
        progress_.print(fmt::format(
            "recorded exposures are scaled by {:.4g}: the mean of {} by paths over that by Whitted's rays",
            *scale_, first.string()));
    prepare(cameraFile); // its lights, in place of those of the first
    return *scale_;
}

void PictureMaker::focus(const rtcore::Camera& camera, rtcore::RenderSettings& settings) {
    if (!options_.focusAt) return;
    const auto [x, y] = *options_.focusAt;
    if (x > static_cast<float>(settings.width) || y > static_cast<float>(settings.height)) {
        throw app::UsageError(fmt::format("--focus-at lies outside of the image, which has {} x {} pixels",
                                          settings.width, settings.height));
    }
    const rtcore::CameraRays view(camera, settings.width, settings.height);
    settings.depthOfField.on = true;
    settings.depthOfField.focus =
        rtcore::FocusFinder().distance(*rtcore::withGround(surfaces_, loaded_.scene), view, x, y);
    if (!options_.verbose) return;
    const bool infinite = settings.depthOfField.focus >= rtcore::kInfiniteFocus;
    progress_.print("focused at " +
                    (infinite ? "infinity" : rtcore::settingText(settings.depthOfField.focus)));
}

void PictureMaker::render(const rtcore::Camera& camera, const rtcore::RenderSettings& settings, int index,
                          int count) {
    app::throwIfStopped();
    if (static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height) >
        rtcore::kMaxImagePixels) {
        throw app::UsageError(fmt::format("an image of {} x {} pixels is too large; {} pixels is the most",
                                          settings.width, settings.height, rtcore::kMaxImagePixels));
    }
    rtcore::RenderControl control{.threads = options_.threads};
    const auto fraction = [this, &control] {
        return preview_ != nullptr ? preview_->fraction(control) : control.fraction();
    };
    const app::ProgressScope scope(progress_, {"rendering", fraction, &control.cancel}, index, count);
    const bool aovs = options_.aovs || rtcore::effectsNeedAovs(settings);
    renderer_.collectAovs(aovs);
    const auto tracer = rtcore::withGround(surfaces_, loaded_.scene);
    const rtcore::View view{loaded_.scene, *tracer, camera, settings};
    white_.reset();
    if (settings.exposure.mode == rtcore::ExposureMode::Incident) white_ = meter_.white(view, control);
    if (preview_ != nullptr) preview_->meter(white_);
    bool whole = false;
    if (settings.integrator == rtcore::Integrator::Path) {
        whole = renderPaths(view, control, aovs);
    } else {
        whole = preview_ == nullptr ? renderer_.render(view, control, frame_)
                                    : preview_->render(renderer_, view, control, frame_);
    }
    if (!whole) {
        throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    }
    app::throwIfStopped();
}

bool PictureMaker::renderPaths(const rtcore::View& view, rtcore::RenderControl& control, bool aovs) {
    bool whole = false;
    if (preview_ == nullptr) {
        whole = paths_.render(view, control, frame_);
    } else {
        whole = findSurfaces(view, control.threads, 1) &&
                preview_->render(paths_, view, control, frame_, aovFrame_.aovs);
    }
    if (!whole) return false;
    tellOfPaths(paths_);
    if (!aovs) return true;
    constexpr int kSamples = 4; // each way: edges are as smooth as those of the image
    if (!findSurfaces(view, control.threads, kSamples)) return false;
    std::swap(frame_.aovs, aovFrame_.aovs);
    return true;
}

/// AOVs of paths are those of rays, which see the same first.
bool PictureMaker::findSurfaces(const rtcore::View& view, int threads, int samples) {
    rtcore::RenderSettings rays = view.settings;
    rays.integrator = rtcore::Integrator::Whitted;
    rays.antialiasing = samples;
    rays.adaptive = 0;
    rays.ambientOcclusion.on = rays.skyLight.on = false;
    rtcore::RenderControl quietly{.threads = threads};
    renderer_.collectAovs(true);
    return renderer_.render({view.scene, view.tracer, view.camera, rays}, quietly, aovFrame_);
}

/// What light there is by paths, once a run, where --verbose asks; and what was lost, always.
void PictureMaker::tellOfPaths(const rtcore::PathRenderer& paths) {
    const std::uint64_t dropped = paths.sums().dropped();
    if (dropped > 0) {
        progress_.print(fmt::format("warning: {} samples were not finite and do not count; the scene has "
                                    "numbers that are too large",
                                    dropped));
    }
    const std::uint64_t clipped = paths.sums().clipped();
    if (clipped > 0 && options_.verbose) {
        progress_.print(
            fmt::format("{} samples are brighter than {:.3g} and count as that: the image has less light "
                        "than the scene",
                        clipped, paths.sums().largest()));
    }
    if (!options_.verbose || std::exchange(toldOfPaths_, true)) return;
    progress_.print(fmt::format("paths are lit by {} lights, {} emissive triangles{}",
                                paths.lights().lights().size(), paths.lights().emitters().size(),
                                paths.lights().surroundings().empty() ? "" : ", and the surroundings"));
    for (std::size_t i = 0; i < paths.lights().dark().size(); ++i) {
        if (paths.lights().dark()[i] == 0) continue;
        progress_.print(fmt::format("material {} is seen to emit light, but lights nothing", i));
    }
}

float PictureMaker::develop(const FrameTask& task, const rtcore::HdrImage& radiance,
                            const rtcore::RenderSettings& settings) {
    const bool shown = std::any_of(task.outputs.begin(), task.outputs.end(), [](const auto& output) {
        return isStandardOutput(output) || !rtcore::isHdrFormat(output);
    });
    if (!shown && !task.filmed && preview_ == nullptr) return 0;
    const float exposure = developer_.exposure(frame_, settings, white_, options_.threads);
    developer_.develop(radiance, settings, exposure, options_.threads, developed_);
    return exposure;
}

void PictureMaker::write(const FrameTask& task, const rtcore::HdrImage& radiance,
                         const rtcore::RenderSettings& settings) {
    const std::vector<rtcore::ImageText> texts = app::imageTexts(settings);
    for (const std::filesystem::path& output : task.outputs) {
        app::throwIfStopped();
        if (isStandardOutput(output)) {
            app::writeOutput(asText(rtcore::encodeImage(developed_, options_.standardOutputFormat, texts)));
        } else if (options_.aovs && rtcore::isExr(output)) {
            writeAovs(output, radiance, frame_.aovs, texts);
        } else if (rtcore::isHdrFormat(output)) {
            rtcore::writeHdrImage(output, radiance, texts);
        } else {
            rtcore::writeImage(output, developed_, texts);
        }
    }
}

} // namespace renderer

#include "renderer/picture_maker.h"

#include "common/settings/image_texts.h"
#include "common/settings/settings_merge.h"
#include "renderer/aov_file.h"
#include "renderer/exposure_scale.h"
#include "renderer/ground_shadow.h"
#include "renderer/light_making.h"
#include "renderer/load_phases.h"
#include "renderer/unused_settings.h"

#include "common/cli/command_line.h"
#include "common/process/error_sentence.h"
#include "common/process/seconds_since.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"

#include "rtcore/io/debug/debug_scene.h"
#include "rtcore/io/images/image_file.h"
#include "rtcore/look/light_units.h"
#include "rtcore/look/walk_grid.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/post/background.h"
#include "rtcore/post/effects.h"
#include "rtcore/post/legend.h"
#include "rtcore/post/net_denoise.h"
#include "rtcore/render/shown_tracer.h"
#include "rtcore/render/steady_image.h"
#include "rtcore/render/visible_scene.h"
#include "rtcore/settings/plain_text.h"
#include "rtcore/settings/settings_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace renderer {

namespace {

constexpr int kPassesInPlace = 3; ///< of the filter where there is no net

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

/// By as much of each pixel as nothing covers.
void whiten(rtcore::LdrImage& image, const std::vector<std::uint8_t>& covered) {
    constexpr int kAll = 255;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto mixed = [&](std::uint8_t colour) {
            return static_cast<std::uint8_t>(kAll - (kAll - colour) * covered[i] / kAll);
        };
        rtcore::Rgba8& pixel = image.pixels[i];
        pixel = {mixed(pixel.r), mixed(pixel.g), mixed(pixel.b)};
    }
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
      sharedLight_(options, progress), tree_(visibleTreeOf(loaded_, options)),
      surfaces_(std::make_shared<const rtcore::KdRayTracer>(tree_, loaded_.scene.model.mesh,
                                                            chooseLeafRecords(tree_, knownRays(options)))),
      nets_(options.nets), backdrop_(options.backdrop) {}

FrameReport PictureMaker::make(const FrameTask& task, int index, int count) {
    Shot shot = prepare(task);
    const rtcore::Camera& camera = shot.camera;
    rtcore::RenderSettings& settings = shot.settings;
    focus(camera, settings);
    chooseNet(settings);
    shareLight(task, settings);

    FrameReport report{
        .width = settings.width, .height = settings.height, .rays = {}, .net = {}, .settings = settings};
    auto start = std::chrono::steady_clock::now();
    render(camera, settings, index, count);
    if (options_.groundShadow) addGroundShadow(camera, settings, index, count);
    report.renderSeconds = app::secondsSince(start);
    report.rays = frame_.statistics;
    if (rtcore::samplesAdaptively(settings) && !options_.hidesBackground())
        report.samples = allSamples(settings);

    start = std::chrono::steady_clock::now();
    const rtcore::HdrImage& radiance = finish(settings, index, count);
    report.net = developer_.netReport();
    const float exposure = develop(task, shot, radiance);
    write(task, radiance, settings);
    // This must come last: a viewer that has seen it may end this process.
    if (preview_ != nullptr)
        preview_->finish(developed_, exposure, {developer_.netReport(), developer_.netErrors()});
    report.writeSeconds = app::secondsSince(start);
    return report;
}

const rtcore::LdrImage& PictureMaker::picture(const rtcore::Camera& camera, int width, int height,
                                              const rtcore::SectionPlanes& sections) {
    FrameTask task;
    task.filmed = true; // it is wanted as it is shown
    Shot shot = prepare(task);
    shot.camera = camera;
    shot.settings.width = width;
    shot.settings.height = height;
    shot.settings.falseColours.legend = false; // the paper would go through it
    loaded_.scene.sections = sections;
    loaded_.scene.uncutParts = nullptr; // drawings know none
    chooseNet(shot.settings);
    shareLight(task, shot.settings);
    render(shot.camera, shot.settings, 1, 1);
    develop(task, shot, finish(shot.settings, 1, 1));
    whiten(developed_, frame_.covered);
    return developed_;
}

void PictureMaker::writeDebugScene(const std::filesystem::path& cameraFile,
                                   const std::filesystem::path& path) {
    const Shot shot = prepare(cameraFile);
    rtcore::writeDebugScene(path, loaded_.scene, tree_, *surfaces_, shot.camera, shot.settings.width,
                            shot.settings.height);
}

void PictureMaker::shareLight(const FrameTask& task, const rtcore::RenderSettings& settings) {
    if (!SharedLight::lights(settings)) return sharedLight_.tellUnused();
    const rtcore::Scene lit = loaded_.scene;
    const auto tracer = rtcore::shownTracer(surfaces_, lit, sections_);
    const bool byPaths = settings.integrator == rtcore::Integrator::Path;
    const rtcore::RenderSettings own = byPaths ? rtcore::steadySettings(settings) : settings;
    const auto kept = sharedLight_.of({lit, *tracer, own}, [&] {
        std::vector<LightView> views = viewsOfList(lit);
        prepare(task.camera); // its lights, in place of those of the last
        return views;
    });
    images_.beginWith(kept);
    meter_.beginWith(kept);
}

/// Those in the light of `lit`, as evenly spread as there are too many. A .cam that is bad is told of when
/// its frame comes.
std::vector<LightView> PictureMaker::viewsOfList(const rtcore::Scene& lit) {
    constexpr std::size_t kMax = 500;
    const std::size_t taken = std::min(list_.size(), kMax);
    std::vector<LightView> views;
    for (std::size_t i = 0; i < taken; ++i) {
        try {
            const Shot shot = prepare(list_[i * list_.size() / taken]);
            if (loaded_.scene.lights == lit.lights &&
                loaded_.scene.activeEnvironment == lit.activeEnvironment)
                views.push_back({shot.camera, shot.settings.width, shot.settings.height});
        } catch (const rtcore::FileError& error) {
            const bool ofThisFrame =
                error.kind == rtcore::FailureKind::BadData || error.kind == rtcore::FailureKind::NoInput;
            if (!ofThisFrame) throw;
        }
    }
    return views;
}

/// The view that is shown first, then those of a walk, whose images are square and of larger pixels: one who
/// walks there finds all light, if not all of its details.
std::vector<LightView> PictureMaker::viewsAllOver(const rtcore::RenderSettings& settings) const {
    constexpr int kCoarser = 2;
    std::vector<LightView> views{{loaded_.camera, settings.width, settings.height}};
    const rtcore::Scene& scene = loaded_.scene;
    const rtcore::Survey survey = rtcore::survey(tree_, scene.model.mesh, rtcore::axesOf(scene));
    for (const rtcore::Camera& camera : rtcore::walkGrid(tree_, scene.model.mesh, survey))
        views.push_back({camera, settings.width / kCoarser, settings.width / kCoarser});
    return views;
}

void PictureMaker::makeLight(const std::filesystem::path& camera, const std::filesystem::path& path) {
    const Shot shot = prepare(list_.empty() ? camera : list_.front());
    const rtcore::Scene lit = loaded_.scene;
    const auto tracer = rtcore::shownTracer(surfaces_, lit, sections_);
    std::vector<LightView> views;
    if (!list_.empty()) {
        views = viewsOfList(lit);
    } else if (!camera.empty()) {
        views = {{shot.camera, shot.settings.width, shot.settings.height}};
    } else {
        views = viewsAllOver(shot.settings);
    }
    renderer::makeLight(path, {lit, *tracer, shot.settings}, views, options_.lightBounds, options_.threads,
                        progress_);
}

PictureMaker::Shot PictureMaker::prepare(const std::filesystem::path& cameraFile) {
    Shot shot{.camera = loaded_.camera, .settings = {}};
    if (asLoaded_) loaded_.scene = *std::exchange(asLoaded_, std::nullopt);
    loaded_.scene.lights = lights_;
    loaded_.scene.activeEnvironment = environment_;
    std::optional<rtcore::CameraFile> file;
    if (!cameraFile.empty()) {
        file = rtcore::readCameraFile(cameraFile, loaded_.scene.origin);
        shot.camera = file->camera;
        shot.recorded = hasRecordedExposure(*file, options_.settings);
        const rtcore::Sentence warning = app::applyCameraToScene(*file, cameraFile, loaded_.scene);
        app::selectLights(options_.selection, loaded_.scene);
        // Once: the other cameras of a list say the same.
        if (!warning.empty() && !warned_) progress_.tell(rtcore::say("warning: {0}", warning));
        warned_ = warned_ || !warning.empty();
    }
    shot.settings = app::mergeSettings({.scene = loaded_.still,
                                        .settingsFile = settingsFile_,
                                        .camera = file ? &*file : nullptr,
                                        .commandLine = options_.settings});
    if (options_.panorama) makePanorama(*options_.panorama, shot);
    const rtcore::Sentence unused = unusedSettingsWarning(shot.settings, settingsFile_, options_.settings);
    if (!unused.empty() && !std::exchange(warnedOfUnused_, true))
        progress_.tell(rtcore::say("warning: {0}", unused));
    if (shot.settings.falseColours.on) useOneUnit(shot.settings);
    return shot;
}

/// Upright, with what the camera looks at in the middle.
void PictureMaker::makePanorama(int width, Shot& shot) const {
    const rtcore::Vec3 up = loaded_.scene.up;
    rtcore::Camera& camera = shot.camera;
    // Of a camera that looks straight up or down, the top or the bottom of its image is ahead.
    const rtcore::Vec3 ahead = areParallel(camera.forward, up)
                                   ? camera.up * (dot(camera.forward, up) > 0 ? -1.0F : 1.0F)
                                   : camera.forward;
    camera.forward = normalize(ahead - up * dot(ahead, up));
    camera.up = up;
    camera.kind = rtcore::CameraKind::Panorama;
    camera.aspect = 0;
    shot.settings.width = width;
    shot.settings.height = width / 2;
    shot.settings.depthOfField.on = false;
}

/// For false colours.
void PictureMaker::useOneUnit(const rtcore::RenderSettings& settings) {
    unit_ = rtcore::unitOfImages(loaded_.scene, settings);
    developer_.useUnit(unit_);
    const rtcore::Sentence warning = rtcore::unitWarning(rtcore::unitlessLight(loaded_.scene, settings));
    if (!warning.empty() && !std::exchange(warnedOfUnit_, true))
        progress_.tell(rtcore::say("warning: {0}", warning));
    std::optional<rtcore::Scene> inOneUnit = rtcore::inUnitOfSky(loaded_.scene);
    if (inOneUnit) asLoaded_ = std::exchange(loaded_.scene, *std::move(inOneUnit));
}

PictureMaker::Shot PictureMaker::prepare(const FrameTask& task) {
    Shot shot = prepare(task.camera);
    if (options_.hasFrames() && shot.settings.falseColours.on) shareScale(task, shot);
    rtcore::PathSettings& path = shot.settings.path;
    if (options_.hasFrames() && path.seedPerFrame) path.seed = seedOfFrame(path.seed, task.number);
    if (!shot.recorded) return shot;
    rtcore::ExposureSettings& exposure = shot.settings.exposure;
    if (exposure.recorded == rtcore::RecordedExposure::Automatic) exposure.mode = measured();
    const bool scaled = exposure.recorded == rtcore::RecordedExposure::Scaled &&
                        shot.settings.integrator != rtcore::Integrator::Whitted;
    if (scaled) exposure.value = exposure.value * recordedScale(task.camera);
    return shot;
}

rtcore::RenderSettings PictureMaker::ownSettings() const {
    return app::mergeSettings({.scene = loaded_.still,
                               .settingsFile = settingsFile_,
                               .camera = nullptr,
                               .commandLine = options_.settings});
}

void PictureMaker::readNet() {
    rtcore::RenderSettings settings = ownSettings();
    chooseNet(settings);
}

/// How the scene's exposure is found anew, whatever a .cam says.
rtcore::ExposureMode PictureMaker::measured() const {
    const rtcore::RenderSettings settings = ownSettings();
    const bool incident = settings.exposure.mode == rtcore::ExposureMode::Incident;
    return incident ? rtcore::ExposureMode::Incident : rtcore::ExposureMode::Automatic;
}

/// False colours of a list have the scale of its first frame, also where another machine renders that.
void PictureMaker::shareScale(const FrameTask& task, Shot& shot) {
    rtcore::FalseColourSettings& own = shot.settings.falseColours;
    if (own.from > 0 && own.to > own.from) return;
    if (!valueScale_) {
        const std::filesystem::path& last = firstOfList_.empty() ? task.camera : firstOfList_;
        const Shot first = prepare(list_.empty() ? last : list_.front());
        rtcore::RenderControl control{.threads = options_.threads};
        const app::ProgressScope scope(
            progress_, {"measuring the light", [&control] { return control.fraction(); }, &control.cancel});
        const auto tracer = rtcore::shownTracer(surfaces_, loaded_.scene, sections_);
        valueScale_ =
            valueScaleOf({loaded_.scene, *tracer, first.camera, first.settings}, unit_, control, images_);
        prepare(task.camera); // its lights, in place of those of the first
    }
    own.from = valueScale_->from;
    own.to = valueScale_->to;
}

/// The scale of the list's first frame, also where another machine renders that frame.
float PictureMaker::recordedScale(const std::filesystem::path& cameraFile) {
    if (scale_) return *scale_;
    const std::filesystem::path& last = firstOfList_.empty() ? cameraFile : firstOfList_;
    const std::filesystem::path& first = list_.empty() ? last : list_.front();
    const Shot shot = prepare(first);
    rtcore::RenderControl control{.threads = options_.threads};
    const app::ProgressScope scope(
        progress_, {"measuring the light", [&control] { return control.fraction(); }, &control.cancel});
    const auto tracer = rtcore::shownTracer(surfaces_, loaded_.scene, sections_);
    scale_ = exposureScale({loaded_.scene, *tracer, shot.camera, shot.settings}, control, images_);
    if (options_.verbose)
        progress_.print(fmt::format(
            "recorded exposures are scaled by {:.4g}: the mean of {} by paths over that by Whitted's rays",
            *scale_, first.string()));
    prepare(cameraFile); // its lights, in place of those of the first
    return *scale_;
}

bool PictureMaker::findsExposures() const {
    const rtcore::ExposureSettings exposure = ownSettings().exposure;
    return exposure.mode != rtcore::ExposureMode::Fixed && !saysExposure(options_.settings) &&
           exposure.recorded != rtcore::RecordedExposure::Automatic;
}

std::vector<float> PictureMaker::findExposures(const std::vector<std::filesystem::path>& cameras) {
    const bool scaled = ownSettings().exposure.recorded == rtcore::RecordedExposure::Scaled &&
                        ownSettings().integrator != rtcore::Integrator::Whitted;
    std::vector<float> found;
    float scale = 1;
    for (const std::filesystem::path& camera : cameras) {
        app::throwIfStopped();
        rtcore::RenderControl control{.threads = options_.threads};
        const app::ProgressScope scope(
            progress_, {"measuring the exposure", [&control] { return control.fraction(); }, &control.cancel},
            static_cast<int>(found.size()) + 1, static_cast<int>(cameras.size()));
        const Shot shot = prepare(camera);
        if (scaled && found.empty()) {
            const auto tracer = rtcore::shownTracer(surfaces_, loaded_.scene, sections_);
            scale = exposureScale({loaded_.scene, *tracer, shot.camera, shot.settings}, control, images_);
        }
        found.push_back(findExposure(shot, control) / scale);
    }
    return found;
}

float PictureMaker::findExposure(const Shot& shot, rtcore::RenderControl& control) {
    const auto tracer = rtcore::shownTracer(surfaces_, loaded_.scene, sections_);
    const rtcore::View view{loaded_.scene, *tracer, shot.camera, shot.settings};
    std::optional<float> white;
    if (shot.settings.exposure.mode == rtcore::ExposureMode::Incident) white = meter_.white(view, control);
    if (!white) renderSmall(view, control, images_, frame_);
    return developer_.exposure(frame_, shot.settings, white, options_.threads);
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
        rtcore::FocusFinder().distance(*rtcore::shownTracer(surfaces_, loaded_.scene, sections_), view, x, y);
    if (!options_.verbose) return;
    const bool infinite = settings.depthOfField.focus >= rtcore::kInfiniteFocus;
    progress_.print("focused at " +
                    (infinite ? "infinity" : rtcore::settingText(settings.depthOfField.focus)));
}

void PictureMaker::chooseNet(rtcore::RenderSettings& settings) {
    const std::optional<rtcore::Net> wanted = rtcore::netOf(settings);
    if (settings.denoise.net == rtcore::DenoiseNet::Automatic && wanted) {
        chooseNetByItself(settings);
        return;
    }
    if (wanted) checkDigest(*wanted);
    useNet(wanted ? nets_.of(*wanted) : nullptr);
}

/// Images that another program began go on with the same weights, or not at all.
void PictureMaker::checkDigest(rtcore::Net net) const {
    const rtcore::NetFile& file = rtcore::fileOf(net);
    if (std::string_view(file.sha256).starts_with(options_.netDigest)) return;
    const std::string setting = "denoise.net";
    throw rtcore::FileError(
        rtcore::FailureKind::BadData, setting,
        rtcore::say("the weights of {0} have the SHA-256 {1} here, not {2}; use the version "
                    "of this suite that knows those",
                    std::string(file.name), std::string(file.sha256), options_.netDigest));
}

void PictureMaker::chooseNetByItself(rtcore::RenderSettings& settings) {
    if (options_.hasFrames()) {
        throw app::UsageError(
            "denoise.net=automatic chooses by what this machine has; the images of a list or a "
            "flight need one net: small, base or large");
    }
    try {
        useNet(nets_.of(rtcore::Net::Base));
        settings.denoise.net = rtcore::DenoiseNet::Base;
    } catch (const rtcore::FileError& error) {
        useNet(nullptr);
        settings.denoise.net = rtcore::DenoiseNet::Off;
        if (rtcore::filterPasses(settings) == 0) settings.path.filter = kPassesInPlace;
        if (!std::exchange(toldOfNet_, true)) progress_.tell(app::sentenceOf(error));
    }
}

void PictureMaker::useNet(const std::shared_ptr<const rtcore::UNet>& net) {
    if (preview_ != nullptr) preview_->useNet(net);
    developer_.useNet(net);
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
    rtcore::ImageRenderer& images = images_.of(settings.integrator);
    const auto fraction = [&images, &control] { return images.fraction(control); };
    const app::ProgressScope scope(progress_, {"rendering", fraction, &control.cancel}, index, count);
    const rtcore::ImageRequest request{.aovs = options_.aovs || rtcore::effectsNeedAovs(settings),
                                       .guides = options_.aovs || rtcore::effectsNeedGuides(settings),
                                       .background = options_.hidesBackground() ? rtcore::Background::Hidden
                                                     : rtcore::rendersApart(settings)
                                                         ? rtcore::Background::Apart
                                                         : rtcore::Background::Shown};
    white_.reset();
    if (settings.exposure.mode == rtcore::ExposureMode::Incident) {
        const auto all = rtcore::shownTracer(surfaces_, loaded_.scene, sections_);
        white_ = meter_.white({loaded_.scene, *all, camera, settings}, control);
    }
    const auto role = options_.hidesBackground() ? rtcore::GroundRole::Mirrored : rtcore::GroundRole::Seen;
    const auto tracer = rtcore::shownTracer(surfaces_, loaded_.scene, sections_, role);
    const rtcore::View view{loaded_.scene, *tracer, camera, settings};
    if (preview_ != nullptr) preview_->meter(white_);
    const bool whole = preview_ == nullptr
                           ? images.render(view, control, request, frame_)
                           : preview_->render({images, view, control, frame_, unit_}, request);
    if (!whole) {
        throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    }
    tell(images.remarks());
    app::throwIfStopped();
}

void PictureMaker::addGroundShadow(const rtcore::Camera& camera, const rtcore::RenderSettings& settings,
                                   int index, int count) {
    rtcore::RenderControl control{.threads = options_.threads};
    const auto fraction = [&control] { return control.fraction(); };
    const app::ProgressScope scope(progress_, {"rendering the shadow", fraction, &control.cancel}, index,
                                   count);
    const auto surfaces = rtcore::withSections(surfaces_, loaded_.scene, sections_);
    const rtcore::HdrImage left = groundShadow(
        {loaded_.scene, surfaces, shadowGround_, camera, settings, images_, developer_, control});
    if (left.empty()) throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    for (std::size_t i = 0; i < left.pixels.size(); ++i) {
        rtcore::Colour& seen = frame_.transmitted.pixels[i];
        seen = seen * left.pixels[i];
    }
    app::throwIfStopped();
}

const rtcore::HdrImage& PictureMaker::finish(const rtcore::RenderSettings& settings, int index, int count) {
    if (!rtcore::denoisesByNet(settings)) return developer_.finish(frame_, settings, options_.threads);
    std::atomic<bool> cancel = false;
    std::atomic<float> done = 0;
    const app::ProgressScope scope(
        progress_, {"denoising", [&done] { return static_cast<double>(done.load()); }, &cancel}, index,
        count);
    const rtcore::HdrImage& radiance = developer_.finish(frame_, settings, options_.threads, &cancel, &done);
    app::throwIfStopped();
    const std::string effect = rtcore::textOf(developer_.netReport(), settings.denoise.net);
    if (options_.verbose && !effect.empty()) progress_.print(effect);
    return radiance;
}

/// Details where --verbose asks, those of the scene once a run; the rest always.
void PictureMaker::tell(const std::vector<rtcore::ImageRemark>& remarks) {
    for (const rtcore::ImageRemark& remark : remarks) {
        if (remark.detail && (!options_.verbose || (remark.ofScene && toldOfScene_))) continue;
        progress_.tell(remark.text);
    }
    toldOfScene_ = true;
}

void PictureMaker::tellOfOpenParts() {
    const std::vector<std::string> open = caps_.openParts(loaded_.scene);
    if (open.empty() || std::exchange(toldOfOpenParts_, true)) return;
    progress_.tell(rtcore::say(
        "{0} parts that a section cuts are not closed, so that they have no caps and one looks into "
        "them; the first is {1}",
        open.size(), rtcore::inQuotes(open[0])));
}

float PictureMaker::develop(const FrameTask& task, const Shot& shot, const rtcore::HdrImage& radiance) {
    const rtcore::RenderSettings& settings = shot.settings;
    const bool shown = std::any_of(task.outputs.begin(), task.outputs.end(), [](const auto& output) {
        return isStandardOutput(output) || !rtcore::isHdrFormat(output);
    });
    if (!shown && !task.filmed && preview_ == nullptr) return 0;
    const float exposure = developer_.exposure(frame_, settings, white_, options_.threads);
    developer_.developFinished(radiance, frame_, settings, exposure, options_.threads, developed_);
    caps_.paint(loaded_.scene, shot.camera, developed_);
    if (backdrop_) backdrop_->paintBehind(developed_);
    if (developer_.falseColours() != nullptr)
        rtcore::paintLegend(*developer_.falseColours(), developed_.height, developed_);
    if (shot.camera.kind != rtcore::CameraKind::Panorama) tellOfOpenParts();
    return exposure;
}

void PictureMaker::write(const FrameTask& task, const rtcore::HdrImage& radiance,
                         const rtcore::RenderSettings& settings) {
    std::vector<rtcore::ImageText> texts = app::imageTexts(settings);
    const std::string net = rtcore::textOf(developer_.netReport(), settings.denoise.net);
    if (!net.empty()) texts.push_back({"denoising", net});
    if (const auto used = rtcore::netOf(settings); used && !net.empty())
        texts.push_back({"weights", std::string("SHA-256 ") + rtcore::fileOf(*used).sha256});
    const rtcore::ImageNotes notes{.texts = texts, .panorama = options_.panorama.has_value()};
    for (const std::filesystem::path& output : task.outputs) {
        app::throwIfStopped();
        if (isStandardOutput(output)) {
            app::writeOutput(asText(rtcore::encodeImage(developed_, options_.standardOutputFormat, notes)));
        } else if (options_.aovs && rtcore::isExr(output)) {
            writeAovs(output, radiance, frame_, developer_.netErrors(), texts);
        } else if (options_.alpha && rtcore::isExr(output)) {
            writeExr(output, radiance, frame_, texts);
        } else if (rtcore::isHdrFormat(output)) {
            rtcore::writeHdrImage(output, radiance, texts);
        } else {
            rtcore::writeImage(output, developed_, notes);
        }
    }
}

} // namespace renderer

#include "rtserver/frames/frame_maker.h"

#include "rtcore/look/light_units.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/post/effects.h"
#include "rtcore/post/false_colours.h"
#include "rtcore/post/legend.h"
#include "rtcore/shading/fog/fog.h"

#include <fmt/core.h>

#include <algorithm>
#include <new>
#include <string>
#include <utility>

namespace rtserver {

namespace {

/// Live frames per measurement of the light: they trace few pixels, and an eye does not follow sooner.
constexpr int kMeterEvery = 8;

/// Calls `use` with the view that a live frame of the whole size shows.
template <typename Use>
bool ofLiveView(const Document& document, Use&& use) {
    const std::shared_ptr<const rtcore::Scene> scene = document.imagedScene();
    const rtcore::RenderSettings settings = liveSettingsAt(document.frameSettings(), *scene, 1);
    return use(rtcore::View{*scene, *document.tracer(), document.camera(), settings});
}

bool canBeLive(const Document& document) { return ofLiveView(document, rtcore::LiveRenderer::supports); }

/// Everywhere.
bool changesLight(const rtcore::Changes& changes) {
    using rtcore::Change;
    return changes.hasAny(
        {Change::Scene, Change::Sky, Change::Material, Change::Visibility, Change::Section});
}

} // namespace

bool FrameMaker::trace(const Workspace& state, const FrameDetail& detail, const rtcore::ShadowMaps* maps,
                       rtcore::RenderControl& control) {
    const Document& document = state.document;
    const Clock::time_point start = Clock::now();
    const std::uint64_t revision = document.revisions().revision();
    rtcore::Frame& frame = detail.whole() ? whole_ : coarse_;
    if (unkept_.frame == &frame) seedLive(document);        // its memory is written to
    if (detail.whole() == detail_.whole()) seen_ = nullptr; // its memory is written to
    control.threads = threads_;
    control.finished = nullptr;
    liveCost_ = {};
    const bool sameView = hasRadiance() && !stale(document);
    if (sameView && detail.whole() && !detail_.whole()) {
        begun_ = {adaptation_, adaptedAt_}; // before underWay() may ask for it
        gradual_.showBy(developer_.falseColours());
        gradual_.begin(coarse_, document.frameSettings(), adaptation_.value(), threads_, start);
        control.finished = &gradual_.finished();
    }
    const bool done = detail.live() ? drawLive(document, detail, control, frame)
                                    : draw(state, detail, maps, control, frame);
    gradual_.end();
    if (!done) {
        begun_.reset();
        return false;
    }
    // Bloom has its width in pixels of the whole frame.
    rtcore::RenderSettings effects = document.frameSettings();
    if (detail.live()) effects.denoise.passes = 0;
    if (!detail.live() || !white_ || ++unmetered_ >= kMeterEvery) meter(document, effects, detail, control);
    if (control.cancel) return false; // what was measured then says nothing
    target_ = developer_.exposure(frame, effects, white_, threads_);
    seen_ = nullptr; // the frame before may be shown from the effects' memory
    const rtcore::HdrImage& finished = developer_.finish(frame, effects, threads_, &control.cancel);
    if (control.cancel) return false;
    seen_ = &finished;
    revision_ = revision;
    detail_ = detail;
    keptPart_ = detail.live() ? 1 - live_->newSamples() : 0;
    indirectError_ = errorOfIndirect(document, detail);
    rays_ = frame.statistics.total();
    seconds_ = std::chrono::duration<double>(Clock::now() - start).count();
    return true;
}

double FrameMaker::errorOfIndirect(const Document& document, const FrameDetail& detail) const {
    if (document.settings().indirect.mode != rtcore::IndirectMode::Live) return 0;
    const rtcore::IndirectLight* const light =
        detail.exact() && viewLight_ ? &viewLight_->light() : walkLight_->known();
    return light != nullptr ? light->learned().error : 0;
}

/// The light on what is seen: coarse and whole frames of a view have the same exposure. That of live frames
/// is measured roughly, or such a frame would be late; it is followed smoothly.
void FrameMaker::meter(const Document& document, const rtcore::RenderSettings& settings,
                       const FrameDetail& detail, rtcore::RenderControl& control) {
    const bool live = detail.live();
    const bool byWalk = !detail.whole() && settings.indirect.mode == rtcore::IndirectMode::Live;
    white_.reset();
    unmetered_ = 0;
    if (settings.exposure.mode != rtcore::ExposureMode::Incident) return;
    const std::shared_ptr<const rtcore::Scene> scene = document.imagedScene();
    const rtcore::View view{*scene, *document.tracer(), document.camera(), settings};
    meter_.lightIndirectlyFrom(byWalk ? &walkLight_->light() : nullptr);
    white_ = live ? meter_.roughWhite(view, control) : meter_.white(view, control);
}

bool FrameMaker::draw(const Workspace& state, const FrameDetail& detail, const rtcore::ShadowMaps* maps,
                      rtcore::RenderControl& control, rtcore::Frame& frame) {
    const Document& document = state.document;
    const std::shared_ptr<const rtcore::Scene> scene = document.imagedScene();
    const rtcore::RenderSettings settings = settingsAt(document.frameSettings(), detail);
    const bool keeps = state.frameSeconds > 0 && canBeLive(document);
    renderer_->takeShadowsFrom(detail.cut && maps != nullptr && maps->suit(settings) ? maps : nullptr);
    renderer_->collectAovs(rtcore::effectsNeedAovs(settings));
    renderer_->collectSeen(keeps);
    const rtcore::View view{*scene, *document.tracer(), document.camera(), settings};
    if (!lightIndirectly(document, detail, view, control)) return false;
    if (!renderer_->render(view, control, frame)) {
        if (keeps && control.finished != nullptr) keepFinished(view, control.finished->all(), frame);
        return false;
    }
    if (!keeps) return true;
    noticeChanges(document);
    constexpr std::uint8_t kRough = 100;
    unkept_ = {&frame, rtcore::LiveRenderer::planeOf(view), detail.cut ? kRough : std::uint8_t{0}};
    return true;
}

/// Exact frames show what their view alone decides, as Renderer does, others what the walk has learned. What
/// rests is shown at once, while more is learned.
bool FrameMaker::lightIndirectly(const Document& document, const FrameDetail& detail,
                                 const rtcore::View& view, rtcore::RenderControl& control) {
    const rtcore::IndirectLight* light = nullptr;
    if (view.settings.indirect.mode == rtcore::IndirectMode::Live) {
        if (control.finished != nullptr && !showAtOnce(document, control, whole_)) return false;
        if (detail.exact()) {
            if (!viewLight_) viewLight_.emplace();
            if (!viewLight_->learn(view, control)) return false;
            light = &viewLight_->light();
        } else {
            walkLight_->follow(document, threads_);
            const bool rests = detail.complete();
            const double times = detail.cut ? detail.learning : WalkLight::kAtLeisure;
            const bool learned =
                rests ? walkLight_->learnRest(view, control) : walkLight_->learn(view, times, control);
            if (!learned) return false;
            countRays();
            light = &walkLight_->light();
        }
    }
    renderer_->lightIndirectlyFrom(light);
    return true;
}

/// The whole size, lit by what the walk has learned.
bool FrameMaker::showAtOnce(const Document& document, rtcore::RenderControl& control, rtcore::Frame& frame) {
    const std::shared_ptr<const rtcore::Scene> scene = document.imagedScene();
    const rtcore::RenderSettings settings = liveSettingsAt(document.frameSettings(), *scene, 1);
    const rtcore::View view{*scene, *document.tracer(), document.camera(), settings};
    walkLight_->follow(document, threads_);
    if (!walkLight_->learn(view, WalkLight::kAtLeisure, control)) return false;
    renderer_->lightIndirectlyFrom(&walkLight_->light());
    if (!renderer_->render(view, control, frame)) return false;
    gradual_.beginAgain(frame, document.frameSettings(), threads_);
    return true;
}

void FrameMaker::seedLive(const Document& document) {
    if (unkept_.frame == nullptr) return;
    noticeChanges(document);
    seedLive();
}

void FrameMaker::seedLive() {
    const Unkept unkept = std::exchange(unkept_, {});
    if (unkept.frame == nullptr) return;
    try {
        live_->seed(unkept.plane, *unkept.frame, threads_, unkept.age);
    } catch (const std::bad_alloc&) {
        live_.emplace(); // there are coarse frames without it
    }
}

/// A camera that moves again goes on from what has been rendered of the view that it leaves.
void FrameMaker::keepFinished(const rtcore::View& view, const std::vector<rtcore::PixelArea>& tiles,
                              const rtcore::Frame& frame) {
    constexpr double kWorthIt = 0.1; // of the pixels
    seedLive();
    if (rtcore::pixelsOf(tiles) >= kWorthIt * static_cast<double>(frame.radiance.pixels.size()) &&
        !live_->empty())
        live_->seedParts(view, frame, tiles, threads_);
}

bool FrameMaker::drawLive(const Document& document, const FrameDetail& detail, rtcore::RenderControl& control,
                          rtcore::Frame& frame) {
    const std::shared_ptr<const rtcore::Scene> scene = document.imagedScene();
    noticeChanges(document);
    seedLive();
    const rtcore::RenderSettings settings = liveSettingsAt(document.frameSettings(), *scene, detail.scale);
    const rtcore::View view{*scene, *document.tracer(), document.camera(), settings};
    const bool indirect = settings.indirect.mode == rtcore::IndirectMode::Live;
    if (indirect) walkLight_->follow(document, threads_);
    renderer_->lightIndirectlyFrom(nullptr);
    viewLight_.reset(); // its memory; a whole frame begins anew
    live_->lightIndirectly(indirect ? &walkLight_->light() : nullptr, WalkLight::budgetOf(detail.learning),
                           walkLight_->turns(detail.scale));
    if (!live_->render(view, detail.newSamples, control, frame)) return false;
    liveCost_ = {.samples = live_->newSamples() * static_cast<double>(frame.radiance.pixels.size()),
                 .sampleSeconds = live_->sampleSeconds()};
    if (indirect) countRays();
    return true;
}

void FrameMaker::countRays() {
    const rtcore::IndirectLight::Learned& learned = walkLight_->light().learned();
    liveCost_.rays = static_cast<double>(learned.rays);
    liveCost_.raySeconds = learned.seconds;
    liveCost_.unknown = learned.unknown;
}

bool FrameMaker::drawsLive(const Document& document) {
    noticeChanges(document);
    seedLive();
    return !live_->empty() && canBeLive(document) &&
           ofLiveView(document, [&](const rtcore::View& view) { return live_->canReuse(view); });
}

/// Light holds as long as nothing but the camera changes, and what is done to the image; and where lights
/// that changed do not reach.
void FrameMaker::noticeChanges(const Document& document) {
    constexpr double kFew = 0.1; // of the pixels: a live frame shows more than a coarse one
    const rtcore::Changes changes = kept_.take(document.revisions());
    const std::shared_ptr<const rtcore::Scene> scene = document.imagedScene();
    const rtcore::RenderSettings settings = document.frameSettings();
    const bool seesWhite = settings.falseColours.seesWhite();
    if (changesLight(changes) || !rtcore::sameLight(settings, keptFor_) ||
        seesWhite != keptFor_.falseColours.seesWhite()) {
        live_->forget();
        unkept_ = {};
    } else if (changes.has(rtcore::Change::Light)) {
        seedLive();
        const bool inAir = rtcore::fogMedium(*scene, settings).on;
        const rtcore::LightChange change(keptLights_, rtcore::lightsOf(scene->lights));
        if (change.any() && (inAir || live_->invalidate(change, threads_) > kFew)) live_->forget();
    }
    if (changes.any()) keptLights_ = rtcore::lightsOf(scene->lights);
    keptFor_ = settings;
}

std::size_t FrameMaker::bytesOf(const rtcore::RenderSettings& settings, bool live, int threads) {
    constexpr std::size_t kFrame = sizeof(rtcore::Colour) + sizeof(std::uint8_t); // and what is covered
    const std::size_t effects = rtcore::effectBytesPerPixel(settings);
    constexpr std::size_t kImages = 3 * sizeof(rtcore::Rgba8); // with step_, and what CapPainter keeps
    std::size_t pixel = kFrame + kImages + effects;
    if (settings.falseColours.seesWhite()) pixel += sizeof(rtcore::Colour); // PictureDeveloper::finish()
    if (live) {
        pixel += kFrame + rtcore::Transition::kBytesPerPixel + effects;
        pixel += sizeof(rtcore::SeenPoint) + rtcore::LiveRenderer::kBytesPerPixel;
        if (settings.indirect.mode == rtcore::IndirectMode::Live)
            pixel += sizeof(rtcore::SeenMatter) + rtcore::LiveRenderer::kMatterBytesPerPixel;
    }
    const std::size_t rows = settings.falseColours.on ? rtcore::falseColourBytes(settings.width, threads) : 0;
    return rows +
           pixel * static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
}

void FrameMaker::requireMemory(const rtcore::RenderSettings& settings, bool live, int threads) {
    constexpr std::size_t kForClients = std::size_t{4} << 20U; // their channels are mapped as they come
    void* trial = ::operator new(bytesOf(settings, live, threads) + kForClients, std::nothrow);
    ::operator delete(trial);
    if (trial != nullptr) return;
    throw rtcore::FileError(
        rtcore::FailureKind::TryAgain, "",
        rtcore::say("not enough memory for frames of {0} x {1}; ask for a lower resolution", settings.width,
                    settings.height));
}

void FrameMaker::drop() {
    whole_ = {};
    coarse_ = {};
    seen_ = nullptr;
    revision_ = 0;
    keptPart_ = indirectError_ = 0;
    renderer_.emplace();
    live_.emplace();
    walkLight_.emplace();
    viewLight_.reset();
    unkept_ = {};
    developer_ = {};
    gradual_.drop();
    image_ = {};
}

const rtcore::LdrImage* FrameMaker::underWay(const Document& document) {
    const auto exposure = [&](float brightening) {
        adapt(white_ ? target_ : target_ * brightening, document.frameSettings().exposure);
        return adaptation_.value();
    };
    const rtcore::LdrImage* const image = gradual_.step(whole_.radiance, exposure, Clock::now());
    const std::shared_ptr<const rtcore::Scene> scene = document.imagedScene();
    const rtcore::FalseColours* const falseColours = developer_.falseColours();
    const bool painted = falseColours != nullptr || rtcore::CapPainter::paints(*scene);
    if (image == nullptr || !painted) return image;
    step_ = *image;
    document.caps().paint(*scene, document.camera(), step_);
    if (falseColours != nullptr) rtcore::paintLegend(*falseColours, step_.height, step_);
    return &step_;
}

/// Towards an exposure, by the time that has passed since the last call; or, where the view has been seen for
/// a while, as if it had been known from the beginning what suits it.
void FrameMaker::adapt(float target, const rtcore::ExposureSettings& settings) {
    constexpr double kLongest = 0.25; // a pause is no time in which the eye saw anything
    constexpr double kFirst = 0.033;  // but of a change something is to be seen at once
    const Clock::time_point now = Clock::now();
    const double passed = std::chrono::duration<double>(now - adaptedAt_).count();
    adaptedAt_ = now;
    if (settings.mode == rtcore::ExposureMode::Fixed) {
        adaptation_.jump(settings.value);
        return;
    }
    const AdaptationSpeed speed{settings.brighterSeconds, settings.darkerSeconds};
    if (begun_) {
        adaptation_ = begun_->eye;
        adaptation_.advance(target, std::chrono::duration<double>(now - begun_->at).count(), speed);
        return;
    }
    const double before = detail_.whole() ? 0 : kFirst;
    adaptation_.advance(target, adaptation_.settled() ? before : std::min(passed, kLongest), speed);
}

void FrameMaker::develop(const Document& document) {
    // For another scene the exposure is found at once.
    if (adapted_.take(document.revisions()).has(rtcore::Change::Scene)) adaptation_ = {};
    const rtcore::RenderSettings settings = document.frameSettings();
    adapt(target_, settings.exposure);
    begun_.reset();
    if (settings.falseColours.on) developer_.useUnit(rtcore::unitOfImages(*document.scene(), settings));
    developer_.holdScale(!detail_.whole());
    developer_.develop(*seen_, settings, adaptation_.value(), threads_, image_);
    document.caps().paint(*document.imagedScene(), document.camera(), image_);
    if (developer_.falseColours() != nullptr)
        rtcore::paintLegend(*developer_.falseColours(), settings.height, image_);
}

} // namespace rtserver

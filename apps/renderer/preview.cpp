#include "renderer/preview.h"

#include "common/frames/error_byte.h"
#include "common/frames/frame_status.h"
#include "common/process/seconds_since.h"
#include "common/process/stop.h"

#include "rtcore/post/legend.h"
#include "rtcore/settings/integrator_traits.h"
#include "rtcore/upsample/upsample.h"

#include <algorithm>
#include <span>

namespace renderer {

namespace {

using namespace std::chrono_literals;

constexpr auto kTurn = 5ms, kIdleTurn = 50ms;
constexpr auto kPatience = 2s; // for a predecessor that is just dying

// The size of frames is not known yet: their memory comes with the first of them.
std::unique_ptr<ipc::Server> takeInstance(const std::string& instance) {
    const auto start = std::chrono::steady_clock::now();
    while (true) {
        try {
            return std::make_unique<ipc::Server>(
                ipc::ServerOptions{.instance = instance, .width = 1, .height = 1, .patience = 0s});
        } catch (const ipc::Error& error) {
            const bool over = std::chrono::steady_clock::now() - start >= kPatience;
            if (error.problem != ipc::Problem::AlreadyRunning || over) throw;
        }
        app::throwIfStopped();
        std::this_thread::sleep_for(kTurn);
    }
}

} // namespace

Preview::Preview(const PreviewOptions& options)
    : options_(options), server_(takeInstance(options.instance)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

Preview::~Preview() {
    thread_.request_stop();
    thread_.join();
}

void Preview::setRun(std::uint64_t run) {
    const std::lock_guard lock(mutex_);
    options_.run = run;
}

bool Preview::render(const Work& work, rtcore::ImageRequest request) {
    hides_ = request.background == rtcore::Background::Hidden;
    begin(work);
    try {
        request.show = [this](const rtcore::ImagePass& pass) { showPass(pass); };
        const bool whole = work.images.render(work.view, work.control, request, work.frame);
        end();
        return whole;
    } catch (...) {
        end();
        throw;
    }
}

void Preview::begin(const Work& work) {
    const std::lock_guard lock(mutex_);
    throwIfFailed();
    const rtcore::RenderSettings& settings = work.view.settings;
    begun_ = Clock::now();
    picture_ = rtcore::LdrImage(settings.width, settings.height);
    effects_ = {};
    developer_.useUnit(work.unit);
    developer_.holdScale(true);
    info_ = {};
    info_.samples = 0;
    info_.width = static_cast<std::uint32_t>(settings.width);
    info_.height = static_cast<std::uint32_t>(settings.height);
    allSamples_ = static_cast<std::uint32_t>(rtcore::samplesPerPixel(settings));
    status_ = {};
    status_.polygons = work.view.scene.model.mesh.triangles.size();
    app::setView(work.view.camera, work.view.scene.origin, settings.width, settings.height, status_);
    work_ = &work;
    wake_.notify_all();
}

void Preview::end() {
    const std::lock_guard lock(mutex_);
    work_ = nullptr;
    throwIfFailed();
}

void Preview::finish(const rtcore::LdrImage& picture, float exposure, const PictureErrors& errors) {
    const std::lock_guard lock(mutex_);
    throwIfFailed();
    info_.samples = allSamples_;
    status_.frameSeconds = app::secondsSince(begun_);
    status_.exposure = exposure;
    picture_ = picture;
    if (hides_) backdrop_.paintBehind(picture_);
    mark(errors);
    publish(ipc::kPreviewDone, picture_);
    status_.progress = 1;
    status_.idle = 1;
    server_->setStatus(status_);
}

void Preview::linger() {
    std::unique_lock lock(mutex_);
    const auto end = Clock::now() + std::chrono::duration<double>(options_.linger);
    while (Clock::now() < end && !app::stopRequested()) {
        throwIfFailed();
        wake_.wait_for(lock, kTurn);
    }
}

void Preview::showPass(const rtcore::ImagePass& pass) {
    const Work& work = *work_; // only this thread changes it
    const rtcore::RenderSettings& settings = work.view.settings;
    const int block = pass.block;
    const rtcore::Frame* const shown =
        filter_.apply(pass, settings, work.control.threads, work.control.cancel);
    if (shown == nullptr || work.control.cancel) return;
    const rtcore::Frame& frame = *shown;
    const std::lock_guard lock(mutex_);
    throwIfFailed();
    // A small image is developed sooner than several threads have met: on a busy machine they wait long.
    const int threads = block > 1 ? 1 : work.control.threads;
    status_.exposure = developer_.exposure(frame, settings, white_, threads);
    effects_.beginRows(rtcore::EffectStage::Radiance, frame.radiance, block,
                       {.settings = settings, .threads = threads, .exposure = status_.exposure});
    if (block > 1) {
        developer_.develop(frame, settings, status_.exposure, threads, small_);
        if (hides_) backdrop_.paintBehind(small_);
        const auto side = static_cast<float>(block);
        rtcore::upsample(small_, {side, side}, threads, picture_);
        // What has no sample of its own yet shows what was there before, unless it is better than that.
        const std::uint8_t opaque = pass.guides != nullptr ? 255 : 0;
        for (rtcore::Rgba8& pixel : picture_.pixels) pixel.a = opaque;
    } else {
        developer_.develop(frame, settings, status_.exposure, threads, picture_);
        if (hides_) backdrop_.paintBehind(picture_);
        info_.samples = pass.samples;
        mark({filter_.report(), filter_.errors()});
    }
    publish(tagUnderWay(), withCaps());
    pace_.shown(Clock::now(), Clock::now());
}

// Finished tiles take the place of what was there, with the exposure and the effects of the pass before, so
// that no seam shows.
void Preview::showTiles() {
    const Clock::time_point start = Clock::now();
    if (!pace_.due(start)) return;
    const std::vector<rtcore::PixelArea> tiles = work_->images.takeFinishedTiles();
    if (tiles.empty() || hides_) return;
    rtcore::Development how = rtcore::developmentOf(work_->view.settings, status_.exposure);
    how.falseColours = developer_.falseColours();
    for (const rtcore::PixelArea& tile : tiles) {
        rtcore::developPart(work_->frame.radiance, how, effects_, tile, picture_);
    }
    publish(tagUnderWay(), withCaps());
    pace_.shown(start, Clock::now());
}

// All may be rendered, but is not yet developed and written: only the last frame says that all is done.
std::uint64_t Preview::tagUnderWay() const {
    const double parts = work_->images.fraction(work_->control) * static_cast<double>(ipc::kPreviewDone);
    return std::min(static_cast<std::uint64_t>(parts), ipc::kPreviewDone - 1);
}

/// Writes what is known of its errors into picture_.
void Preview::mark(const PictureErrors& errors) {
    const bool known = errors.report.estimated && errors.pixels.size() == picture_.pixels.size();
    info_.format = known ? ipc::PixelFormat::Rgb8Error8 : ipc::PixelFormat::Rgba8;
    info_.error = known ? app::thousandths(errors.report.error) : 0;
    info_.largestError = known ? app::thousandths(errors.report.largestError) : 0;
    if (!known) return;
    for (std::size_t i = 0; i < errors.pixels.size(); ++i)
        picture_.pixels[i].a = app::errorByte(errors.pixels[i]);
}

/// What is shown before the last image, which has them already; with the legend of false colours.
const rtcore::LdrImage& Preview::withCaps() {
    const rtcore::View& view = work_->view;
    const rtcore::FalseColours* const falseColours = developer_.falseColours();
    if (falseColours == nullptr && !rtcore::CapPainter::paints(view.scene)) return picture_;
    capped_ = picture_;
    caps_.paint(view.scene, view.camera, capped_);
    if (falseColours != nullptr) rtcore::paintLegend(*falseColours, capped_.height, capped_);
    return capped_;
}

void Preview::publish(std::uint64_t tag, const rtcore::LdrImage& image) {
    info_.run = options_.run;
    info_.tag = tag;
    server_->publishFrame(info_, std::as_bytes(std::span(image.pixels)));
}

void Preview::run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    try {
        while (!stop.stop_requested()) {
            serve();
            const bool idle = work_ == nullptr;
            wake_.wait_for(lock, stop, idle ? kIdleTurn : kTurn, [&] { return idle && work_ != nullptr; });
        }
    } catch (...) {
        failure_ = std::current_exception();
        if (work_ != nullptr) work_->control.cancel = true;
    }
}

void Preview::serve() {
    for (const ipc::Command& command : server_->takeCommands()) {
        server_->refuse(command, static_cast<int>(app::ExitCode::Failed),
                        "this is a preview of an image that is being rendered; it takes no commands");
    }
    if (work_ == nullptr) return;
    server_->reserveFrame(status_.width, status_.height); // now, while the first pass is rendered
    showTiles();
    status_.progress = static_cast<float>(std::min(work_->images.fraction(work_->control), 0.999999));
    status_.frameSeconds = app::secondsSince(begun_);
    server_->setStatus(status_);
}

void Preview::throwIfFailed() const {
    if (failure_) std::rethrow_exception(failure_);
}

} // namespace renderer

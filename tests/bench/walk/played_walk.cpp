#include "bench/walk/played_walk.h"

#include "bench/walk/resample.h"

#include "rtcore/io/light/light_file.h"
#include "rtcore/io/recording/path_recorder.h"
#include "rtserver/walk/playback.h"
#include "support/temporary_folder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <thread>
#include <utility>

namespace bench {

namespace {

using namespace std::chrono_literals;

rtserver::Options serverOptions(const WalkOptions& walk) {
    rtserver::Options options;
    options.scene = walk.scene;
    options.settings = walk.settings;
    options.settings.push_back({"width", walk.width});
    options.settings.push_back({"height", walk.height});
    options.lighting.preset = walk.preset;
    options.threads = walk.threads;
    options.frameSeconds = walk.fixed ? 0 : 1 / walk.framesPerSecond;
    return options;
}

/// FNV-1a of 32 bits at a time.
std::uint64_t hash(std::uint64_t hash, const std::vector<rtcore::Colour>& pixels) {
    constexpr std::uint64_t kPrime = 0x100000001B3;
    for (const rtcore::Colour& pixel : pixels) {
        for (const float channel : {pixel.r, pixel.g, pixel.b})
            hash = (hash ^ std::bit_cast<std::uint32_t>(channel)) * kPrime;
    }
    return hash;
}

/// In the pixels of the references by paths. A frame smaller than the window is shown upsampled there.
rtcore::HdrImage inTruthPixels(const rtcore::HdrImage& radiance, const WalkOptions& options) {
    const bool small = radiance.width != options.width || radiance.height != options.height;
    return averagedDown(small ? interpolated(radiance, options.width, options.height) : radiance,
                        options.truthWidth, options.truthHeight);
}

double seconds(std::chrono::steady_clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

} // namespace

LiveServer::LiveServer(const WalkOptions& options)
    : walk_(options), options_(serverOptions(options)),
      state_(
          options_, [](const rtcore::RenderSettings&) {}, messages_),
      upkeep_(options_, state_.document, messages_),
      drawing_(state_, upkeep_,
               {.poll = [] { return rtserver::Arrivals{}; },
                .publish =
                    [this](const ipc::FrameInfo&, const rtcore::LdrImage& image) {
                        published_.push_back({.seconds = seconds(Clock::now() - begun_), .image = image});
                    }},
               options.threads, 0) {
    upkeep_.load(options_.scene, std::nullopt);
    settle();
}

LiveServer::~LiveServer() = default;

/// As ServerLoop::turn() does it, without clients.
void LiveServer::turn(Clock::duration passed) {
    const auto loaded = upkeep_.takeLoaded();
    if (loaded && loaded->failure) throw std::runtime_error("cannot load " + walk_.scene.string());
    upkeep_.advance(drawing_.pace());
    if (state_.document.ready()) state_.walk.move(passed, {}, {});
    if (drawing_.wantsFrame(false) && Clock::now() >= drawing_.due()) {
        const rtcore::Camera camera = state_.document.camera();
        const std::size_t before = published_.size();
        drawing_.draw(false);
        if (published_.size() == before) return;
        Published& last = published_.back();
        last.drawn = drawing_.frames().seconds();
        last.exposure = drawing_.frames().exposure();
        last.detail = drawing_.frames().detail();
        last.camera = camera;
    } else {
        if (drawing_.idle()) drawing_.prepareToMove();
        std::this_thread::sleep_for(1ms);
    }
}

/// Until the picture is whole, and neither a tree nor shadow maps are on their way.
void LiveServer::settle() {
    constexpr int kQuietTurns = 100;
    for (int quiet = 0; quiet < kQuietTurns; ++quiet) {
        turn(1ms);
        if (!drawing_.idle() || upkeep_.works()) quiet = 0;
    }
}

/// The end of the first compared moment that does not end before.
double LiveServer::nextCompared(double seconds) const {
    const double rate = walk_.framesPerSecond, every = walk_.every;
    const double moment = std::max(std::ceil((seconds * rate - 1) / every), 0.0);
    return (moment * every + 1) / rate;
}

/// The radiance of the last picture, if that may still be on the screen when a compared moment ends: copying
/// it takes a part of the walk's time. One that was left before such an end gives it its memory.
void LiveServer::keepLight() {
    constexpr double kLongestFrame = 0.5;
    if (walk_.truth != Truth::Paths || !drawing_.frames().hasRadiance()) return;
    rtcore::HdrImage light;
    if (published_.size() > 1) {
        Published& before = *(published_.end() - 2);
        if (nextCompared(before.seconds) >= published_.back().seconds) light = std::move(before.light);
    }
    const double seconds = published_.back().seconds;
    if (nextCompared(seconds) - seconds > kLongestFrame) return;
    light = drawing_.frames().radiance();
    published_.back().light = std::move(light);
}

std::vector<Published> LiveServer::play(const std::vector<rtcore::Camera>& cameras) {
    const test::TemporaryFolder folder;
    rtcore::PathRecorder recorder(folder.path() / "walk.lst");
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        rtcore::CameraFile file;
        file.camera = cameras[i];
        file.time = static_cast<double>(i) / walk_.framesPerSecond;
        recorder.add(file);
    }
    recorder.finish();
    state_.document.setCamera(cameras.front());
    settle();
    published_.clear();
    published_.reserve(2 * cameras.size());
    published_.push_back({.drawn = drawing_.frames().seconds(),
                          .image = drawing_.frames().image(),
                          .exposure = drawing_.frames().exposure(),
                          .camera = state_.document.camera()});
    keepLight();
    state_.walk.play(std::make_unique<rtserver::Playback>(recorder.list(), state_.document.scene()->origin));
    begun_ = Clock::now();
    const double end = static_cast<double>(cameras.size()) / walk_.framesPerSecond;
    for (Clock::time_point moved = begun_; seconds(moved - begun_) < end;) {
        const Clock::time_point now = Clock::now();
        const std::size_t before = published_.size();
        turn(now - std::exchange(moved, now));
        if (published_.size() > before) keepLight();
    }
    for (Published& picture : published_)
        if (!picture.light.empty()) picture.light = inTruthPixels(picture.light, walk_);
    // The eye goes on getting used to the light: what follows must follow at once.
    settle();
    const auto after = std::ranges::find_if(published_, [&](const Published& p) { return p.seconds >= end; });
    rest_.assign(after - 1, published_.end());
    for (Published& picture : rest_) picture.seconds -= end;
    published_.erase(after, published_.end());
    return std::exchange(published_, {});
}

std::vector<Published> LiveServer::drawEach(const std::vector<rtcore::Camera>& cameras) {
    std::vector<Published> pictures;
    for (const rtcore::Camera& camera : cameras) {
        state_.document.setCamera(camera);
        begun_ = Clock::now();
        published_.clear();
        drawing_.draw(false);
        if (published_.empty()) continue;
        Published& picture = published_.front();
        picture.drawn = drawing_.frames().seconds();
        picture.exposure = drawing_.frames().exposure();
        if (walk_.truth == Truth::Paths) picture.light = inTruthPixels(drawing_.frames().radiance(), walk_);
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

void LiveServer::beginWithKeptLight(rtserver::FrameMaker& frames) const {
    if (!walk_.light) return;
    const rtserver::Document& document = state_.document;
    const rtcore::LightKey key =
        rtcore::lightKeyOf(*document.scene(), document.tracer()->bounds(), document.frameSettings());
    const rtcore::LightFile file = rtcore::readLightFile(*walk_.light, key);
    if (file.match != rtcore::LightMatch::Same)
        throw std::runtime_error(walk_.light->string() + " is of another scene");
    frames.beginLightWith(document, file.light);
}

std::vector<Published> LiveServer::draw(const std::vector<WalkStep>& steps) {
    constexpr std::uint64_t kHashOfNothing = 0xCBF29CE484222325;
    rtserver::FrameMaker frames(walk_.threads);
    beginWithKeptLight(frames);
    std::vector<Published> pictures;
    bits_ = kHashOfNothing;
    for (const WalkStep& step : steps) {
        state_.document.setCamera(step.camera);
        rtcore::RenderControl control;
        const Clock::time_point begun = Clock::now();
        if (!frames.trace(state_, step.detail, nullptr, control))
            throw std::runtime_error("a frame was left");
        frames.develop(state_.document);
        const double taken = seconds(Clock::now() - begun);
        bits_ = hash(bits_, frames.radiance().pixels);
        pictures.push_back({.seconds = step.seconds > 0 ? step.seconds : taken,
                            .drawn = frames.seconds(),
                            .image = frames.image(),
                            .exposure = frames.exposure(),
                            .detail = step.detail,
                            .camera = step.camera});
        if (walk_.truth == Truth::Paths) pictures.back().light = inTruthPixels(frames.radiance(), walk_);
    }
    return pictures;
}

} // namespace bench

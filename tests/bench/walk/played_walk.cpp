#include "bench/walk/played_walk.h"

#include "rtcore/io/recording/path_recorder.h"
#include "rtserver/walk/playback.h"
#include "support/temporary_folder.h"

#include <algorithm>
#include <bit>
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
        drawing_.draw(false);
        if (published_.empty()) return;
        Published& last = published_.back();
        last.drawn = drawing_.frames().seconds();
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
                          .camera = state_.document.camera()});
    state_.walk.play(std::make_unique<rtserver::Playback>(recorder.list()));
    begun_ = Clock::now();
    const double end = static_cast<double>(cameras.size()) / walk_.framesPerSecond;
    for (Clock::time_point moved = begun_; seconds(moved - begun_) < end;) {
        const Clock::time_point now = Clock::now();
        turn(now - std::exchange(moved, now));
    }
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
        if (!published_.empty()) published_.front().drawn = drawing_.frames().seconds();
        if (!published_.empty()) pictures.push_back(std::move(published_.front()));
    }
    return pictures;
}

std::vector<Published> LiveServer::draw(const std::vector<WalkStep>& steps) {
    constexpr std::uint64_t kHashOfNothing = 0xCBF29CE484222325;
    rtserver::FrameMaker frames(walk_.threads);
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
                            .detail = step.detail,
                            .camera = step.camera});
    }
    return pictures;
}

} // namespace bench

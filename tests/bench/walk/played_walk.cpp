#include "bench/walk/played_walk.h"

#include "rtcore/io/recording/path_recorder.h"
#include "rtserver/playback.h"
#include "support/temporary_folder.h"

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
    options.threads = walk.threads;
    options.frameSeconds = walk.fixed ? 0 : 1 / walk.framesPerSecond;
    return options;
}

double seconds(std::chrono::steady_clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

} // namespace

LiveServer::LiveServer(const WalkOptions& options)
    : walk_(options), options_(serverOptions(options)),
      state_(
          options_, [](const rtcore::RenderSettings&) {}, messages_),
      upkeep_(options_, state_, messages_),
      drawing_(state_, upkeep_,
               {.poll = [] { return rtserver::Arrivals{}; },
                .publish =
                    [this](const ipc::FrameInfo&, const rtcore::LdrImage& image) {
                        published_.push_back({seconds(Clock::now() - begun_), 0, image});
                    }},
               options.threads, options.fixed ? 0 : options.framesPerSecond) {
    upkeep_.load(options_.scene, std::nullopt);
    settle();
}

LiveServer::~LiveServer() = default;

/// As ServerLoop::turn() does it, without clients.
void LiveServer::turn(Clock::duration passed) {
    const auto loaded = upkeep_.takeLoaded();
    if (loaded && loaded->failure) throw std::runtime_error("cannot load " + walk_.scene.string());
    upkeep_.advance(drawing_.pace());
    if (state_.ready()) state_.move(passed, {});
    if (drawing_.wantsFrame(false) && Clock::now() >= drawing_.due()) {
        drawing_.draw(false);
        if (!published_.empty()) published_.back().drawn = drawing_.frames().seconds();
    } else {
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
    state_.setCamera(cameras.front());
    settle();
    published_.clear();
    published_.reserve(2 * cameras.size());
    published_.push_back({0, drawing_.frames().seconds(), drawing_.frames().image()});
    state_.play(std::make_unique<rtserver::Playback>(recorder.list()));
    begun_ = Clock::now();
    const double end = static_cast<double>(cameras.size()) / walk_.framesPerSecond;
    for (Clock::time_point moved = begun_; seconds(moved - begun_) < end;) {
        const Clock::time_point now = Clock::now();
        turn(now - std::exchange(moved, now));
    }
    return published_;
}

std::vector<Published> LiveServer::rest() {
    Published last = std::move(published_.back());
    begun_ = Clock::now();
    last.seconds = 0;
    published_.clear();
    published_.push_back(std::move(last));
    settle();
    return std::exchange(published_, {});
}

std::vector<Published> LiveServer::drawEach(const std::vector<rtcore::Camera>& cameras) {
    std::vector<Published> pictures;
    for (const rtcore::Camera& camera : cameras) {
        state_.setCamera(camera);
        begun_ = Clock::now();
        published_.clear();
        drawing_.draw(false);
        if (!published_.empty()) published_.front().drawn = drawing_.frames().seconds();
        if (!published_.empty()) pictures.push_back(std::move(published_.front()));
    }
    return pictures;
}

} // namespace bench

/// The frames that a window shows of a recorded walk that the server plays.
#pragma once

#include "bench/walk/walk_options.h"
#include "bench/walk/walk_trace.h"

#include "rtcore/scene/camera.h"
#include "rtcore/scene/image.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtserver/frames/frame_drawing.h"
#include "rtserver/frames/scene_upkeep.h"
#include "rtserver/server_options.h"
#include "rtserver/walk/workspace.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace bench {

/// A picture that was published while the walk was played.
struct Published {
    double seconds = 0; ///< since the walk began
    double drawn = 0;   ///< seconds that it took to trace
    rtcore::LdrImage image;
    float exposure = 1; ///< the constant of its tone mapping
    /// Radiance, in the pixels of the references by paths; empty where there are none, or where it cannot be
    /// compared.
    rtcore::HdrImage light = {};
    rtserver::FrameDetail detail = {};
    rtcore::Camera camera = {};
};

/// The parts of RTServer that make frames, in this process.
class LiveServer {
  public:
    /// Loads the scene, and waits until nothing is left to be done for its first view. Throws what loading
    /// throws.
    explicit LiveServer(const WalkOptions& options);
    ~LiveServer();
    LiveServer(const LiveServer&) = delete;
    LiveServer& operator=(const LiveServer&) = delete;

    /// Plays the cameras at the options' pace, after it came to rest at the first one.
    std::vector<Published> play(const std::vector<rtcore::Camera>& cameras);
    /// Frames seen after play() until the image was complete and stayed; the first is the last of the walk.
    /// `seconds` are since the end of the walk.
    const std::vector<Published>& rest() const { return rest_; }
    /// Draws each of them in a whole frame, one after the other; `seconds` are those of the frame alone.
    std::vector<Published> drawEach(const std::vector<rtcore::Camera>& cameras);
    /// Draws those steps, the first from nothing; `seconds` are theirs, or those of the frame alone where
    /// they say 0.
    std::vector<Published> draw(const std::vector<WalkStep>& steps);
    /// Hash of the light of all images of the last draw(), for comparison: equal bits give equal numbers.
    std::uint64_t bits() const { return bits_; }

    const rtserver::Document& document() const { return state_.document; }

  private:
    using Clock = std::chrono::steady_clock;

    void turn(Clock::duration passed);
    void settle();
    void keepLight();
    void beginWithKeptLight(rtserver::FrameMaker& frames) const;
    double nextCompared(double seconds) const;

    const WalkOptions& walk_;
    rtserver::Options options_;
    rtserver::Messages messages_;
    rtserver::Workspace state_;
    rtserver::SceneUpkeep upkeep_;
    rtserver::FrameDrawing drawing_;
    Clock::time_point begun_;
    std::vector<Published> published_, rest_;
    std::uint64_t bits_ = 0;
};

} // namespace bench

/// Frames of a state, one after the other: which one is wanted, drawing it, leaving it when it should be
/// left.
#pragma once

#include "rtserver/frames/arrivals.h"
#include "rtserver/frames/frame_guard.h"
#include "rtserver/frames/frame_maker.h"
#include "rtserver/frames/frame_pacer.h"
#include "rtserver/frames/frame_schedule.h"
#include "rtserver/frames/scene_upkeep.h"
#include "rtserver/walk/workspace.h"

#include "ipc/layout/frame_info.h"

#include "rtcore/platform/sentence.h"

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <string>

namespace rtserver {

/// One thread; while a frame is traced the guard's thread asks for what arrives.
class FrameDrawing {
  public:
    using Clock = FramePacer::Clock;

    /// Calls into the server around it.
    struct Outlets {
        /// Called every few milliseconds while a frame is traced, in another thread: which may read the state
        /// then, but not change it. What it throws, draw() throws.
        std::function<Arrivals()> poll;
        /// An image is to be shown; also in that thread. Throws std::bad_alloc where there is no memory for
        /// it.
        std::function<void(const ipc::FrameInfo&, const rtcore::LdrImage&)> publish;
    };
    /// At most `framesPerSecond`, 0 = as many as there are, by `threads`. All must outlive it.
    FrameDrawing(Workspace& state, SceneUpkeep& upkeep, Outlets outlets, int threads, double framesPerSecond);

    /// How the drawing of a frame ended.
    enum class Outcome {
        Published,
        Left,       ///< for a change, or for the end; another one follows
        Obstructed, ///< it was left for commands that wait behind those that wait for it
        NoMemory    ///< the state went back to the settings of the last whole frame
    };
    struct Drawn {
        Outcome outcome = Outcome::Published;
        rtcore::Sentence why = {}; ///< of the last two, for those whose commands are refused
    };
    /// `waitedFor`: commands need the whole frame of the state. Throws std::bad_alloc when there is no memory
    /// for the first whole frame.
    Drawn draw(bool waitedFor);

    /// The state is paused or not, as of this turn: a paused one keeps its image when all of that is there.
    void noticePause(bool waitedFor);
    bool wantsFrame(bool waitedFor) const;
    /// No frame before that.
    Clock::time_point due() const {
        return pacer_.due(!frames_.stale(state_.document) && !frames_.settled());
    }
    /// The next frame would equal the last, and no other scene is being loaded.
    bool idle() const;
    /// Since the last takeChange() something came that the state does not know yet.
    bool changeWaits() const { return arrivals_.change; }
    bool takeChange();

    /// For the time in which no frame is wanted: what the next one would begin with.
    void prepareToMove() { frames_.seedLive(state_.document); }

    const FrameMaker& frames() const { return frames_; }
    const rtcore::IndirectLight* walkLight() const { return frames_.walkLight(); }
    void beginLightWith(const rtcore::IndirectState& kept) { frames_.beginLightWith(state_.document, kept); }
    /// Time for a frame of all pixels and samples: of the last one, or of the one being traced if that has
    /// taken longer already. 0: there was none of this scene. May be called by Outlets::poll.
    double wholeSeconds() const;
    double framesPerSecond() const { return pacer_.framesPerSecond(Clock::now()); }
    SceneUpkeep::Pace pace();

  private:
    FrameSchedule::Demand demand(bool waitedFor, const rtcore::ShadowMaps* maps);
    Drawn drawFrame(bool waitedFor);
    void noticeScene();
    Outcome trace(bool waitedFor);
    bool guardFrame();
    void publishStep();
    void publish();
    void publish(const rtcore::LdrImage& image, std::uint32_t samples);
    Drawn goBack();
    bool standsStill() const { return state_.paused || state_.walk.atRest(); }
    bool wantsWholeFrame(bool waitedFor) const;
    IndirectOf indirectLight(bool waitedFor) const;

    Workspace& state_;
    SceneUpkeep& upkeep_;
    Outlets outlets_;
    FrameMaker frames_;
    FrameSchedule schedule_;
    FramePacer pacer_;
    rtcore::Subscription scheduled_; ///< what the schedule knows of the state
    rtcore::RenderSettings drawn_;   ///< of the last whole frame
    bool drewWhole_ = false;         ///< there was one
    double wholeSeconds_ = 0;        ///< that it took to trace
    bool tracesWhole_ = false;       ///< one is traced now
    bool wentBack_ = false;          ///< to those settings, for lack of memory, and none is there yet
    bool keepsImage_ = false;        ///< paused, with all of the last image there

    // State of the frame that is being traced: the guard's thread has it then.
    Clock::time_point begun_, stepDue_;
    Arrivals arrivals_;
    std::exception_ptr guardError_;
    FrameGuard guard_;
};

} // namespace rtserver

/// Serve, update, render or idle, until told to exit. (thesis figure 7.2)
#pragma once

#include "rtserver/commands.h"
#include "rtserver/frame_guard.h"
#include "rtserver/frame_maker.h"
#include "rtserver/messages.h"
#include "rtserver/resolution_governor.h"
#include "rtserver/scene_load.h"
#include "rtserver/server_options.h"
#include "rtserver/session.h"
#include "rtserver/tree_refinement.h"

#include "common/exit_codes.h"
#include "common/process_watch.h"

#include "ipc/endpoint/server.h"

#include <chrono>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rtserver {

/// One thread, beside which a scene is loaded and long frames are guarded.
class ServerLoop : private Host {
  public:
    /// Takes the instance over. `onReady` is called when the first frame is published. Throws ipc::Error.
    ServerLoop(const Options& options, std::function<void()> onReady);
    ~ServerLoop() override;

    /// Until a command or a signal ends it. Throws when the first scene cannot be shown, or when the instance
    /// is lost.
    app::ExitCode run();

  private:
    using Clock = std::chrono::steady_clock;

    void load(const std::filesystem::path& path, std::optional<std::filesystem::path> built) override;
    void quit() override { quit_ = true; }
    void setParent(std::optional<std::int64_t> process) override;
    const FrameMaker& frames() const override { return frames_; }

    void takeLoadedScene();
    void takeRefinedTree();
    std::vector<ipc::Command> takeCommands();
    void serve();
    bool serveOne(const ipc::Command& command);
    void move();
    double scale() const;
    void draw();
    void drawFrame();
    void goBack();
    void publish();
    void record();
    void answerWhoWaitsForIdle();
    void answerWhoWaitsForKeys();
    void sleep();

    bool forsaken();
    bool guardFrame();
    bool pollDuringFrame();

    bool wantsFrame() const;
    bool idle() const;
    void tellStatus();
    void count(Clock::time_point now);

    const Options& options_;
    std::function<void()> onReady_;
    ipc::Server server_;
    Session session_;
    Messages messages_;
    FrameMaker frames_;
    ResolutionGovernor governor_;
    std::unique_ptr<SceneLoad> load_;
    std::unique_ptr<TreeRefinement> refinement_; ///< of the scene that is shown
    std::optional<ipc::Command> loader_;         ///< who wants to know of the load; nobody: the command line
    std::deque<ipc::Command> pending_;
    std::size_t waiting_ = 0; ///< of these, the first so many wait for a frame, or behind one that does
    std::vector<ipc::Command> idleWaiters_;
    struct KeyWaiter {
        ipc::Command command;
        std::uint64_t press;
    };
    std::vector<KeyWaiter> keyWaiters_;
    bool quit_ = false;
    std::optional<app::ProcessWatch> parent_;
    rtcore::RenderSettings drawn_;            ///< of the last frame that was published
    bool wentBack_ = false;                   ///< to those, for lack of memory, and none was published since
    bool shown_ = false;                      ///< in this turn a frame was published
    Clock::time_point moved_;                 ///< when keys acted last
    Clock::time_point due_;                   ///< no frame before that
    std::deque<Clock::time_point> published_; ///< within the last second
    std::uint64_t publishedFrames_ = 0;

    // Of the frame that is drawn. The guard's thread has them then, and server_ and pending_ too.
    Clock::time_point begun_;
    bool gaveUpLast_ = false;
    bool changeWaits_ = false;
    std::exception_ptr guardError_;
    FrameGuard guard_;
};

} // namespace rtserver

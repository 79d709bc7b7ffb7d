/// Serve, update, render or idle, until told to exit. (thesis figure 7.2)
#pragma once

#include "rtserver/command_book.h"
#include "rtserver/commands.h"
#include "rtserver/frame_guard.h"
#include "rtserver/frame_maker.h"
#include "rtserver/frame_pacer.h"
#include "rtserver/frame_schedule.h"
#include "rtserver/key_inbox.h"
#include "rtserver/messages.h"
#include "rtserver/requests.h"
#include "rtserver/scene_load.h"
#include "rtserver/server_options.h"
#include "rtserver/server_state.h"
#include "rtserver/shadow_mapping.h"
#include "rtserver/side_work.h"
#include "rtserver/tree_refinement.h"

#include "common/process/exit_codes.h"
#include "common/process/process_watch.h"

#include "ipc/endpoint/server.h"

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rtserver {

/// One thread, beside which a scene is loaded and long frames are guarded.
class ServerLoop : private Host, private Replies {
  public:
    /// Takes the instance over. `onReady` is called when the first frame is published. Throws ipc::Error.
    ServerLoop(const Options& options, std::function<void()> onReady);
    ~ServerLoop() override;

    /// Until a command or a signal ends it. Throws when the first scene cannot be shown, or when the instance
    /// is lost.
    app::ExitCode run();

  private:
    using Clock = std::chrono::steady_clock;

    void load(const std::filesystem::path& path, std::optional<std::filesystem::path> cachedModel) override;
    void quit() override { quit_ = true; }
    void setParent(std::optional<std::int64_t> process) override;
    const FrameMaker& frames() const override { return frames_; }
    const Messages& messages() const override { return messages_; }

    void answer(const ipc::Command& command, const std::string& text) override {
        server_.answer(command, text);
    }
    void refuse(const ipc::Command& command, int code, const std::string& text) override {
        server_.refuse(command, code, text);
    }
    bool isConnected(const ipc::Command& command) const override { return server_.isConnected(command); }

    void takeLoadedScene();
    void takeRefinedTree();
    void takeShadowMaps();
    std::vector<ipc::Command> takeCommands();
    void serve();
    Served serveOne(const ipc::Command& command);
    void answerBy(const ipc::Command& command, const std::function<std::optional<std::string>()>& act);
    void refuseFor(const ipc::Command& command, const std::exception& error);
    void refuseAll(const std::vector<ipc::Command>& commands, app::ExitCode code, const std::string& text);
    void finishSideWork();
    void move();
    void draw();
    void drawFrame();
    bool traceFrame();
    void clearTheWay();
    void goBack();
    void publish();
    void record();
    void answerRequests();
    void sleep();

    bool orphaned();
    bool guardFrame();
    void pollDuringFrame();
    void tell(const ipc::Command& command);

    bool wantsFrame() const;
    bool standsStill() const;
    bool wantsWholeFrame() const;
    bool idle() const;
    void publishStatus();

    const Options& options_;
    std::function<void()> onReady_;
    ipc::Server server_;
    Messages messages_;
    ServerState state_;
    FrameMaker frames_;
    FrameSchedule schedule_;
    FramePacer pacer_;
    std::unique_ptr<SceneLoad> load_;
    std::unique_ptr<TreeRefinement> refinement_; ///< of the scene that is shown
    std::unique_ptr<ShadowMapping> mapping_;     ///< of that scene
    bool mapless_ = false;                       ///< this scene goes without
    Requests requests_{*this};
    CommandBook commands_;
    SideWork sideWork_;
    KeyInbox keys_;
    bool quit_ = false;
    std::optional<app::ProcessWatch> parent_;
    rtcore::RenderSettings drawn_; ///< of the last whole frame that was published
    bool wentBack_ = false;        ///< to those, for lack of memory, and none is there yet
    bool keepsPicture_ = false;    ///< paused, with all of the last image there
    bool shown_ = false;           ///< in this turn a frame was published
    Clock::time_point moved_;      ///< when keys acted last
    std::uint64_t publishedFrames_ = 0, wholeFrames_ = 0;

    // Of the frame that is drawn. The guard's thread has them then, and server_, commands_ and keys_ too.
    Clock::time_point begun_;
    bool changeWaits_ = false; ///< something came that the state does not know yet
    bool endWaits_ = false;    ///< the server was asked to end
    bool obstructed_ = false;  ///< a client has waited for too long with other commands behind
    std::exception_ptr guardError_;
    FrameGuard guard_;
};

} // namespace rtserver

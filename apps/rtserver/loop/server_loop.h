/// Serve, update, render or idle, until told to exit. (thesis figure 7.2)
#pragma once

#include "rtserver/commands/command_service.h"
#include "rtserver/commands/commands.h"
#include "rtserver/commands/requests.h"
#include "rtserver/frames/frame_drawing.h"
#include "rtserver/frames/kept_light.h"
#include "rtserver/frames/scene_upkeep.h"
#include "rtserver/loop/image_revision.h"
#include "rtserver/loop/state_revision.h"
#include "rtserver/messages.h"
#include "rtserver/server_options.h"
#include "rtserver/walk/key_inbox.h"
#include "rtserver/walk/workspace.h"

#include "common/process/exit_codes.h"
#include "common/process/process_watch.h"

#include "ipc/endpoint/server.h"

#include "rtcore/platform/sentence.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rtserver {

/// One thread, beside which scenes are loaded, files written and long frames guarded: while a frame is traced
/// the guard's thread has `server_`, `commands_` and `keys_`, and reads the state.
class ServerLoop : private Host, private Replies {
  public:
    /// Takes the instance over. `onReady` is called when the first frame is published. Throws ipc::Error.
    ServerLoop(const Options& options, std::function<void()> onReady);

    /// Until a command or a signal ends it. Throws when the first scene cannot be shown, or when the instance
    /// is lost.
    app::ExitCode run();

  private:
    using Clock = std::chrono::steady_clock;

    void load(const std::filesystem::path& path, std::optional<std::filesystem::path> cachedModel) override {
        keptLight_.leave(false);
        upkeep_.load(path, std::move(cachedModel));
    }
    void quit() override { quit_ = true; }
    bool quits() const override { return quit_; }
    void setParent(std::optional<std::int64_t> process) override;
    const FrameMaker& frames() const override { return drawing_.frames(); }
    const Messages& messages() const override { return messages_; }

    void answer(const ipc::Command& command, const std::string& text, const std::string& detail) override {
        server_.answer(command, text, detail);
    }
    void refuse(const ipc::Command& command, int code, const rtcore::Sentence& why) override;
    bool isConnected(const ipc::Command& command) const override { return server_.isConnected(command); }

    void turn();
    void takeLoadedScene();
    void tidyUp();
    std::vector<ipc::Command> takeCommands() { return server_.takeCommands(commands_.full()); }
    Arrivals lookDuringFrame();
    bool orphaned();
    void move();
    bool draw();
    void publish(const ipc::FrameInfo& info, const rtcore::LdrImage& image);
    void record();
    void publishStatus();
    void tellDuringFrame(std::uint64_t stateRevision);
    void sleep();

    const Options& options_;
    std::function<void()> onReady_; ///< called once
    ipc::Status status_;            ///< that was told last
    StateRevision revision_;
    ImageRevision imageRevision_;
    ipc::Server server_;
    Messages messages_;
    Workspace state_;
    SceneUpkeep upkeep_;
    FrameDrawing drawing_;
    KeptLight keptLight_;
    CommandService commands_;
    KeyInbox keys_;
    std::optional<app::ProcessWatch> parent_;
    bool quit_ = false;
    bool untidy_ = false;     ///< since another scene was shown, freed memory was not given back
    Clock::time_point moved_; ///< when keys acted last
};

} // namespace rtserver

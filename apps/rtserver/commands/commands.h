/// Runs the server's commands of the table (common/commands/command_table.h).
#pragma once

#include "rtserver/commands/side_work.h"
#include "rtserver/frames/frame_maker.h"
#include "rtserver/messages.h"
#include "rtserver/walk/workspace.h"

#include "common/commands/command_table.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace rtserver {

/// The services of the server to commands, beside its state.
class Host {
  public:
    virtual ~Host() = default;
    /// Begins to load another scene. Throws std::runtime_error when one is being loaded.
    /// `cachedModel`: as in rtcore::LoadOptions.
    virtual void load(const std::filesystem::path& path,
                      std::optional<std::filesystem::path> cachedModel) = 0;
    virtual void quit() = 0;
    virtual bool quits() const = 0; ///< quit() was called
    /// When this process is no more, the server ends as soon as no client is connected. Nothing: it goes on.
    virtual void setParent(std::optional<std::int64_t> process) = 0;
    virtual const FrameMaker& frames() const = 0;
    virtual const Messages& messages() const = 0;
};

/// When the answer is due.
enum class ReplyWhen {
    Done,         ///< now
    Again,        ///< the command needs the frame of what the state shows: run it again when that is there
    WhenIdle,     ///< as soon as the next frame would equal the last
    WhenLoaded,   ///< when the scene stands
    WhenReleased, ///< when the key is up again
    Beside,       ///< when the work is done, which touches files and goes on beside the server
    Apart,        ///< the same for long work: what the client sends meanwhile does not wait for it; where
                  ///< the command Tells, what the work returns uses no state
};

struct Result {
    ReplyWhen when = ReplyWhen::Done;
    std::string answer = {};
    std::string detail = {}; ///< of Done: the answer for programs (ipc::Reply)
    std::uint64_t press = 0; ///< of Keyboard::pressFor(), for WhenReleased
    Work work = {};          ///< for Beside and Apart; what it returns gives the answer
    StopFlag stop = {};      ///< for Apart: gives the work up
    std::string shared = {}; ///< for Apart: see SideWork::start()
};

/// Throws app::UsageError (no such command, wrong arguments), rtcore::FileError, ipc::Error, and other
/// exceptions with a text for the user. Commands that need a scene give Again until there is one. `client`:
/// of ipc::Command, for those to whom it makes a difference.
Result runCommand(std::string_view text, Workspace& state, Host& host, std::uint64_t client = 0);

/// The same for a command of no client, with arguments that suit the table: what a key does.
Result runCommand(app::CommandId id, std::span<const std::string> arguments, Workspace& state, Host& host);

/// Whether runCommand() has a function for it: all that are the server's.
bool hasFunction(app::CommandId id);

} // namespace rtserver

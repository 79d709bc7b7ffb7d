/// The commands that clients send, as a table of what each does.
#pragma once

#include "rtserver/frame_maker.h"
#include "rtserver/session.h"

#include "common/exit_codes.h"

#include <cstdint>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>

namespace rtserver {

/// What a command can ask of the server beside its session.
class Host {
  public:
    virtual ~Host() = default;
    /// Begins to load another scene. Throws std::runtime_error when one is being loaded.
    /// `built`: as in rtcore::LoadOptions.
    virtual void load(const std::filesystem::path& path, std::optional<std::filesystem::path> built) = 0;
    virtual void quit() = 0;
    /// When this process is no more, the server ends as soon as no client is connected. Nothing: it goes on.
    virtual void setParent(std::optional<std::int64_t> process) = 0;
    virtual const FrameMaker& frames() const = 0;
};

/// When the answer is due.
enum class Turn {
    Done,         ///< now
    Again,        ///< the command needs the frame of what the session shows: run it again when that is there
    WhenIdle,     ///< as soon as the next frame would equal the last
    WhenLoaded,   ///< when the scene stands
    WhenReleased, ///< when the key is up again
};

struct Result {
    Turn turn = Turn::Done;
    std::string answer = {};
    std::uint64_t press = 0; ///< of Keyboard::pressFor(), for WhenReleased
};

/// Throws app::UsageError (no such command, wrong arguments), rtcore::FileError, ipc::Error, and other
/// exceptions with a text for the user. Commands that need a scene give Again until there is one.
Result runCommand(std::string_view text, Session& session, Host& host);

/// How a failure is told to clients: the exit code that suits it, a blank, and what happened.
std::string failureText(const std::exception& error);

} // namespace rtserver

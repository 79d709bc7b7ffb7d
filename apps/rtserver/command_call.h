/// What a command of a client is made of: its words, read and checked, and a function that does it.
#pragma once

#include "rtserver/commands.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace rtserver {

struct Call {
    Session& session;
    Host& host;
    std::span<const std::string> arguments;

    const std::string& operator[](std::size_t i) const { return arguments[i]; }
    std::size_t size() const { return arguments.size(); }
};

struct Command {
    std::string_view name;      ///< one word to three
    std::size_t least, most;    ///< arguments
    std::string_view arguments; ///< for messages
    bool needsScene;
    Result (*run)(const Call&);
    Effect effect = Effect::Acts;
};

std::span<const Command> serverCommands();
std::span<const Command> settingCommands();
std::span<const Command> cameraCommands();
std::span<const Command> fileCommands();
std::span<const Command> keyCommands();

// Arguments, read. All throw app::UsageError.

float number(const std::string& text);
int integer(const std::string& text); ///< within a billion
bool flag(const std::string& text);   ///< on, off
int keyOf(const std::string& name);
/// The server's own folder says nothing to a client: absolute paths only.
std::filesystem::path pathOf(const std::string& text);

} // namespace rtserver

/// A command of a client as the function that does it gets it: its arguments, which suit the table of
/// commands.
#pragma once

#include "rtserver/commands/commands.h"

#include "common/cli/input_files.h"

#include "rtcore/platform/sentence.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace rtserver {

struct Call {
    Workspace& state;
    Host& host;
    std::span<const std::string> arguments;
    std::uint64_t client = 0; ///< of ipc::Command
    bool visitor = false;     ///< the note is of one who only looks: no step of undo

    Document& document() const { return state.document; }
    Walk& walk() const { return state.walk; }
    const std::string& operator[](std::size_t i) const { return arguments[i]; }
    std::size_t size() const { return arguments.size(); }
};

struct CommandFunction {
    app::CommandId id;
    Result (*run)(const Call&);
};

std::span<const CommandFunction> serverFunctions();
std::span<const CommandFunction> settingFunctions();
std::span<const CommandFunction> lightFunctions();
std::span<const CommandFunction> cameraFunctions();
std::span<const CommandFunction> fileFunctions();
std::span<const CommandFunction> modelFunctions();
std::span<const CommandFunction> sectionFunctions();
std::span<const CommandFunction> planFunctions();
std::span<const CommandFunction> dimensionFunctions();
std::span<const CommandFunction> keptMeasureFunctions();
std::span<const CommandFunction> noteFunctions();
std::span<const CommandFunction> flightFunctions();
std::span<const CommandFunction> flightKeyFunctions();
std::span<const CommandFunction> variantFunctions();
std::span<const CommandFunction> measureFunctions();
std::span<const CommandFunction> keyFunctions();
std::span<const CommandFunction> saveFunctions();
std::span<const CommandFunction> skyFunctions();

// Arguments, read. They throw app::UsageError where the table could not tell.

float number(const std::string& text);
double preciseNumber(const std::string& text);
int integer(const std::string& text);
bool flag(const std::string& text); ///< on, off
/// Three arguments from that one on; positions in the coordinates of the model's file.
rtcore::Vec3 vectorAt(const Call& call, std::size_t i);
rtcore::Vec3 positionAt(const Call& call, std::size_t i);
/// In those coordinates, parted by spaces.
std::string positionText(const Call& call, rtcore::Vec3 p);
int keyOf(const std::string& name);
/// The server's own folder says nothing to a client: absolute paths only.
std::filesystem::path pathOf(const std::string& text);

/// The answer that tells a warning; none where it is empty.
Answer warningAnswer(const rtcore::Sentence& warning);

/// Refuses to write over one of `inputs`, from which the shown scene was read; but a description may replace
/// another of its kind, which has the extension `replaces`. Throws app::UsageError.
void refuseInput(const app::InputFiles& inputs, const std::filesystem::path& path, std::string_view replaces);

} // namespace rtserver

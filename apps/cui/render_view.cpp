#include "cui/render_view.h"

#include "common/cli/command_line.h"
#include "common/cli/input_files.h"
#include "common/commands/command_lines.h"
#include "common/process/stop.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/processes.h"
#include "rtcore/platform/temporary_folder.h"

#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

namespace cui {

namespace {

namespace fs = std::filesystem;
using CommandLine = std::vector<std::string>;

fs::path rendererProgram() {
    // The environment does not change meanwhile.
    const char* const chosen = std::getenv("RT_RENDERER"); // NOLINT(concurrency-mt-unsafe)
    const fs::path program =
        chosen != nullptr && *chosen != '\0' ? fs::path(chosen) : rtcore::programFolder() / "Renderer";
    std::error_code unknown;
    if (fs::exists(program, unknown)) return program;
    throw rtcore::FileError(rtcore::FailureKind::NoInput, program.string(),
                            "the Renderer is missing; install it beside CUI or name it in RT_RENDERER");
}

} // namespace

void renderView(Conversation& conversation, std::span<const std::string> arguments) {
    if (arguments.empty() || arguments[0].empty())
        throw app::UsageError("render takes FILE, and options for the Renderer behind --");
    const std::string output = arguments[0];
    arguments = arguments.subspan(1);
    if (!arguments.empty() && arguments[0] == "--") arguments = arguments.subspan(1);

    app::InputFiles inputs;
    inputs.add(conversation.request(app::command::scene()));
    inputs.refuse(output);
    const fs::path renderer = rendererProgram();
    rtcore::TemporaryFolder folder("rtsuite-view-");
    const fs::path camera = folder.file("view.cam"), scene = folder.file("view.scn");
    conversation.request(app::command::exportCamera(camera.string()));
    conversation.request(app::command::exportScene(scene.string()));
    conversation.hangUp();

    CommandLine words{scene.string(), "--camera=" + camera.string(), "--output=" + output, "--force"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const rtcore::ProcessResult result = rtcore::runForeground(renderer, words, app::stopSignal);
    app::throwIfStopped();
    if (result.end == rtcore::ProcessEnd::Signalled) {
        throw CommandFailure(app::ExitCode::Failed,
                             "the Renderer was ended by a signal (" + rtcore::signalName(result.code) + ")");
    }
    if (result.code != 0) {
        throw CommandFailure(static_cast<app::ExitCode>(result.code),
                             fmt::format("the Renderer failed with exit code {}", result.code));
    }
}

} // namespace cui

#include "cui/cui_run.h"

#include "cui/chosen_instance.h"
#include "cui/conversation.h"
#include "cui/cui_spec.h"
#include "cui/render_view.h"
#include "cui/status_text.h"

#include "common/cli/command_line.h"
#include "common/cli/help_text.h"
#include "common/cli/instance_option.h"
#include "common/commands/command_lines.h"
#include "common/commands/command_lookup.h"
#include "common/commands/pack_words.h"
#include "common/commands/quoting.h"
#include "common/process/ipc_exit_code.h"
#include "common/process/message.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"
#include "common/progress/progress.h"

#include "ipc/endpoint/instances.h"
#include "ipc/endpoint/viewer.h"

#include "rtcore/platform/files.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <thread>
#include <utility>

namespace cui {

namespace {

using namespace std::chrono_literals;
using app::CommandId;
using Words = std::span<const std::string>;

class Run {
  public:
    explicit Run(const app::Arguments& arguments)
        : instance_(instanceFor(arguments)),
          conversation_(instance_,
                        std::chrono::duration_cast<std::chrono::nanoseconds>(
                            std::chrono::duration<double>(arguments.number("timeout").value_or(60)))),
          json_(arguments.has("json")), pressTime_(arguments.integer("for")),
          count_(arguments.integer("count").value_or(0)) {}

    void command(Words words) {
        const auto [spec, used] = app::findCommand(words);
        if (spec->runner == app::Runner::Shell) return runHere(*spec, words.subspan(used));
        std::vector<std::string> line(words.begin(), words.end());
        std::chrono::milliseconds work(0);
        if (spec->id == CommandId::KeyPress) work = readPressTime(line);
        if (pressTime_ && work == 0ms) throw app::UsageError("--for belongs to 'key press'");
        for (std::size_t i = used; i < line.size() && i - used < spec->arguments.size(); ++i) {
            if (spec->arguments[i - used].type == app::ArgumentType::Path)
                line[i] = std::filesystem::absolute(line[i]).string();
        }
        const std::string text = app::joinWords(line);
        if (spec->id == CommandId::Exit || spec->id == CommandId::Quit) return conversation_.quit(text);
        const std::string answer = answerTo(spec->id, text, work);
        if (!answer.empty()) app::writeLines(answer + "\n");
    }

  private:
    /// Some commands ask no server.
    static std::string instanceFor(const app::Arguments& arguments) {
        const CommandId id = app::findCommand(arguments.positionals()).command->id;
        const bool asksNone = id == CommandId::List || id == CommandId::Free || id == CommandId::About;
        return asksNone ? app::instanceOf(arguments).value_or("default") : chosenInstance(arguments);
    }

    // The server takes the time as a second argument.
    std::chrono::milliseconds readPressTime(std::vector<std::string>& line) const {
        constexpr std::string_view kOption = "--for=";
        std::erase(line, "--for"); // as a line of a script may have it
        for (std::string& word : line) {
            if (word.starts_with(kOption)) word.erase(0, kOption.size());
        }
        constexpr std::size_t kTime = 3;
        if (pressTime_) line.push_back(fmt::format("{}", *pressTime_));
        if (line.size() <= kTime) return 0ms;
        return std::chrono::milliseconds(
            std::max<std::int64_t>(app::parseInteger(line[kTime]).value_or(1), 1));
    }

    std::string answerTo(CommandId id, const std::string& command, std::chrono::milliseconds work) {
        if (id == CommandId::Pack)
            return attended("packing", command, app::command::packProgress(), app::command::packStop());
        if (id == CommandId::MeasureLightGrid)
            return attended("measuring", command, app::command::measureProgress(),
                            app::command::measureStop());
        return conversation_.request(command, work);
    }

    /// Of long work, with its progress.
    std::string attended(const char* what, const std::string& command, const std::string& progressOf,
                         const std::string& stop) {
        std::atomic<double> fraction{0};
        const bool terminal = app::terminalColumns().has_value();
        app::Progress progress(std::string(cuiSpec().name),
                               terminal ? app::ProgressStyle::Bar : app::ProgressStyle::None);
        const app::ProgressScope scope(progress, {what, [&] { return fraction.load(); }});
        return conversation_.attend(command, {progressOf, stop, [&](const std::string& answer) {
                                                  fraction = app::packedFraction(answer).value_or(fraction);
                                              }});
    }

    void runHere(const app::CommandSpec& spec, Words arguments) {
        app::checkArguments(spec, arguments);
        switch (spec.id) {
        case CommandId::Script:
            return script(arguments[0]);
        case CommandId::Render:
            return renderView(conversation_, arguments);
        case CommandId::Status:
            return status();
        case CommandId::Fps:
            return fps();
        case CommandId::Watch:
            return watch();
        case CommandId::List:
            return list();
        case CommandId::Free:
            return free();
        case CommandId::About:
            return app::writeOutput(app::versionText(cuiSpec()));
        default:
            throw std::logic_error(std::string(spec.name) + " is in the table, but CUI does not do it");
        }
    }

    void status() {
        ipc::Viewer viewer(instance_);
        const ipc::Status status = viewer.status();
        const std::int64_t process = viewer.serverProcess();
        app::writeOutput(json_ ? statusJson(instance_, process, status)
                               : statusText(instance_, process, status));
    }

    void fps() {
        ipc::Viewer viewer(instance_);
        app::writeOutput(fmt::format("{:.1f}\n", viewer.status().framesPerSecond));
    }

    void watch() {
        ipc::Viewer viewer(instance_);
        for (std::int64_t i = 0; count_ == 0 || i < count_; ++i) {
            if (i > 0) pause(1s);
            if (viewer.update() == ipc::LinkState::Gone)
                throw CommandFailure(app::ExitCode::TryAgain, "the server '" + instance_ + "' is gone");
            const ipc::Status status = viewer.status();
            app::writeOutput(json_ ? statusJson(instance_, viewer.serverProcess(), status)
                                   : statusLine(status));
        }
    }

    static void pause(std::chrono::milliseconds time) {
        for (; time > 0ms; time -= 50ms) {
            app::throwIfStopped();
            std::this_thread::sleep_for(50ms);
        }
    }

    void list() const {
        const std::vector<ipc::Instance> instances = ipc::listInstances();
        app::writeOutput(json_ ? listJson(instances) : listText(instances));
    }

    void free() const {
        const int names = ipc::freeInstance(instance_);
        app::writeOutput(fmt::format("{} name{} of '{}' removed\n", names, names == 1 ? "" : "s", instance_));
    }

    void script(const std::string& name) {
        if (inScript_) throw app::UsageError("a script cannot run another one");
        inScript_ = true;
        rtcore::LineReader lines(name);
        int number = 0;
        while (const std::optional<std::string> line = lines.next()) {
            app::throwIfStopped();
            runLine(*line, fmt::format("{}:{}: ", name == "-" ? "standard input" : name, ++number));
        }
        inScript_ = false;
    }

    void runLine(const std::string& line, const std::string& where) {
        try {
            const std::vector<std::string> words = app::splitWords(line);
            if (words.empty() || words.front().starts_with('#')) return;
            command(words);
        } catch (const app::UsageError& error) {
            throw CommandFailure(app::ExitCode::BadData, where + error.what());
        } catch (const CommandFailure& error) {
            throw CommandFailure(error.code, where + error.what());
        }
    }

    std::string instance_;
    Conversation conversation_;
    bool json_;
    std::optional<std::int64_t> pressTime_; ///< milliseconds
    std::int64_t count_;                    ///< 0 = no end
    bool inScript_ = false;
};

} // namespace

app::ExitCode runCui(const app::Arguments& arguments) {
    try {
        Run(arguments).command(arguments.positionals());
        return app::ExitCode::Done;
    } catch (const CommandFailure& error) {
        app::printMessage(cuiSpec().name, error.what());
        return error.code;
    } catch (const ipc::Error& error) {
        app::printMessage(cuiSpec().name, error.what());
        return app::exitCodeOf(error.problem);
    }
}

} // namespace cui

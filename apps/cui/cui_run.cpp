#include "cui/cui_run.h"

#include "cui/conversation.h"
#include "cui/cui_spec.h"
#include "cui/render_view.h"
#include "cui/status_text.h"

#include "common/cli/command_line.h"
#include "common/cli/help_text.h"
#include "common/commands/quoting.h"
#include "common/process/ipc_exit_code.h"
#include "common/process/message.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"

#include "ipc/endpoint/instances.h"
#include "ipc/endpoint/viewer.h"

#include "rtcore/platform/files.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <thread>
#include <utility>

namespace cui {

namespace {

using namespace std::chrono_literals;
using Words = std::span<const std::string>;

class Run {
  public:
    explicit Run(const app::Arguments& arguments)
        : instance_(arguments.text("instance").value_or("default")),
          conversation_(instance_,
                        std::chrono::duration_cast<std::chrono::nanoseconds>(
                            std::chrono::duration<double>(arguments.number("timeout").value_or(60)))),
          json_(arguments.has("json")), pressTime_(arguments.integer("for")),
          count_(arguments.integer("count").value_or(0)) {}

    void command(Words words) {
        const FoundCommand found = findCommand(words);
        const Words arguments = words.subspan(found.words);
        if (found.spec->doer == Doer::Local) return local(*found.spec, arguments);
        std::vector<std::string> line(words.begin(), words.end());
        std::chrono::milliseconds work(0);
        if (found.spec->name == "key press") work = readPressTime(line);
        if (pressTime_ && work == 0ms) throw app::UsageError("--for belongs to 'key press'");
        if (found.spec->path && !arguments.empty())
            line[found.words] = std::filesystem::absolute(line[found.words]).string();
        const std::string text = app::joinWords(line);
        if (found.spec->name == "exit" || found.spec->name == "quit") return conversation_.quit(text);
        const std::string answer = conversation_.request(text, work);
        if (!answer.empty()) app::writeLines(answer + "\n");
    }

  private:
    // The server takes the time as a second argument.
    std::chrono::milliseconds readPressTime(std::vector<std::string>& line) const {
        constexpr std::string_view kOption = "--for=";
        std::erase(line, "--for"); // as a line of a script may have it
        for (std::string& word : line) {
            if (word.starts_with(kOption)) word.erase(0, kOption.size());
        }
        constexpr std::size_t kTime = 3;
        if (pressTime_) line.push_back(std::to_string(*pressTime_));
        if (line.size() <= kTime) return 0ms;
        return std::chrono::milliseconds(
            std::max<std::int64_t>(app::parseInteger(line[kTime]).value_or(1), 1));
    }

    void local(const CommandSpec& spec, Words arguments) {
        if (spec.name == "script") {
            if (arguments.size() != 1) throw app::UsageError("script takes FILE, or - for standard input");
            return script(arguments[0]);
        }
        if (spec.name == "render") return renderView(conversation_, arguments);
        if (!arguments.empty()) throw app::UsageError(std::string(spec.name) + " takes no arguments");
        if (spec.name == "status") return status();
        if (spec.name == "fps") return fps();
        if (spec.name == "watch") return watch();
        if (spec.name == "list") return list();
        if (spec.name == "free") return free();
        app::writeOutput(app::versionText(cuiSpec()));
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
        char text[32];
        std::snprintf(text, sizeof text, "%.1f\n", viewer.status().framesPerSecond);
        app::writeOutput(text);
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
        app::writeOutput(std::to_string(names) + (names == 1 ? " name" : " names") + " of '" + instance_ +
                         "' removed\n");
    }

    void script(const std::string& name) {
        if (inScript_) throw app::UsageError("a script cannot run another one");
        inScript_ = true;
        rtcore::LineReader lines(name);
        int number = 0;
        while (const std::optional<std::string> line = lines.next()) {
            app::throwIfStopped();
            runLine(*line, (name == "-" ? "standard input" : name) + ":" + std::to_string(++number) + ": ");
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

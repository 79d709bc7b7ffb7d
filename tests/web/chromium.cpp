#include "web/chromium.h"

#include <array>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include <poll.h>

namespace test {

namespace {

std::array<int, 2> makePipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    return ends;
}

/// In the new process: the browser reads commands from 3 and writes answers to 4. Files for the time of its
/// run lie in its own folder.
void becomeBrowser(int commands, int answers, const std::filesystem::path& folder,
                   std::vector<std::string> words) {
    ::setpgid(0, 0);
    ::setenv("TMPDIR", folder.c_str(), 1);
    const std::string output = (folder / "output.txt").string();
    constexpr int kBeyond = 10; // neither end may lie where the other goes
    const int in = ::fcntl(commands, F_DUPFD_CLOEXEC, kBeyond),
              out = ::fcntl(answers, F_DUPFD_CLOEXEC, kBeyond);
    const int file = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    ::dup2(file, 1);
    ::dup2(file, 2);
    ::dup2(in, 3);
    ::dup2(out, 4);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
}

} // namespace

std::optional<std::string> chromiumProgram() {
    if (const char* const asked = std::getenv("RT_CHROMIUM"); asked != nullptr)
        return *asked != '\0' ? std::optional<std::string>(asked) : std::nullopt;
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        const std::string program = folder + "/chromium";
        if (::access(program.c_str(), X_OK) == 0) return program;
    }
    return {};
}

Chromium::Chromium(const std::vector<std::string>& options) {
    ::prctl(PR_SET_CHILD_SUBREAPER, 1); // helpers that outlive the browser are this process's to wait for
    const auto commands = makePipe(), answers = makePipe();
    commands_ = commands[1];
    answers_ = answers[0];
    std::vector<std::string> words{chromiumProgram().value(), "--headless", "--no-sandbox",
                                   "--disable-dev-shm-usage", "--remote-debugging-pipe", "--no-first-run",
                                   // No traffic of the browser's own.
                                   "--disable-background-networking", "--disable-component-update",
                                   "--disable-default-apps", "--disable-extensions", "--disable-sync",
                                   "--user-data-dir=" + profile_.path().string(), "--window-size=800,600"};
    words.insert(words.end(), options.begin(), options.end());
    words.emplace_back("about:blank");
    process_ = std::make_unique<ChildProcess>(
        [&] { becomeBrowser(commands[0], answers[1], profile_.path(), words); });
    group_ = process_->process();
    ::close(commands[0]);
    ::close(answers[1]);
    call("Browser.getVersion");
}

Chromium::~Chromium() {
    ::close(commands_);
    ::close(answers_);
    kill();
}

void Chromium::kill() {
    process_->kill();
    // Helpers that outlive it would still write into its folder.
    ::kill(-group_, SIGKILL);
    while (::waitpid(-group_, nullptr, 0) > 0) {
    }
}

std::optional<Json> Chromium::read(Clock::time_point deadline) {
    for (;;) {
        if (const auto end = unread_.find('\0'); end != std::string::npos) {
            const std::string message = unread_.substr(0, end);
            unread_.erase(0, end + 1);
            return Json::parse(message);
        }
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
        pollfd stream{answers_, POLLIN, 0};
        if (left <= 0 || ::poll(&stream, 1, static_cast<int>(left)) <= 0) return {};
        std::array<char, 65536> bytes{};
        const ssize_t count = ::read(answers_, bytes.data(), bytes.size());
        if (count <= 0)
            throw std::runtime_error("the browser has ended: " + (profile_ / "output.txt").string());
        unread_.append(bytes.data(), static_cast<std::size_t>(count));
    }
}

Json Chromium::call(const std::string& method, const Json& parameters, const std::string& session) {
    Json command{{"id", ++lastId_}, {"method", method}, {"params", parameters}};
    if (!session.empty()) command["sessionId"] = session;
    const std::string text = command.dump() + '\0';
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t count = ::write(commands_, text.data() + sent, text.size() - sent);
        if (count <= 0) throw std::runtime_error("the browser takes no command");
        sent += static_cast<std::size_t>(count);
    }
    const auto deadline = Clock::now() + 60s;
    while (std::optional<Json> said = read(deadline)) {
        if (said->value("id", 0) != lastId_) {
            events_.push_back(std::move(*said));
        } else if (said->contains("error")) {
            throw std::runtime_error(method + ": " + (*said)["error"].dump());
        } else {
            return (*said)["result"];
        }
    }
    throw std::runtime_error(method + ": no answer");
}

void Chromium::listen(std::chrono::milliseconds time) {
    const auto deadline = Clock::now() + time;
    while (std::optional<Json> said = read(deadline)) events_.push_back(std::move(*said));
}

std::vector<Json> Chromium::events(const std::string& session) const {
    std::vector<Json> mine;
    for (const Json& event : events_)
        if (event.value("sessionId", "") == session) mine.push_back(event);
    return mine;
}

void Chromium::closePages() {
    for (const Json& context : call("Target.getBrowserContexts")["browserContextIds"])
        call("Target.disposeBrowserContext", {{"browserContextId", context}});
    events_.clear();
}

Chromium& sharedChromium(const std::vector<std::string>& options) {
    static std::unique_ptr<Chromium> shared;
    static std::vector<std::string> its;
    if (shared && !shared->killed() && its == options) {
        shared->closePages();
    } else {
        shared.reset(); // one at a time
        shared = std::make_unique<Chromium>(options);
        its = options;
    }
    return *shared;
}

} // namespace test

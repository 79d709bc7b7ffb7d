/// A server that shows what the test says, and a bridge beside it.
#pragma once

#include "process/bridge/web_client.h"

#include "common/commands/state_report.h"
#include "ipc/endpoint/server.h"
#include "support/child_process.h"
#include "support/ipc_instance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <mutex>
#include <sstream>
#include <thread>

namespace test {

/// Takes all commands, and remembers them. Frames are noise that differs from frame to frame.
class FakeServer {
  public:
    explicit FakeServer(const std::string& instance) : thread_([this, instance] { run(instance); }) {
        eventually([&] { return running_.load(); });
    }
    ~FakeServer() {
        stopping_ = true;
        thread_.join();
    }

    /// Another frame of this size, at rest, or so many a second while moving.
    void show(int width, int height) {
        const std::lock_guard lock(mutex_);
        width_ = width;
        height_ = height;
        showOne_ = true;
    }
    void move(int framesPerSecond) {
        improves_ = false;
        rate_ = framesPerSecond;
    }
    /// Its next frame never comes.
    void hang() { hangs_ = true; }
    /// It takes commands, and answers none any more.
    void fallSilent() { silent_ = true; }
    /// So many steps a second of a picture of one view, each of which tells that it is further.
    void improve(int stepsPerSecond) {
        improves_ = true;
        rate_ = stepsPerSecond;
    }
    /// No better step follows.
    void finish() {
        rate_ = 0;
        show(width_, height_);
    }
    std::vector<std::uint8_t> pixels() {
        const std::lock_guard lock(mutex_);
        return {reinterpret_cast<const std::uint8_t*>(pixels_.data()),
                reinterpret_cast<const std::uint8_t*>(pixels_.data()) + pixels_.size()};
    }
    bool isHeld(int key) {
        const std::lock_guard lock(mutex_);
        return keys_.down[static_cast<std::size_t>(key)];
    }
    bool anyHeld() {
        const std::lock_guard lock(mutex_);
        return keys_.down.any();
    }
    std::uint32_t presses(int key) {
        const std::lock_guard lock(mutex_);
        return presses_[static_cast<std::size_t>(key)];
    }
    int clients() const { return clients_; }
    std::size_t published() {
        const std::lock_guard lock(mutex_);
        return frame_;
    }
    /// All but those that the bridge sends on its own account, and without for whom they are.
    std::vector<std::string> commands() {
        const std::lock_guard lock(mutex_);
        return commands_;
    }
    void setState(const app::StateReport& state) {
        const std::lock_guard lock(mutex_);
        state_ = state;
        ++revision_;
    }
    /// Another client's edit. The pages' `set` counts as one, too, and their `undo` takes one back.
    void edit(const std::string& label) {
        const std::lock_guard lock(mutex_);
        count(label, 0);
    }
    /// Another client's undo.
    void undo() {
        const std::lock_guard lock(mutex_);
        takeBack();
    }
    /// The time that it reports for a frame, and for the whole one at rest.
    void tellFrameSeconds(double seconds) { frameSeconds_ = seconds; }
    void tellWholeSeconds(double seconds) { wholeSeconds_ = seconds; }
    /// Instead of doing what it says; "": done.
    std::function<std::string(const std::string&)> onCommand = {};
    const std::string bindings =
        "W forward\nF toggleWalk\nB toggleBloom\n1 toggleLight 1\nM+2 selectEnvironment 2";
    static app::StateReport plainState() {
        app::StateReport state;
        state.scene = "/secret/folder/hall.scn";
        state.settings = rtcore::settingAssignments({}, true);
        state.lights = {{3, true, "pendant"}};
        state.bookmarks = {"altar"};
        return state;
    }

  private:
    void run(const std::string& instance) {
        ipc::Server server({.instance = instance, .width = 320, .height = 200});
        publish(server);
        running_ = true;
        auto last = Clock::now();
        while (!stopping_) {
            server.wait(1ms);
            serve(server);
            tellRevision(server);
            const int rate = rate_;
            const bool due =
                rate > 0 && !hangs_ && Clock::now() - last >= std::chrono::microseconds(1'000'000) / rate;
            if (due) last = Clock::now();
            if (due || takeShowOne()) publish(server);
        }
    }
    bool takeShowOne() {
        const std::lock_guard lock(mutex_);
        return std::exchange(showOne_, false);
    }
    void tellRevision(ipc::Server& server) {
        const std::lock_guard lock(mutex_);
        if (status_.stateRevision == revision_) return;
        status_.stateRevision = revision_;
        server.setStatus(status_);
    }
    void publish(ipc::Server& server) {
        const std::lock_guard lock(mutex_);
        pixels_.resize(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
        for (std::size_t i = 0; i < pixels_.size(); ++i)
            pixels_[i] = static_cast<std::byte>((i / 4 * (i % 4 + 1) + frame_ * 7) >> 3);
        ++frame_;
        ipc::Status& status = status_;
        status.stateRevision = revision_;
        status.width = static_cast<std::uint32_t>(width_);
        status.height = static_cast<std::uint32_t>(height_);
        status.frameSeconds = frameSeconds_;
        status.wholeSeconds = wholeSeconds_;
        status.idle = rate_ == 0 ? 1 : 0;
        status.eye[0] = static_cast<float>(rate_ > 0 && !improves_ ? frame_ : 0);
        server.setStatus(status);
        ipc::FrameInfo info;
        info.width = status.width;
        info.height = status.height;
        info.tag = improves_ ? frame_ : 0;
        server.publishFrame(info, pixels_);
    }
    void serve(ipc::Server& server) {
        clients_ = server.clients();
        {
            const std::lock_guard lock(mutex_);
            keys_ = server.keys();
            for (std::size_t key = 0; key < presses_.size(); ++key) presses_[key] += keys_.presses[key];
        }
        for (const ipc::Command& command : server.takeCommands()) answer(server, command);
    }
    void count(const std::string& label, int person) {
        edits_.push_back({label, {++numbers_, person}});
        tellEdits();
    }
    void takeBack() {
        edits_.pop_back();
        tellEdits();
    }
    void tellEdits() {
        ++revision_;
        state_.edits = static_cast<int>(edits_.size());
        state_.undo = edits_.empty() ? "" : edits_.back().label;
        state_.undoEdit = edits_.empty() ? app::ReportedEdit() : edits_.back().edit;
    }
    /// False: it cannot.
    bool follow(const std::string& command, int person) {
        if (command.starts_with("set ")) count(command.substr(0, command.rfind(' ')), person);
        if (!command.starts_with("undo ")) return true;
        if (edits_.empty() || edits_.back().edit.number != std::stoi(command.substr(5))) return false;
        takeBack();
        return true;
    }
    /// Cuts `by PERSON` off.
    static int takePerson(std::string& command) {
        if (!command.starts_with("by ")) return 0;
        const std::size_t end = command.find(' ', 3);
        const int person = std::stoi(command.substr(3, end - 3));
        command.erase(0, end + 1);
        return person;
    }
    void answer(ipc::Server& server, const ipc::Command& command) {
        const std::lock_guard lock(mutex_);
        if (command.text == "state") return server.answer(command, app::formatStateReport(state_, 65520));
        if (command.text.starts_with("messages")) return server.answer(command);
        if (command.text == "bindings") return server.answer(command, bindings);
        std::string text = command.text;
        const int person = takePerson(text);
        commands_.push_back(text);
        if (silent_) return;
        if (!follow(text, person)) return server.refuse(command, 1, "it is not the last edit");
        server.answer(command, onCommand ? onCommand(text) : "");
    }

    std::mutex mutex_;
    std::vector<std::byte> pixels_;
    ipc::KeyState keys_;
    std::array<std::uint32_t, 256> presses_{};
    std::vector<std::string> commands_;
    app::StateReport state_ = plainState();
    std::uint64_t revision_ = 0; ///< of it
    ipc::Status status_;         ///< that was told last
    struct Edit {
        std::string label;
        app::ReportedEdit edit;
    };
    std::vector<Edit> edits_;
    int numbers_ = 0;
    int width_ = 320, height_ = 200;
    std::size_t frame_ = 0;
    bool showOne_ = false;
    std::atomic<double> frameSeconds_ = 0, wholeSeconds_ = 0;
    std::atomic<int> rate_ = 0, clients_ = 0;
    std::atomic<bool> running_ = false, stopping_ = false, improves_ = false, hangs_ = false, silent_ = false;
    std::thread thread_; // last
};

/// Seconds or rounds that a test takes: what this variable of the environment asks for.
inline int asked(const char* variable, int unlessTold) {
    const char* const text = std::getenv(variable);
    return text != nullptr ? std::atoi(text) : unlessTold;
}

class BridgeTest : public testing::Test {
  protected:
    static constexpr const char* kDriver = "driver-driver-driver-driver";
    static constexpr const char* kViewer = "viewer-viewer-viewer-viewer";

    void startServer() { server = std::make_unique<FakeServer>(instance.name()); }
    void startBridge(std::vector<std::string> options = {}, const std::string& listen = "127.0.0.1:0") {
        const std::string tokens = (instance.folder() / "tokens").string(),
                          output = (instance.folder() / "links").string();
        std::ofstream(tokens) << kDriver << "\n" << kViewer << "\n";
        std::filesystem::permissions(tokens, std::filesystem::perms::owner_read |
                                                 std::filesystem::perms::owner_write);
        std::filesystem::remove(output);
        std::vector<std::string> words{"--instance=" + instance.name(), "--listen=" + listen,
                                       "--token-file=" + tokens};
        words.insert(words.end(), options.begin(), options.end());
        const auto isRest = [](const std::string& word) { return word.starts_with("--rest="); };
        if (std::ranges::none_of(words, isRest)) words.emplace_back("--rest=live"); // there is no scene
        bridge = ChildProcess(std::string(RT_PROGRAM_FOLDER) + "/RTBridge", words, {.outputFile = output});
        eventually([&] { return links().find("Viewer: ") != std::string::npos; }, 10s);
        const std::string text = links(), before = "http://127.0.0.1:";
        const std::size_t at = text.find(before);
        if (at != std::string::npos) port = std::atoi(text.c_str() + at + before.size());
    }
    /// Behind a proxy the links do not tell the port: one is chosen, and another one when that is taken.
    void startBridgeBehind(const std::string& origin, std::vector<std::string> options = {}) {
        options.push_back("--origin=" + origin);
        port = 0;
        for (int candidate = 20'000 + static_cast<int>(ipc::randomTag() % 20'000); port == 0; ++candidate) {
            startBridge(options, "127.0.0.1:" + std::to_string(candidate));
            if (links().find(origin + "#t=") != std::string::npos) port = candidate;
        }
    }
    static std::string readAll(const std::filesystem::path& file) {
        std::ostringstream text;
        text << std::ifstream(file).rdbuf();
        return text.str();
    }
    std::string links() const { return readAll(instance.folder() / "links"); }
    void SetUp() override {
        startServer();
        startBridge();
    }
    /// Errors that sanitizers find in the bridge fail the test.
    void TearDown() override {
        if (!kSanitized || bridge.process() <= 0) return;
        bridge.send(SIGTERM);
        const int status = bridge.wait(20s);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 143) << status << links();
        EXPECT_EQ(links().find("runtime error"), std::string::npos) << links();
    }

    /// One that has said hello and is welcome.
    std::unique_ptr<WebClient> join(const char* token = kDriver, const std::string& name = "test") {
        auto client = std::make_unique<WebClient>(port);
        client->hello(token, name);
        EXPECT_FALSE(client->event("welcome").is_null());
        return client;
    }
    std::string get(const std::string& request) {
        RawSocket socket(port);
        socket.write(request);
        return socket.readAll(3s);
    }
    std::string page(const std::string& path, const std::string& more = "") {
        return get("GET " + path + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
                   "\r\nConnection: close\r\n" + more + "\r\n");
    }

    /// Connections, as the bridge counts them.
    int visitors() {
        const std::string answer = page("/status", "Authorization: Bearer " + std::string(kViewer) + "\r\n");
        const auto body = answer.find("\r\n\r\n");
        const nlohmann::json status =
            nlohmann::json::parse(body == std::string::npos ? "" : answer.substr(body), nullptr, false);
        return status.is_object() ? status.value("clients", -1) : -1;
    }

    IpcInstance instance;
    std::unique_ptr<FakeServer> server;
    ChildProcess bridge;
    int port = 0;
};

} // namespace test

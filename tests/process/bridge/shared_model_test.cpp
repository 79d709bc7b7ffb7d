// A page and a shell at one RTServer.
#include "ipc/endpoint/instances.h"
#include "process/bridge/png_pixels.h"
#include "process/bridge/web_client.h"
#include "process/server/live_server.h"
#include "support/child_process.h"

#include <functional>

namespace {

using namespace test;
using nlohmann::json;

class SharedModel : public LiveServer {
  protected:
    std::unique_ptr<WebClient> page(const std::vector<std::string>& options = {},
                                    const std::string& rest = "live") {
        start();
        std::vector<std::string> words{"--instance=" + instance.name(), "--listen=127.0.0.1:0",
                                       "--rest=" + rest};
        words.insert(words.end(), options.begin(), options.end());
        bridge_ = ChildProcess(programPath("RTBridge").string(), words,
                               {.environment = {{"RT_KEEP_PRIORITY", "1"}}, // tests wait for its Renderer
                                .outputFile = (folder() / "links").string()});
        EXPECT_TRUE(eventually([&] { return bytes("links").find("Viewer: ") != std::string::npos; }, 20s));
        const std::string text = bytes("links");
        const std::size_t link = text.find("127.0.0.1:"), token = text.find("#t=") + 3;
        auto client = std::make_unique<WebClient>(std::atoi(text.c_str() + link + 10));
        client->hello(text.substr(token, text.find('\n') - token));
        EXPECT_EQ(client->event("welcome")["role"], "driver");
        return client;
    }
    /// The next state that says so, if one does.
    static bool tells(WebClient& client, const char* key, bool value) {
        json told = client.event("state");
        while (!told.is_null() && told[key] != value) told = client.event("state");
        return !told.is_null();
    }

    std::int64_t bridgeProcess() const { return bridge_.process(); }
    void killBridge() {
        bridge_.send(SIGKILL);
        bridge_.wait(20s);
    }

  private:
    ChildProcess bridge_;
};

TEST_F(SharedModel, APageTakesBackNoEditOfAShell) {
    const auto client = page();
    const json edit{{"do", "set"}, {"args", {"shadows", false}}};
    EXPECT_EQ(client->request(edit)["ok"], true);
    ASSERT_TRUE(tells(*client, "mayUndo", true));
    ask({"undo"});
    ask({"set", "shadows", "false"});
    EXPECT_EQ(client->request({{"do", "undo"}})["ok"], false);
    EXPECT_TRUE(tells(*client, "mayUndo", false));
    EXPECT_EQ(ask({"get", "shadows"}), "false\n");
    // Nor does a drag of the page become part of the shell's edit.
    json drag = edit;
    drag["also"] = true;
    drag["args"] = {"shadows", true};
    EXPECT_EQ(client->request(drag)["ok"], true);
    ASSERT_TRUE(tells(*client, "mayUndo", true));
    EXPECT_EQ(client->request({{"do", "undo"}})["ok"], true);
    EXPECT_EQ(ask({"get", "shadows"}), "false\n");
    // And again: the edit that was taken back, unless the shell's comes instead.
    ASSERT_TRUE(tells(*client, "mayRedo", true));
    EXPECT_EQ(client->request({{"do", "redo"}})["ok"], true);
    EXPECT_EQ(ask({"get", "shadows"}), "true\n");
    ask({"undo"});
    ask({"set", "maxDepth", "3"});
    ask({"undo"});
    EXPECT_EQ(client->request({{"do", "redo"}})["ok"], false);
    EXPECT_EQ(ask({"get", "maxDepth"}), "5\n");
}

// At once, before the bridge can have asked what keys do.
TEST_F(SharedModel, LockedEditsHoldForKeysThatAreBoundMeanwhile) {
    const auto client = page({"--lock=edits"});
    client->event("state");
    std::this_thread::sleep_for(1200ms); // it knows what they did before
    ask({"bind", "k", "toggleBloom"});
    ask({"bind", "l", "toggleLight", "1"});
    for (int i = 0; i < 5; ++i) {
        client->input({}, 0, 0, {'K', 'L'});
        std::this_thread::sleep_for(100ms);
    }
    ask({"wait-idle"});
    EXPECT_EQ(ask({"get", "bloom.radius"}), "0\n");
    EXPECT_EQ(ask({"messages"}).find("bloom"), std::string::npos);
    ask({"key", "tap", "k"});
    EXPECT_TRUE(eventually([&] { return ask({"get", "bloom.radius"}) != "0\n"; })) << "a shell's key does";
}

/// The newest of what a page is sent.
class Watcher {
  public:
    explicit Watcher(WebClient& client) : client_(client) {}
    /// Reads on until it holds.
    bool until(const std::function<bool()>& holds) {
        for (const auto end = Clock::now() + 60s; Clock::now() < end;) {
            if (holds()) return true;
            if (const auto message = client_.next(100ms)) take(*message);
        }
        return false;
    }
    const json& image() const { return image_; }                      ///< event
    const std::vector<std::uint8_t>& exact() const { return shown_; } ///< empty: none is shown
    std::size_t frames() const { return frames_; }

  private:
    void take(const WebFrame& message) {
        if (message.opcode == 1) {
            const json event = json::parse(message.payload);
            if (event["event"] == "image") image_ = event;
            return;
        }
        if (message.opcode != 2) return;
        client_.acknowledge(message);
        const FrameHeader header = headerOf(message.payload);
        if (header.type != 2) {
            ++frames_;
            return shown_.clear();
        }
        if (header.offset == 0) still_.clear();
        still_ += message.payload.substr(40);
        if (still_.size() == header.total) shown_ = rgbOf(still_);
    }

    WebClient& client_;
    json image_ = json::object();
    std::string still_;
    std::vector<std::uint8_t> shown_;
    std::size_t frames_ = 0;
};

// As any Renderer makes it of what the server shows, to the bit; and the server's frames once it moves.
TEST_F(SharedModel, ShowsTheViewByPathsAtRest) {
    const auto client = page({}, "paths");
    Watcher watcher(*client);
    ask({"set", "path.samples", "16"});
    ask({"wait-idle"});
    ask({"export", "scene", "rest.scn"});
    ask({"export", "camera", "rest.cam"});
    const ProgramResult rendered = runProgram(programPath("Renderer"),
                                              {"rest.scn", "--camera=rest.cam", "--integrator=path", "-o",
                                               "rest.png", "--setting=exposure.recorded=automatic",
                                               "--setting=path.filter=4", "--setting=denoise.net=automatic"},
                                              {.folder = folder().path(), .timeoutSeconds = 120});
    ASSERT_EQ(rendered.exitCode, 0) << rendered.error;
    const std::vector<std::uint8_t> pixels = rgbOf(bytes("rest.png"));
    EXPECT_TRUE(watcher.until([&] { return watcher.image()["part"] == 1 && watcher.exact() == pixels; }))
        << watcher.image();
    EXPECT_EQ(watcher.image()["samples"], 16);
    const std::size_t frames = watcher.frames();
    ask({"camera", "turn", "20", "0"});
    EXPECT_TRUE(watcher.until([&] { return watcher.image()["paths"] == false; }));
    EXPECT_TRUE(watcher.until([&] { return watcher.frames() > frames; }));
}

// Its Renderer ends with it, however it ends, and leaves nothing.
TEST_F(SharedModel, EndsItsRendererWithItself) {
    const auto client = page({}, "paths");
    const json told = client->event("image", 60s);
    ASSERT_FALSE(told.is_null());
    const std::string name = "preview-" + std::to_string(bridgeProcess()) + "-1";
    const auto runs = [&] {
        const auto all = ipc::listInstances();
        return std::ranges::any_of(all, [&](const auto& each) { return each.name == name && each.running; });
    };
    EXPECT_TRUE(runs());
    killBridge();
    EXPECT_TRUE(eventually([&] { return !runs(); }, 20s));
}

} // namespace

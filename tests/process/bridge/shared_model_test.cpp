// A page and a shell at one RTServer.
#include "process/bridge/web_client.h"
#include "process/server/live_server.h"
#include "support/child_process.h"

namespace {

using namespace test;
using nlohmann::json;

class SharedModel : public LiveServer {
  protected:
    std::unique_ptr<WebClient> page(const std::vector<std::string>& options = {}) {
        start();
        std::vector<std::string> words{"--instance=" + instance.name(), "--listen=127.0.0.1:0"};
        words.insert(words.end(), options.begin(), options.end());
        bridge_ = ChildProcess(programPath("RTBridge").string(), words,
                               {.outputFile = (folder() / "links").string()});
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

} // namespace

// What a page may ask for.
#include "process/bridge/bridge_fixture.h"

#include <iostream>
#include <random>

namespace {

using namespace test;
using nlohmann::json;

class Requests : public BridgeTest {};

TEST_F(Requests, ReachTheServerAsCommands) {
    const auto client = join();
    EXPECT_EQ(client->request({{"do", "walk"}})["ok"], true);
    EXPECT_EQ(client->request({{"do", "set"}, {"name", "maxDepth"}, {"value", 3}})["ok"], true);
    EXPECT_EQ(client->request({{"do", "light"}, {"light", 3}, {"on", false}})["ok"], true);
    EXPECT_EQ(server->commands(), (std::vector<std::string>{"walk", "set maxDepth 3", "light 3 off"}));
}

TEST_F(Requests, ThatAreNotOnTheListNeverDo) {
    const auto client = join();
    for (const char* name :
         {"exit", "quit", "load scene", "loadScene", "save", "screenshot", "export scene", "key press",
          "bind", "parent", "idle", "scene", "environmentOpen", "play", "hello", "", "walk\nexit"}) {
        const json answer = client->request({{"do", name}, {"file", "/etc/passwd"}});
        EXPECT_EQ(answer["ok"], false) << name;
    }
    EXPECT_TRUE(server->commands().empty());
}

TEST_F(Requests, TellTheStateWithoutFolders) {
    const auto client = join();
    const json state = client->event("state");
    EXPECT_EQ(state["scene"], "hall.scn");
    EXPECT_EQ(state["lights"][0]["id"], 3);
    EXPECT_EQ(state.dump().find("secret"), std::string::npos);
    app::StateReport changed = FakeServer::plainState();
    changed.lights[0].on = false;
    server->setState(changed);
    json later = client->event("state");
    while (!later.is_null() && !later.contains("lights")) later = client->event("state");
    ASSERT_FALSE(later.is_null()) << "what others change is told, too";
    EXPECT_EQ(later["lights"][0]["on"], false);
    EXPECT_FALSE(later.contains("values")) << "nothing of it changed";
}

TEST_F(Requests, UndoOnlyTheSessionsOwnEdit) {
    app::StateReport state = FakeServer::plainState();
    state.edits = 1;
    state.undo = "set bloom.radius"; // of the window
    server->setState(state);
    const auto client = join();
    EXPECT_EQ(client->event("state")["mayUndo"], false);
    EXPECT_EQ(client->request({{"do", "undo"}})["ok"], false);
    state.edits = 2;
    state.undo = "set maxDepth";
    server->setState(state);
    EXPECT_EQ(client->request({{"do", "set"}, {"name", "maxDepth"}, {"value", 3}})["ok"], true);
    json told = client->event("state");
    while (!told.is_null() && told["mayUndo"] != true) told = client->event("state");
    ASSERT_FALSE(told.is_null());
    EXPECT_EQ(client->request({{"do", "undo"}})["ok"], true);
    EXPECT_EQ(server->commands(), (std::vector<std::string>{"set maxDepth 3", "undo"}));
}

TEST_F(Requests, ThatAreNoObjectsCloseTheConnection) {
    for (const char* text : {"", "x", "1", "[]", "{\"do\":\"walk\"}", "{\"do\":\"walk\",\"id\":-1}",
                             "{\"do\":\"walk\",\"id\":1e99}", "{\"do\":\"walk\",\"id\":\"1\"}"}) {
        const auto client = join();
        client->sendText(text);
        EXPECT_EQ(client->closeCode(), 4002) << text;
    }
    const auto client = join();
    client->sendBinary({77, 1, 2});
    EXPECT_EQ(client->closeCode(), 4002);
    EXPECT_TRUE(server->commands().empty());
}

class LockedEdits : public BridgeTest {
    void SetUp() override {
        startServer();
        startBridge({"--lock=edits"});
    }
};

TEST_F(LockedEdits, ChangeNothingButTheView) {
    const auto client = join();
    for (const json& request : {json{{"do", "set"}, {"name", "maxDepth"}, {"value", 3}},
                                json{{"do", "light"}, {"light", 3}, {"on", false}}, json{{"do", "undo"}},
                                json{{"do", "partHide"}, {"parts", {1}}},
                                json{{"do", "resolution"}, {"width", 64}, {"height", 64}}})
        EXPECT_EQ(client->request(request)["ok"], false) << request;
    EXPECT_EQ(client->request({{"do", "fly"}})["ok"], true);
    EXPECT_EQ(server->commands(), std::vector<std::string>{"fly"});
}

/// Whether what was sent so far was read, and the connection is still open.
bool heard(WebClient& client) {
    while (const auto frame = client.next(5s)) {
        if (frame->opcode == 10) return true;
        if (frame->opcode == 8) return false;
    }
    return false;
}

/// So many messages that differ from good ones in a few places; RT_BRIDGE_FUZZ asks for more.
TEST_F(Requests, OfAnyBytesHarmNobody) {
    const int messages = asked("RT_BRIDGE_FUZZ", 10'000);
    const std::vector<std::string> samples{
        R"({"id":1,"do":"camera","eye":[0,1,2],"forward":[0,0,-1],"fov":60})",
        R"({"id":2,"do":"set","name":"maxDepth","value":3})",
        R"({"id":3,"do":"materialSet","number":1,"key":"diffuse","value":[1,1,1]})",
        R"({"id":4,"do":"ask"})",
        R"({"do":"hello","v":1,"token":"x"})",
        R"({"id":5,"do":"partHide","parts":[1,2,3]})"};
    std::mt19937 random(11);
    const auto honest = join(kViewer);
    std::unique_ptr<WebClient> client;
    int sent = 0;
    for (int i = 0; i < messages; ++i) {
        if (i > 0 && i % 100'000 == 0) std::cout << i << " messages" << std::endl;
        if (!client || sent++ % 200 == 199) client = join(); // below the limit of a burst
        std::string text = samples[random() % samples.size()];
        for (unsigned k = random() % 4; k > 0; --k)
            text[random() % text.size()] =
                random() % 2 == 0 ? static_cast<char>(32 + random() % 95) : "{}[]\",:\\0e-"[random() % 11];
        const bool binary = random() % 4 == 0;
        if (random() % 50 == 0) text.resize(random() % 30);
        if (binary) text[0] = static_cast<char>(random() % 6);
        client->socket().write(webFrame(binary ? 0x82 : 0x81, text) + webFrame(0x89, "heard"));
        if (!heard(*client)) client.reset();
        while (i % 100 == 0 && honest->next(0ms)) { // its pings are answered
        }
    }
    EXPECT_FALSE(honest->request({{"do", "parts"}}, 10s).is_null()) << "the bridge serves on";
    for (const std::string& command : server->commands())
        EXPECT_TRUE(command.starts_with("camera ") || command.starts_with("set maxDepth") ||
                    command.starts_with("material set") || command.starts_with("part") ||
                    command.starts_with("also "))
            << command;
}

} // namespace

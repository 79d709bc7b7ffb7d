// Requests that a page may make.
#include "process/bridge/bridge_fixture.h"

#include "rtcore/settings/render_settings.h"

#include <fmt/core.h>

#include <iostream>
#include <random>
#include <span>

namespace {

using namespace test;
using nlohmann::json;

class Requests : public BridgeTest {};

/// The next state that says so, if one does.
bool mayUndo(WebClient& client) {
    json told = client.event("state");
    while (!told.is_null() && told["mayUndo"] != true) told = client.event("state");
    return !told.is_null();
}

TEST_F(Requests, ReachTheServerAsCommands) {
    const auto client = join();
    EXPECT_EQ(client->request({{"do", "walk"}})["ok"], true);
    EXPECT_EQ(client->request({{"do", "set"}, {"args", {"maxDepth", 3}}})["ok"], true);
    EXPECT_EQ(client->request({{"do", "light"}, {"args", {3, "off"}}})["ok"], true);
    EXPECT_EQ(server->commands(), (std::vector<std::string>{"walk", "set maxDepth 3", "light 3 off"}));
}

TEST_F(Requests, AreFourAtOnceAtMost) {
    server->onCommand = [](const std::string&) {
        std::this_thread::sleep_for(200ms);
        return "";
    };
    const auto client = join();
    for (int id = 1; id <= 6; ++id) client->sendText(fmt::format(R"({{"id":{},"do":"walk"}})", id));
    std::vector<int> refused;
    for (int k = 0; k < 6; ++k)
        if (const json answer = client->event("answer"); answer["ok"] != true)
            refused.push_back(answer["id"]);
    EXPECT_EQ(refused, (std::vector{5, 6}));
    EXPECT_EQ(server->commands().size(), 4U);
}

TEST_F(Requests, ThatAreNotOnTheListNeverDo) {
    const auto client = join();
    for (const char* name : {"exit", "quit", "load scene", "loadScene", "save", "screenshot", "export scene",
                             "key press", "bind", "parent", "idle", "scene", "environment open", "play",
                             "light name", "bookmark add", "hello", "", "walk\nexit"}) {
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
    server->edit("set bloom.radius"); // of the window
    const auto client = join();
    EXPECT_EQ(client->event("state")["mayUndo"], false);
    EXPECT_EQ(client->request({{"do", "undo"}})["ok"], false);
    EXPECT_EQ(client->request({{"do", "set"}, {"args", {"maxDepth", 3}}})["ok"], true);
    ASSERT_TRUE(mayUndo(*client));
    EXPECT_EQ(client->request({{"do", "undo"}})["ok"], true);
    EXPECT_EQ(server->commands(), (std::vector<std::string>{"set maxDepth 3", "undo 2"}));
}

TEST_F(Requests, UndoOnceHoweverOftenTheyAskAtOnce) {
    server->edit("set bloom.radius"); // of the window
    const auto client = join();
    EXPECT_FALSE(client->event("state").is_null());
    EXPECT_EQ(client->request({{"do", "set"}, {"args", {"maxDepth", 3}}})["ok"], true);
    ASSERT_TRUE(mayUndo(*client));
    for (int id = 100; id < 103; ++id) client->sendText(fmt::format(R"({{"id":{},"do":"undo"}})", id));
    int done = 0;
    for (int k = 0; k < 3; ++k) done += client->event("answer")["ok"] == true ? 1 : 0;
    EXPECT_EQ(done, 1);
    EXPECT_EQ(client->request({{"do", "walk"}})["ok"], true);
    EXPECT_EQ(server->commands(), (std::vector<std::string>{"set maxDepth 3", "undo 2", "walk"}));
}

TEST_F(Requests, ThatChangeNothingMakeNobodysEditOnesOwn) {
    server->edit("set bloom.radius"); // of the window
    const auto client = join();
    EXPECT_FALSE(client->event("state").is_null());
    EXPECT_EQ(client->request({{"do", "light"}, {"args", {3, "on"}}})["ok"], true);
    EXPECT_EQ(client->request({{"do", "undo"}})["ok"], false);
    std::this_thread::sleep_for(100ms); // the state is told
    server->edit("set maxDepth");
    for (json told; told["edits"] != 2;) {
        told = client->event("state");
        ASSERT_FALSE(told.is_null());
        EXPECT_EQ(told["mayUndo"], false);
    }
    EXPECT_EQ(client->request({{"do", "undo"}})["ok"], false);
    EXPECT_EQ(server->commands(), std::vector<std::string>{"light 3 on"});
}

// The other edit has the same name, and there are as many edits as before.
TEST_F(Requests, UndoNoEditThatAnotherClientMadeInItsPlace) {
    const auto client = join();
    EXPECT_FALSE(client->event("state").is_null());
    EXPECT_EQ(client->request({{"do", "set"}, {"args", {"maxDepth", 3}}})["ok"], true);
    ASSERT_TRUE(mayUndo(*client));
    server->undo();
    server->edit("set maxDepth");
    EXPECT_EQ(client->request({{"do", "undo"}})["ok"], false) << "before anybody was told";
    json told = client->event("state");
    while (!told.is_null() && told["mayUndo"] != false) told = client->event("state");
    EXPECT_FALSE(told.is_null());
    EXPECT_EQ(client->request({{"do", "undo"}})["ok"], false);
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
    for (const json& request :
         {json{{"do", "set"}, {"args", {"maxDepth", 3}}}, json{{"do", "light"}, {"args", {3, "off"}}},
          json{{"do", "undo"}}, json{{"do", "pause"}}, json{{"do", "part hide"}, {"args", {1}}},
          json{{"do", "resolution"}, {"args", {64, 64}}}})
        EXPECT_EQ(client->request(request)["ok"], false) << request;
    EXPECT_EQ(client->request({{"do", "fly"}})["ok"], true);
    EXPECT_EQ(server->commands(), std::vector<std::string>{"fly"});
}

TEST_F(LockedEdits, LetKeysMoveAndDoNothingElse) {
    const auto client = join();
    EXPECT_FALSE(client->event("state").is_null());
    EXPECT_TRUE(eventually([&] { // once the server has told what its keys do
        client->input({'W'});
        return server->isHeld('W');
    }));
    client->input({'W', 'B', '1', 'M', '2'}, 0, 0, {'B', '1', '2', 'F'});
    EXPECT_TRUE(eventually([&] { return server->presses('F') == 1; }));
    EXPECT_TRUE(server->isHeld('W'));
    for (const char key : {'B', '1', '2'}) EXPECT_EQ(server->presses(key), 0U) << key;
}

TEST_F(Requests, ThatMendHeavyFramesAreNotSetBack) {
    server->tellFrameSeconds(7); // by an edit of the window
    server->move(20);
    const auto client = join();
    EXPECT_FALSE(client->event("state").is_null());
    for (json status; status["frameMs"] != 7000;) {
        status = client->event("status");
        ASSERT_FALSE(status.is_null());
    }
    EXPECT_EQ(client->request({{"do", "set"}, {"args", {"antialiasing", 1}}})["ok"], true);
    std::this_thread::sleep_for(500ms);
    EXPECT_EQ(server->commands(), std::vector<std::string>{"set antialiasing 1"});
}

TEST_F(Requests, WhatMakesFramesLastForSecondsIsSetBack) {
    const auto client = join();
    EXPECT_FALSE(client->event("state").is_null());
    server->move(20);
    EXPECT_TRUE(eventually([&] { return server->published() > 4; }));
    server->hang();
    std::this_thread::sleep_for(200ms);
    for (const int value : {7, 8})
        EXPECT_EQ(client->request({{"do", "set"}, {"args", {"maxDepth", value}}})["ok"], true);
    EXPECT_EQ(client->request({{"do", "set"}, {"args", {"antialiasing", 4}}})["ok"], true);
    EXPECT_EQ(client->request({{"do", "resolution"}, {"args", {1600, 900}}})["ok"], true);
    json notice = client->event("notice", 8s);
    while (!notice.is_null() && notice["code"] != "heavy") notice = client->event("notice", 8s);
    ASSERT_FALSE(notice.is_null());
    EXPECT_EQ(notice["back"], (json{"antialiasing", "maxDepth", "size"}));
    ASSERT_TRUE(eventually([&] { return server->commands().size() == 7; })) << "four of the page, three back";
    const std::vector<std::string> commands = server->commands();
    const rtcore::RenderSettings before;
    EXPECT_EQ(commands[4], fmt::format("set antialiasing {}", before.antialiasing));
    EXPECT_EQ(commands[5], fmt::format("set maxDepth {}", before.maxDepth))
        << "the value from before the first";
    EXPECT_EQ(commands[6], fmt::format("resolution {} {}", before.width, before.height));
}

// The page is shown quick frames meanwhile, and it may walk for long before they are whole.
TEST_F(Requests, WhatMakesWholeFramesLastForSecondsIsSetBack) {
    const auto client = join();
    EXPECT_FALSE(client->event("state").is_null());
    server->move(20);
    server->tellFrameSeconds(0.1);
    EXPECT_EQ(client->request({{"do", "set"}, {"args", {"maxDepth", 60}}})["ok"], true);
    std::this_thread::sleep_for(1s);
    EXPECT_EQ(server->commands().size(), 1U);
    server->tellWholeSeconds(5.5);
    json notice = client->event("notice", 8s);
    while (!notice.is_null() && notice["code"] != "heavy") notice = client->event("notice", 8s);
    ASSERT_FALSE(notice.is_null());
    ASSERT_TRUE(eventually([&] { return server->commands().size() == 2; }));
    EXPECT_EQ(server->commands()[1], fmt::format("set maxDepth {}", rtcore::RenderSettings().maxDepth));
}

// It is not what another one makes heavy later.
TEST_F(Requests, WhatWasQuickAtRestStays) {
    const auto client = join();
    EXPECT_FALSE(client->event("state").is_null());
    EXPECT_EQ(client->request({{"do", "set"}, {"args", {"maxDepth", 3}}})["ok"], true);
    std::this_thread::sleep_for(1500ms);
    server->tellWholeSeconds(9);
    server->move(20);
    std::this_thread::sleep_for(500ms);
    EXPECT_EQ(server->commands(), std::vector<std::string>{"set maxDepth 3"});
}

/// How many of these the bridge has read. The last one of them may have ended the connection: then there is
/// no client.
std::size_t read(std::unique_ptr<WebClient>& client, std::span<const std::string> messages) {
    std::string bytes;
    for (const std::string& message : messages) bytes += message + webFrame(0x89, "heard");
    client->socket().write(bytes);
    for (std::size_t heard = 0; heard < messages.size();) {
        const auto frame = client->next(5s);
        if (!frame || frame->opcode == 8) {
            client.reset();
            return heard + 1;
        }
        if (frame->opcode == 10) ++heard;
    }
    return messages.size();
}

/// Messages that differ from good ones: in a few bytes, or in a few values.
class DamagedMessages {
    bool chance(unsigned oneOf) { return random_() % oneOf == 0; }
    template <class Values>
    const auto& one(const Values& values) {
        return values[random_() % std::size(values)];
    }

  public:
    std::string next() {
        std::string text = chance(8) ? withOtherBytes(one(samples_)) : withOtherValues(one(samples_));
        if (chance(100)) text.resize(random_() % 30);
        const bool binary = chance(50);
        if (binary && !text.empty()) text[0] = static_cast<char>(random_() % 6);
        return webFrame(binary ? 0x82 : 0x81, text);
    }
    /// As the first message of a connection.
    std::string hello() {
        json message = samples_.back();
        message["token"] = chance(2) ? "driver-driver-driver-driver" : "x";
        return webFrame(0x81, chance(4) ? withOtherBytes(message) : withOtherValues(message));
    }

  private:
    std::string withOtherBytes(const json& good) {
        std::string text = good.dump();
        for (auto k = random_() % 4; k > 0; --k)
            text[random_() % text.size()] =
                chance(2) ? static_cast<char>(32 + random_() % 95) : one(std::string_view("{}[]\",:\\0e-"));
        return text;
    }
    std::string withOtherValues(json message) {
        for (auto k = 1 + random_() % 3; k > 0 && !message.empty(); --k) {
            const std::string key =
                std::next(message.begin(), static_cast<int>(random_() % message.size())).key();
            if (key == "id" && !chance(20)) continue; // ends the connection
            json& value = message[key];
            if (chance(8)) {
                message.erase(key);
            } else if (value.is_array() && !value.empty() && chance(2)) {
                value[random_() % value.size()] = one(odd_);
            } else {
                value = one(odd_);
            }
        }
        return message.dump();
    }

    std::mt19937 random_{11};
    const std::vector<json> samples_{
        {{"id", 1}, {"do", "camera set"}, {"args", {0, 1, 2, 0, 0, -1, 60}}},
        {{"id", 2}, {"do", "set"}, {"args", {"maxDepth", 3}}},
        {{"id", 3}, {"do", "material set"}, {"args", {1, "diffuse", 1, 1, 1}}},
        {{"id", 4}, {"do", "ask"}},
        {{"id", 5}, {"do", "part hide"}, {"args", {1, 2, 3}}},
        {{"id", 6}, {"do", "light"}, {"args", {3, "off"}}},
        {{"id", 7}, {"do", "resolution"}, {"args", {64, 64}}},
        {{"do", "hello"}, {"v", 2}, {"token", "x"}, {"name", "n"}, {"view", {{"w", 64}, {"h", 48}}}}};
    const json odd_ = json::parse(
        R"([null, true, 0, -1, 3, 0.5, 1e300, -1e300, 5e-324, 2147483647, -2147483648, 4294967295,
            18446744073709551615, -9223372036854775808, "", "maxDepth", "diffuse", "a b", "a\nb",
            "../../etc/passwd", [], [1e300, "", null], [[1]], {}, ")" +
        std::string(3000, 'x') + R"("])");
};

/// So many messages that differ from good ones in a few places; RT_BRIDGE_FUZZ asks for more.
TEST_F(Requests, OfAnyBytesHarmNobody) {
    const int messages = asked("RT_BRIDGE_FUZZ", 10'000);
    DamagedMessages damaged;
    const auto honest = join(kViewer);
    std::unique_ptr<WebClient> client;
    std::vector<std::string> waiting;
    int done = 0, sent = 0;
    for (int told = 100'000; done < messages;) {
        while (waiting.size() < 20) waiting.push_back(damaged.next());
        if (!client || sent >= 200) { // below the limit of a burst
            WebClient(port).socket().write(damaged.hello() + damaged.next());
            client = join();
            sent = 0;
        }
        const std::size_t count = read(client, waiting);
        sent += static_cast<int>(count);
        done += static_cast<int>(count);
        waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(count));
        while (honest->next(0ms)) { // its pings are answered
        }
        if (done < told) continue;
        std::cout << done << " messages" << std::endl;
        told += 100'000;
    }
    EXPECT_FALSE(honest->request({{"do", "parts"}}, 10s).is_null()) << "the bridge serves on";
    client.reset();
    EXPECT_TRUE(eventually([&] { return visitors() == 1; }, 20s)) << visitors() << " are said to be there";
    for (const std::string& command : server->commands())
        EXPECT_TRUE(command.starts_with("camera ") || command.starts_with("set maxDepth") ||
                    command.starts_with("material set") || command.starts_with("part") ||
                    command.starts_with("light") || command.starts_with("resolution") ||
                    command.starts_with("also "))
            << command;
}

} // namespace

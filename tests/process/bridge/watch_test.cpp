// --watch and --quality, and what /status and /metrics say of a page that is there.
#include "process/bridge/bridge_fixture.h"

namespace {

using namespace test;

class Watched : public BridgeTest {
    void SetUp() override {
        startServer();
        startBridge({"--watch", "--quality=60"});
    }

  protected:
    std::string answerOf(const std::string& path) {
        const std::string answer = page(path, std::string("Authorization: Bearer ") + kViewer + "\r\n");
        return answer.substr(answer.find("\r\n\r\n") + 4);
    }
};

TEST_F(Watched, PrintsALineASecondOfEachServer) {
    const auto told = [&](const std::string& text) {
        return eventually([&] { return links().find(text) != std::string::npos; }, 10s);
    };
    EXPECT_TRUE(told(instance.name() + ": server there, 0 pages, no driver")) << links();
    const auto client = join(kDriver, "Anna");
    EXPECT_TRUE(told(instance.name() + ": server there, 1 page, driver Anna")) << links();
}

class Journal : public BridgeTest {
  protected:
    bool told(const std::string& text) {
        return eventually([&] { return links().find(text) != std::string::npos; }, 10s);
    }
};

TEST_F(Journal, TellsWhoComesAndWhoIsRefused) {
    const std::string room = "RTBridge: " + instance.name() + ": ";
    EXPECT_TRUE(told(room + "server there\n")) << links();
    join(kDriver, "An\u009bna");
    EXPECT_TRUE(told(room + "driver 1, Anna, came from 127.0.0.1\n")) << links();
    EXPECT_TRUE(told(room + "driver 1, Anna, left after 0 s\n")) << links();
    join(kViewer, "");
    EXPECT_TRUE(told(room + "viewer 2 came from 127.0.0.1\n")) << links();
    EXPECT_EQ(WebClient(port, "http://evil.example").status(), 403);
    EXPECT_TRUE(told("RTBridge: refused 127.0.0.1: origin\n")) << links();
    WebClient wrong(port);
    wrong.hello("no-token-of-this-bridge");
    EXPECT_TRUE(told("RTBridge: refused 127.0.0.1: token\n")) << links();
    server.reset();
    EXPECT_TRUE(told(room + "server gone\n")) << links();
    EXPECT_EQ(links().find("no-token"), std::string::npos);
}

TEST_F(Journal, HasTenLinesASecondAtMost) {
    EXPECT_TRUE(told("server there\n"));
    for (int i = 0; i < 100; ++i) WebClient(port, "http://evil.example");
    std::this_thread::sleep_for(300ms);
    WebClient(port, "http://evil.example");
    EXPECT_TRUE(told("lines before it were left out")) << links();
    const std::string text = links(), line = "refused 127.0.0.1";
    int lines = 0;
    for (std::size_t at = 0; (at = text.find(line, at)) != std::string::npos; ++at) ++lines;
    EXPECT_LT(lines, 60);
}

TEST_F(Watched, KeepsTheQualityThatIsAskedFor) {
    WebClient client(port);
    client.hello(kDriver);
    const nlohmann::json welcome = client.event("welcome");
    ASSERT_FALSE(welcome.is_null());
    EXPECT_EQ(welcome["rungs"][1]["quality"], 60);
    server->move(60);
    for (int i = 0; i < 3; ++i) {
        const nlohmann::json link = client.event("link");
        ASSERT_FALSE(link.is_null());
        EXPECT_EQ(link["quality"], 60);
        EXPECT_EQ(link["divide"], 1);
    }
}

TEST_F(Watched, TellsFiguresOfAPageThatWalks) {
    const auto client = join(kDriver, "Anna");
    server->move(60);
    client->input({'W'});
    for (int i = 0; i < 10; ++i) {
        const auto frame = client->binary(1);
        ASSERT_TRUE(frame);
        client->acknowledge(*frame);
    }
    const nlohmann::json told = nlohmann::json::parse(answerOf("/status"))["instances"][0];
    EXPECT_GE(told["encode"][1]["count"], 9);
    EXPECT_GE(told["inputToIpc"]["count"], 1);
    EXPECT_GE(told["publishToSocket"]["count"], 1);
    EXPECT_EQ(told["sessions"][0]["name"], "Anna");
    EXPECT_EQ(told["sessions"][0]["role"], "driver");
    EXPECT_GE(told["sessions"][0]["sent"], 9);
    const std::string metrics = answerOf("/metrics");
    EXPECT_NE(metrics.find("rtbridge_server_up{instance=\"" + instance.name() + "\"} 1\n"),
              std::string::npos);
    EXPECT_NE(metrics.find("rtbridge_sessions{instance=\"" + instance.name() + "\",role=\"driver\"} 1\n"),
              std::string::npos);
}

} // namespace

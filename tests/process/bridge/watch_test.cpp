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

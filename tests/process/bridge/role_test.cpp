// Who drives, and which keys are down for how long.
#include "process/bridge/bridge_fixture.h"

namespace {

using namespace test;

class Driving : public BridgeTest {};
class Roles : public BridgeTest {};

TEST_F(Driving, HoldsKeysForAsLongAsThePageSaysSo) {
    const auto client = join();
    for (int i = 0; i < 8; ++i) {
        client->input({'W'});
        EXPECT_TRUE(eventually([&] { return server->isHeld('W'); }));
        std::this_thread::sleep_for(100ms);
    }
    client->input({});
    EXPECT_TRUE(eventually([&] { return !server->anyHeld(); }));
}

TEST_F(Driving, ReleasesKeysWhenTheHeartbeatStops) {
    const auto client = join();
    client->input({'W', 132});
    ASSERT_TRUE(eventually([&] { return server->isHeld('W') && server->isHeld(132); }));
    EXPECT_TRUE(eventually([&] { return !server->anyHeld(); }, 3s));
    EXPECT_EQ(client->event("notice")["code"], "handed");
    EXPECT_EQ(client->event("notice")["code"], "released");
}

TEST_F(Driving, ReleasesKeysWhenThePageIsGone) {
    auto client = join();
    client->input({'W'});
    ASSERT_TRUE(eventually([&] { return server->isHeld('W'); }));
    client.reset();
    EXPECT_TRUE(eventually([&] { return !server->anyHeld(); }, 3s));
}

TEST_F(Driving, ReleasesKeysWhenTheBridgeIsKilled) {
    const auto client = join();
    client->input({'W'});
    ASSERT_TRUE(eventually([&] { return server->isHeld('W'); }));
    bridge.kill();
    EXPECT_TRUE(eventually([&] { return !server->anyHeld(); }, 3s));
}

TEST_F(Driving, TapsAndTurns) {
    const auto client = join();
    client->input({}, 1500, -250, {' '});
    EXPECT_TRUE(eventually([&] { return server->presses(' ') == 1; }));
    EXPECT_TRUE(eventually([&] { return !server->isHeld(' '); }));
    EXPECT_TRUE(
        eventually([&] { return server->commands() == std::vector<std::string>{"camera turn 1.5 -0.25"}; }));
}

TEST_F(Driving, IsForTheDriverAlone) {
    const auto driver = join(), viewer = join(kViewer), second = join();
    viewer->input({'W'}, 1000, 0, {' '});
    second->input({'S'}, 1000, 0, {' '});
    driver->input({'A'});
    EXPECT_TRUE(eventually([&] { return server->isHeld('A'); }));
    EXPECT_FALSE(server->isHeld('W') || server->isHeld('S'));
    EXPECT_EQ(server->presses(' '), 0U);
    EXPECT_TRUE(server->commands().empty());
}

TEST_F(Roles, GoToTheFirstAndAreToldToAll) {
    const auto first = join(kDriver, "Anna");
    const auto second = join(kViewer, "B\nen");
    const auto roles = second->event("roles");
    EXPECT_EQ(roles["people"].size(), 2U);
    EXPECT_EQ(roles["driver"], roles["people"][0]["id"]);
    EXPECT_EQ(roles["people"][0]["name"], "Anna");
    EXPECT_EQ(roles["people"][1]["name"], "Ben");
    EXPECT_EQ(roles["people"][1]["mayDrive"], false);
}

/// Also what it asks for at once, while the last one's requests are given up.
TEST_F(Roles, GoToTheNextPageAfterTheLast) {
    for (int i = 0; i < 100; ++i) {
        const auto client = join();
        const nlohmann::json answer = client->request({{"do", "walk"}});
        ASSERT_EQ(answer["ok"], true) << i << ": " << answer;
        client->socket().write(webFrame(0x88, ""));
        client->closeCode();
    }
}

TEST_F(Roles, AreHandedOverWithoutStuckKeys) {
    const auto first = join(kDriver, "Anna"), second = join(kDriver, "Ben");
    first->input({'W'});
    ASSERT_TRUE(eventually([&] { return server->isHeld('W'); }));
    EXPECT_EQ(second->request({{"do", "ask"}})["ok"], true);
    nlohmann::json asked = first->event("notice");
    while (!asked.is_null() && asked["code"] != "asked") asked = first->event("notice");
    ASSERT_FALSE(asked.is_null());
    EXPECT_EQ(first->request({{"do", "give"}, {"to", asked["by"]}})["ok"], true);
    EXPECT_TRUE(eventually([&] { return !server->anyHeld(); }));
    second->input({'S'});
    EXPECT_TRUE(eventually([&] { return server->isHeld('S'); }));
    first->input({'W'});
    EXPECT_FALSE(eventually([&] { return server->isHeld('W'); }, 200ms));
}

// One who drives and does nothing is told what a window or CUI does; one that moves the view is not.
TEST_F(Roles, AreToldThatAnotherClientMovesTheCamera) {
    const auto driver = join();
    driver->input({'W'});
    server->move(50);
    const auto told = [&](std::chrono::milliseconds within) {
        bool odd = false; // each frame takes another time, by which they are told apart
        for (const auto end = Clock::now() + within; Clock::now() < end; odd = !odd) {
            server->tellFrameSeconds(odd ? 0.02 : 0.021);
            const nlohmann::json notice = driver->event("notice", 50ms);
            if (!notice.is_null() && notice["code"] == "elsewhere") return true;
        }
        return false;
    };
    EXPECT_FALSE(told(300ms)) << "of its own movement";
    driver->input({});
    EXPECT_TRUE(told(20s));
}

TEST_F(Roles, ViewersNeverGet) {
    const auto viewer = join(kViewer);
    EXPECT_EQ(viewer->request({{"do", "ask"}})["ok"], false);
    EXPECT_EQ(viewer->request({{"do", "walk"}})["ok"], false);
    const auto driver = join();
    EXPECT_EQ(driver->request({{"do", "give"}, {"to", 1}})["ok"], false);
    EXPECT_TRUE(server->commands().empty());
}

class ViewOnly : public BridgeTest {
    void SetUp() override {
        startServer();
        startBridge({"--view-only"});
    }
};

TEST_F(ViewOnly, HasNoLinkForDrivers) {
    EXPECT_EQ(links().find("Driver"), std::string::npos);
    WebClient client(port);
    client.hello(kDriver);
    EXPECT_EQ(client.closeCode(), 4003);
    EXPECT_EQ(join(kViewer)->request({{"do", "walk"}})["ok"], false);
}

} // namespace

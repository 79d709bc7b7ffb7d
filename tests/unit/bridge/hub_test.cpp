// The rooms of all instances: who comes in by which token, how many, and what is told of them.
#include "bridge/hub.h"

#include "unit/bridge/room_world.h"

#include <gtest/gtest.h>

namespace {

using bridge::CloseCode;
using bridge::ServerLink;
using nlohmann::json;
using test::PageOutlet;

constexpr const char* kViewerToken = "viewer-viewer-viewer-viewer";

class HubOfRooms : public testing::Test {
  protected:
    /// The two ends of a WebSocket.
    struct Connection {
        std::shared_ptr<PageOutlet> page;
        std::shared_ptr<bridge::Receiver> receiver;
        void hello(const std::string& token, const std::string& instance = "") const {
            receiver->text(
                json{{"do", "hello"}, {"v", bridge::kPageVersion}, {"token", token}, {"instance", instance}}
                    .dump());
        }
        bool isWelcome() const { return page->count("welcome") == 1; }
    };
    HubOfRooms() {
        options.instances = {"hall", "cellar"};
        options.clients = 3;
    }
    Connection connect(const std::string& address = "127.0.0.1") {
        Connection made{std::make_shared<PageOutlet>(), nullptr};
        made.page->from = address;
        made.receiver = hub().opened(made.page);
        return made;
    }
    Connection enter(const std::string& token = kViewerToken, const std::string& instance = "") {
        Connection made = connect();
        made.hello(token, instance);
        return made;
    }
    bridge::Hub& hub() {
        if (!hub_)
            hub_ =
                std::make_unique<bridge::Hub>(options, tokens, world.services(),
                                              [this](const std::string& driver) { links.push_back(driver); });
        return *hub_;
    }
    bridge::HttpAnswer get(const std::string& path, const std::string& bearer = kViewerToken) {
        return hub().answer(path, bearer, "127.0.0.1");
    }
    json status() { return json::parse(get("/status").body); }

    test::RoomWorld world;
    bridge::BridgeOptions options;
    bridge::Tokens tokens{"driver-driver-driver-driver", kViewerToken, false};
    std::vector<std::string> links; ///< of drivers, as they were told

  private:
    std::unique_ptr<bridge::Hub> hub_;
};

TEST_F(HubOfRooms, WelcomesByALink) {
    const Connection viewer = enter();
    ASSERT_TRUE(viewer.isWelcome());
    const json welcome = viewer.page->last("welcome");
    EXPECT_EQ(welcome["instance"], "hall") << "the first where none is named";
    EXPECT_EQ(welcome["instances"], (json{"hall", "cellar"}));
    EXPECT_EQ(welcome["mayDrive"], false);
    EXPECT_EQ(welcome["v"], bridge::kPageVersion);
    for (const char* table : {"settings", "commands", "lightKinds", "rungs", "limits"})
        EXPECT_FALSE(welcome[table].empty()) << table;
    EXPECT_FALSE(welcome.contains("token")) << "the viewers' link stays good";
    EXPECT_TRUE(links.empty());
}

TEST_F(HubOfRooms, LeadsToTheInstanceThatIsNamed) {
    EXPECT_EQ(enter(kViewerToken, "cellar").page->last("welcome")["instance"], "cellar");
    EXPECT_TRUE(world.servers["cellar"].anyone);
    EXPECT_FALSE(world.servers["hall"].anyone);
    const Connection lost = enter(kViewerToken, "attic");
    EXPECT_EQ(lost.page->closeCode, CloseCode::NoInstance);
    EXPECT_EQ(lost.page->closeReason, "hall cellar");
}

TEST_F(HubOfRooms, LetsOnePageInByADriversLink) {
    const Connection driver = enter(tokens.driver);
    ASSERT_TRUE(driver.isWelcome());
    ASSERT_EQ(links.size(), 1U) << "the next one is told";
    EXPECT_NE(links[0], tokens.driver);
    EXPECT_EQ(enter(tokens.driver).page->closeCode, CloseCode::UsedLink);
    const std::string own = driver.page->last("welcome")["token"];
    driver.receiver->leaves();
    driver.receiver->closed();
    const Connection again = enter(own);
    EXPECT_TRUE(again.isWelcome()) << "the page is loaded again";
    again.receiver->leaves();
    again.receiver->closed();
    world.clock.pass(61);
    EXPECT_EQ(enter(own).page->closeCode, CloseCode::BadToken) << "a minute later it is over";
    EXPECT_TRUE(enter(links[0]).isWelcome());
}

TEST_F(HubOfRooms, GivesEachPageANumberOfItsOwn) {
    const Connection first = enter(), second = enter(kViewerToken, "cellar");
    EXPECT_NE(first.page->last("welcome")["you"], second.page->last("welcome")["you"]);
}

TEST_F(HubOfRooms, HasPlacesForSoMany) {
    const Connection pages[] = {enter(), enter()};
    EXPECT_TRUE(hub().enters());
    const Connection third = enter();
    EXPECT_FALSE(hub().enters()) << "all are in rooms";
    third.receiver->closed();
    EXPECT_TRUE(hub().enters());
}

TEST_F(HubOfRooms, GivesThePlaceOfASilentOneToTheNext) {
    const Connection page = enter(), other = enter(), silent = connect();
    EXPECT_TRUE(hub().enters());
    EXPECT_TRUE(silent.page->dropped);
    EXPECT_FALSE(page.page->dropped || other.page->dropped);
}

TEST_F(HubOfRooms, PushesOutTheAddressThatHasMost) {
    const Connection first = connect("10.0.0.1"), second = connect("10.0.0.2"), third = connect("10.0.0.2");
    EXPECT_TRUE(hub().enters());
    EXPECT_FALSE(first.page->dropped);
    EXPECT_TRUE(second.page->dropped || third.page->dropped);
}

TEST_F(HubOfRooms, ClosesTheSilentAfterFiveSeconds) {
    const Connection page = enter(), silent = connect();
    world.clock.pass(5.1);
    hub().tick();
    EXPECT_EQ(silent.page->closeCode, CloseCode::NoHello);
    EXPECT_FALSE(page.page->closeCode);
}

TEST_F(HubOfRooms, ClosesAllWhenLinksAreRenewed) {
    const Connection page = enter(), newcomer = connect();
    hub().renew({"another-another-another-1", "another-another-another-2", false});
    EXPECT_EQ(page.page->closeCode, CloseCode::BadToken);
    EXPECT_EQ(newcomer.page->closeCode, CloseCode::BadToken);
    EXPECT_EQ(enter().page->closeCode, CloseCode::BadToken) << "the old link";
    EXPECT_TRUE(enter("another-another-another-2").isWelcome());
}

TEST_F(HubOfRooms, TellsAllThatItEnds) {
    const Connection page = enter();
    hub().end();
    EXPECT_EQ(page.page->closeCode, CloseCode::GoingAway);
}

TEST_F(HubOfRooms, IsHealthyWithAnyServer) {
    EXPECT_EQ(get("/health", "").status, 503);
    world.servers["cellar"].events.server(ServerLink::There, "");
    EXPECT_EQ(get("/health", "").status, 200);
}

TEST_F(HubOfRooms, TellsFiguresToThoseWithAToken) {
    const Connection page = enter(kViewerToken, "cellar");
    EXPECT_EQ(get("/status", "").status, 401);
    EXPECT_EQ(get("/metrics", "wrong").status, 401);
    enter("wrong");
    const json told = status();
    EXPECT_EQ(told["clients"], 2) << "the refused one is not closed yet";
    EXPECT_EQ(told["refused"]["token"], 2);
    EXPECT_EQ(told["instances"].size(), 2U);
    EXPECT_EQ(get("/metrics").status, 200);
    EXPECT_NE(get("/metrics").body.find("instance=\"cellar\""), std::string::npos);
    EXPECT_EQ(get("/elsewhere").status, bridge::HttpAnswer().status);
    EXPECT_NE(hub().watchLines().find("cellar: server unknown, 1 page, no driver"), std::string::npos);
}

TEST_F(HubOfRooms, NotesHowServersAre) {
    hub().tick();
    EXPECT_TRUE(world.notes.empty());
    world.servers["hall"].events.server(ServerLink::There, "");
    hub().tick();
    hub().tick();
    EXPECT_EQ(world.notes, std::vector<std::string>{"hall: server there"});
    world.servers["hall"].events.server(ServerLink::Gone, "");
    hub().tick();
    EXPECT_EQ(world.notes.back(), "hall: server gone");
}

} // namespace

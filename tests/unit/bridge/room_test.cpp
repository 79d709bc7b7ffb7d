// Who is in a room, who drives it, and what all are told.
#include "bridge/room/room.h"

#include "unit/bridge/room_world.h"

#include <gtest/gtest.h>

namespace {

using bridge::CloseCode;
using bridge::ServerLink;
using bridge::SessionId;
using nlohmann::json;
using test::PageOutlet;
using Page = std::shared_ptr<PageOutlet>;
using EventNames = std::vector<std::string>;

constexpr const char* kInstance = "hall";

class RoomOfPages : public testing::Test {
  protected:
    explicit RoomOfPages(const bridge::Limits& max = {}) : limits(max) {}
    Page join(SessionId id, const std::string& name = "", bool mayDrive = true) {
        auto page = std::make_shared<PageOutlet>();
        room->join({id, name, mayDrive, {}, page, {{"event", "welcome"}}});
        return page;
    }
    void request(SessionId by, json content) {
        content["id"] = 9;
        room->text(by, content.dump());
    }
    void input(SessionId by, const std::vector<std::uint8_t>& held, int right = 0,
               const std::vector<std::uint8_t>& taps = {}) {
        std::vector<std::uint8_t> bytes(16);
        bytes[0] = 2;
        bytes[1] = static_cast<std::uint8_t>(held.size());
        bytes[2] = static_cast<std::uint8_t>(taps.size());
        bytes[4] = ++sequence_;
        bytes[8] = static_cast<std::uint8_t>(right & 0xff);
        bytes[9] = static_cast<std::uint8_t>(right >> 8);
        bytes.insert(bytes.end(), held.begin(), held.end());
        bytes.insert(bytes.end(), taps.begin(), taps.end());
        room->binary(by, bytes);
    }
    /// Ticks for so long.
    void pass(double seconds) {
        for (double t = 0; t < seconds; t += 0.05) {
            world.clock.pass(0.05);
            room->tick();
        }
    }
    test::PlayedServer& server() { return world.servers[kInstance]; }

    test::RoomWorld world;
    bridge::Limits limits;
    std::unique_ptr<bridge::Room> room =
        std::make_unique<bridge::Room>(kInstance, limits, bridge::StreamOptions(), world.services());

  private:
    std::uint8_t sequence_ = 0;
};

TEST_F(RoomOfPages, WelcomesFirstAndThenTellsAllThatIsKnown) {
    server().events.server(ServerLink::There, "");
    server().events.state(test::stateReport());
    ipc::Status status;
    status.width = 320;
    server().events.status(status);
    const Page page = join(1);
    EXPECT_EQ(page->names(), (EventNames{"welcome", "handed", "roles", "server", "state", "status"}));
    EXPECT_EQ(page->last("server")["state"], "there");
    EXPECT_EQ(page->last("state")["scene"], "hall.scn");
    EXPECT_GT(server().refreshes, 0) << "what is known may be old";
}

TEST_F(RoomOfPages, IsDrivenByTheFirstThatMay) {
    const Page viewer = join(1, "Anna", false), driver = join(2, "Ben"), second = join(3, "Carl");
    EXPECT_EQ(viewer->last("welcome")["role"], "viewer");
    EXPECT_EQ(driver->last("welcome")["role"], "driver");
    EXPECT_EQ(second->last("welcome")["role"], "viewer");
    for (const Page& page : {viewer, driver, second}) {
        EXPECT_EQ(page->last("roles")["driver"], 2);
        EXPECT_EQ(page->last("roles")["people"].size(), 3U);
    }
    EXPECT_EQ(driver->count("handed"), 1U);
    EXPECT_EQ(viewer->count("handed") + second->count("handed"), 0U);
}

TEST_F(RoomOfPages, HandsDrivingOverAndTellsBoth) {
    const Page anna = join(1, "Anna"), ben = join(2, "Ben");
    request(2, {{"do", "ask"}});
    EXPECT_EQ(ben->last("answer")["ok"], true);
    EXPECT_EQ(anna->last("asked")["by"], 2);
    EXPECT_EQ(anna->last("asked")["text"], "Ben asks to drive");
    input(1, {'W'});
    request(1, {{"do", "give"}, {"to", 2}});
    EXPECT_EQ(anna->last("answer")["ok"], true);
    EXPECT_EQ(anna->count("taken"), 1U);
    EXPECT_EQ(ben->count("handed"), 1U);
    EXPECT_TRUE(server().keys.none()) << "no key stays down";
    room->tick();
    EXPECT_EQ(anna->last("roles")["driver"], 2);
    input(1, {'W'});
    EXPECT_TRUE(server().keys.none()) << "who drove before does not any more";
}

TEST_F(RoomOfPages, GivesDrivingToWhoAsksWithoutAnAnswer) {
    const Page anna = join(1, "Anna"), ben = join(2, "Ben");
    request(2, {{"do", "ask"}});
    pass(9);
    EXPECT_EQ(ben->count("handed"), 0U);
    pass(2);
    EXPECT_EQ(ben->count("handed"), 1U);
    EXPECT_EQ(anna->count("taken"), 1U);
}

TEST_F(RoomOfPages, RefusesWhatOnlyADriverMay) {
    join(1, "Anna");
    const Page viewer = join(2, "Ben", false);
    for (const json& content : {json{{"do", "ask"}}, json{{"do", "give"}, {"to", 2}}, json{{"do", "give"}},
                                json{{"do", "keep"}}, json{{"do", "release"}}, json{{"do", "walk"}}}) {
        request(2, content);
        EXPECT_EQ(viewer->last("answer")["ok"], false) << content;
        world.clock.pass(1);
    }
    EXPECT_TRUE(server().requests.empty());
}

TEST_F(RoomOfPages, TellsNewNamesToAll) {
    const Page anna = join(1), ben = join(2, "", false);
    request(2, {{"do", "name"}, {"name", "B\nen"}});
    room->tick();
    EXPECT_EQ(anna->last("roles")["people"][1]["name"], "Ben");
    request(2, {{"do", "name"}, {"name", 7}});
    EXPECT_EQ(ben->last("answer")["ok"], false);
}

TEST_F(RoomOfPages, TellsManyChangesOfRolesAsOne) {
    const Page anna = join(1), ben = join(2);
    const std::size_t before = ben->count("roles");
    for (int i = 0; i < 3; ++i) request(1, {{"do", "name"}, {"name", "A"}});
    EXPECT_EQ(ben->count("roles"), before);
    room->tick();
    EXPECT_EQ(ben->count("roles"), before + 1);
}

TEST_F(RoomOfPages, AnswersFewRequestsAtOnceItself) {
    const Page page = join(1);
    for (int i = 0; i < 9; ++i) request(1, {{"do", "keep"}});
    EXPECT_EQ(page->last("answer")["text"], "too many requests at once");
    world.clock.pass(1);
    request(1, {{"do", "keep"}});
    EXPECT_EQ(page->last("answer")["ok"], true);
}

TEST_F(RoomOfPages, LetsKeysGoWhenTheDriverLeaves) {
    join(1);
    const Page next = join(2);
    request(2, {{"do", "ask"}});
    input(1, {'W'});
    EXPECT_TRUE(server().keys['W']);
    room->leave(1);
    EXPECT_TRUE(server().keys.none());
    EXPECT_EQ(next->count("handed"), 1U);
    EXPECT_TRUE(server().anyone);
    room->leave(2);
    EXPECT_FALSE(server().anyone) << "the server's slot is left to others";
    EXPECT_FALSE(server().demand.anyone);
}

TEST_F(RoomOfPages, GivesKeysTapsAndTurnsOfTheDriverToTheServer) {
    join(1);
    join(2);
    input(1, {'W', 132}, 1500, {' '});
    input(2, {'S'}, 1000, {'F'});
    bridge::KeySet both;
    both.set('W').set(132);
    EXPECT_EQ(server().keys, both);
    EXPECT_EQ(server().taps, std::vector<std::uint8_t>{' '});
    EXPECT_DOUBLE_EQ(server().right, 1.5);
}

TEST_F(RoomOfPages, LetsKeysGoWhenTheHeartbeatStops) {
    const Page page = join(1);
    input(1, {'W'});
    pass(0.4);
    EXPECT_TRUE(server().keys['W']);
    input(1, {'W'});
    pass(0.4);
    EXPECT_TRUE(server().keys['W']);
    pass(0.2);
    EXPECT_TRUE(server().keys.none());
    EXPECT_EQ(page->count("released"), 1U);
    pass(2);
    EXPECT_EQ(page->count("released"), 1U);
}

TEST_F(RoomOfPages, TellsTheDriverThatAnotherClientMovesTheCamera) {
    const Page driver = join(1), viewer = join(2);
    ipc::Status status;
    status.idle = 1;
    const auto move = [&] {
        status.eye[0] += 1;
        status.frameSeconds += 1e-6;
        world.clock.pass(0.1);
        server().events.status(status);
    };
    server().events.status(status);
    for (int i = 0; i < 6; ++i) { // changes from before the page are not its own for ever
        status.frameSeconds += 1e-6;
        server().events.status(status);
    }
    move();
    EXPECT_EQ(driver->count("elsewhere"), 1U);
    move();
    EXPECT_EQ(driver->count("elsewhere"), 1U) << "once in 10 s";
    EXPECT_EQ(viewer->count("elsewhere"), 0U);
    world.clock.pass(11);
    input(1, {'W'});
    move();
    EXPECT_EQ(driver->count("elsewhere"), 1U) << "that is its own movement";
}

TEST_F(RoomOfPages, SendsTheStatusTwiceASecondWhereItChanged) {
    const Page page = join(1);
    ipc::Status status;
    status.width = 320;
    server().events.status(status);
    pass(0.1);
    EXPECT_EQ(page->count("status"), 1U);
    pass(2);
    EXPECT_EQ(page->count("status"), 1U);
    for (int i = 0; i < 10; ++i) {
        ++status.width;
        server().events.status(status);
        pass(0.1);
    }
    EXPECT_GE(page->count("status"), 3U);
    EXPECT_LE(page->count("status"), 4U);
}

TEST_F(RoomOfPages, SendsOfTheStateWhatChanged) {
    const Page page = join(1);
    server().events.state(test::stateReport());
    ASSERT_EQ(page->count("state"), 1U);
    EXPECT_TRUE(page->last("state").contains("values"));
    server().events.state(test::stateReport());
    EXPECT_EQ(page->count("state"), 1U);
    server().events.state(test::stateReport({4, 1}));
    ASSERT_EQ(page->count("state"), 2U);
    EXPECT_FALSE(page->last("state").contains("values"));
    EXPECT_EQ(page->last("state")["mayUndo"], true);
    request(1, {{"do", "state"}});
    EXPECT_TRUE(page->last("state").contains("values")) << "all of it";
    server().events.state("rubbish");
    EXPECT_EQ(page->count("state"), 3U);
}

TEST_F(RoomOfPages, PassesMessagesOfTheServerOn) {
    const Page page = join(1), other = join(2, "", false);
    server().events.messages("3 warning /secret/folder/room.obj: a texture is missing\n4 event light 2 off\n",
                             R"(["{0}: {1}","/secret/folder/room.obj",["a texture is missing"]])"
                             "\n"
                             R"(["light {0} off","2"])");
    EXPECT_EQ(page->count("message"), 2U);
    EXPECT_EQ(other->count("message"), 2U);
    EXPECT_EQ(page->events[page->events.size() - 2].dump().find("secret"), std::string::npos);
    EXPECT_EQ(page->events.back()["sentence"].dump(), R"(["light {0} off","2"])");
}

TEST_F(RoomOfPages, ForgetsAServerThatIsGone) {
    EXPECT_FALSE(room->server());
    const Page page = join(1);
    server().events.server(ServerLink::There, "");
    server().events.state(test::stateReport());
    server().events.status({});
    EXPECT_TRUE(room->hasServer());
    server().events.server(ServerLink::Gone, rtcore::say("no server '{0}' runs", std::string("hall")));
    EXPECT_FALSE(room->hasServer());
    EXPECT_EQ(page->last("server")["state"], "gone");
    EXPECT_EQ(page->last("server")["text"], "no server 'hall' runs");
    EXPECT_EQ(page->last("server")["sentence"], (json{"no server '{0}' runs", "hall"}));
    const Page late = join(2);
    EXPECT_EQ(late->count("state") + late->count("status"), 0U);
    request(1, {{"do", "state"}});
    EXPECT_EQ(page->last("answer")["ok"], false);
    request(1, {{"do", "walk"}});
    EXPECT_EQ(page->last("answer")["text"], "there is no server");
}

TEST_F(RoomOfPages, AnswersRequestsWhenTheServerDoes) {
    const Page page = join(1);
    request(1, {{"do", "walk"}});
    EXPECT_EQ(server().lines(), EventNames{"walk"});
    EXPECT_EQ(page->count("answer"), 0U);
    server().answer(0);
    EXPECT_EQ(page->last("answer")["ok"], true);
    EXPECT_EQ(page->last("answer")["id"], 9);
}

TEST_F(RoomOfPages, SendsFramesAndEchoes) {
    const Page page = join(1);
    server().frames.deliver(test::frameSet(1));
    ASSERT_EQ(page->binaries.size(), 1U);
    EXPECT_EQ(page->binaries[0].number(), 1U);
    room->binary(1, std::vector<std::uint8_t>{5, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 0, 0, 0, 0});
    ASSERT_EQ(page->binaries.size(), 2U);
    EXPECT_EQ(page->binaries[1].field(8), 0x04030201U);
    room->binary(1, std::vector<std::uint8_t>{3, 0, 255, 0, 0, 0, 0, 0});
    EXPECT_FALSE(server().demand.anyone) << "the page is hidden";
    room->binary(1, std::vector<std::uint8_t>{3, 1, 255, 0, 0, 0, 0, 0});
    EXPECT_EQ(server().demand.above[bridge::kFirstRung], 1U);
}

TEST_F(RoomOfPages, NotesWhyThereAreNoFrames) {
    server().frames.failed("all slots are taken");
    EXPECT_EQ(world.notes, EventNames{"hall: no frames: all slots are taken"});
}

TEST_F(RoomOfPages, ClosesOnMessagesOfNoProtocol) {
    SessionId id = 0;
    for (const char* text : {"", "x", "1", "[]", R"({"do":"walk"})", R"({"do":"walk","id":-1})",
                             R"({"do":"walk","id":1e99})", R"({"do":"walk","id":"1"})"}) {
        const Page page = join(++id);
        room->text(id, text);
        EXPECT_EQ(page->closeCode, CloseCode::BadMessage) << text;
    }
    const Page page = join(++id);
    room->binary(id, std::vector<std::uint8_t>{77, 1, 2});
    EXPECT_EQ(page->closeCode, CloseCode::BadMessage);
    EXPECT_TRUE(server().requests.empty());
}

TEST_F(RoomOfPages, ReadsNothingThatIsNestedDeeply) {
    std::string deep = R"({"do":"walk"})";
    for (int i = 0; i < 20; ++i) deep = "[" + deep + "]";
    const Page page = join(1);
    room->text(1, R"({"id":9,"do":)" + deep + "}");
    EXPECT_EQ(page->last("answer")["ok"], false);
    EXPECT_FALSE(page->closeCode);
}

TEST_F(RoomOfPages, TellsItsFigures) {
    join(1, "Anna");
    join(2, "Ben", false);
    server().events.server(ServerLink::Busy, "");
    server().frames.deliver(test::frameSet(1));
    world.clock.pass(3);
    const bridge::RoomFigures figures = room->figures();
    EXPECT_EQ(figures.instance, kInstance);
    EXPECT_EQ(figures.state, "busy");
    EXPECT_TRUE(figures.hasServer);
    ASSERT_EQ(figures.sessions.size(), 2U);
    EXPECT_EQ(figures.sessions[0].name, "Anna");
    EXPECT_TRUE(figures.sessions[0].drives);
    EXPECT_FALSE(figures.sessions[1].drives);
    EXPECT_NEAR(figures.sessions[1].seconds, 3, 1e-6);
    EXPECT_EQ(figures.sessions[1].sent, 1U);
}

TEST_F(RoomOfPages, IsTouchedByNothingThatComesAfterItsEnd) {
    const Page page = join(1);
    request(1, {{"do", "walk"}});
    world.keepsPosted = true;
    server().events.server(ServerLink::Gone, "");
    server().frames.deliver(test::frameSet(1));
    server().answer(0);
    room.reset();
    server().events.status({}); // a thread's last word
    const std::size_t before = page->events.size();
    ASSERT_EQ(world.posted.size(), 4U);
    for (const auto& work : world.posted) work();
    EXPECT_EQ(page->events.size(), before);
}

class RoomWithLockedEdits : public RoomOfPages {
  protected:
    RoomWithLockedEdits() : RoomOfPages(bridge::Limits{.locked = {"edits"}}) {}
};

TEST_F(RoomWithLockedEdits, LetsKeysThroughOnceItKnowsWhatTheyDo) {
    EXPECT_EQ(server().restraint, app::KeyRestraint::Edits);
    join(1);
    input(1, {'W'});
    EXPECT_TRUE(server().keys.none());
    server().events.bindings("W forward\nF toggleWalk\nB toggleBloom");
    input(1, {'W', 'B'}, 0, {'B', 'F'});
    EXPECT_TRUE(server().keys['W']);
    EXPECT_FALSE(server().keys['B']);
    EXPECT_EQ(server().taps, std::vector<std::uint8_t>{'F'});
    server().events.server(ServerLink::Gone, "");
    input(1, {'W'});
    EXPECT_TRUE(server().keys.none()) << "another server may have other keys";
}

} // namespace

// When an image by paths is begun, what is asked for it, and when it is out of date.
#include "unit/bridge/room_world.h"

#include "bridge/room/room.h"

#include <gtest/gtest.h>

#include <utility>

namespace {

using test::PageOutlet;

class RestingViews : public testing::Test {
  protected:
    RestingViews() {
        world.byPaths = true;
        room = std::make_unique<bridge::Room>("hall", limits, bridge::StreamOptions{}, world.services());
        server().events.server(bridge::ServerLink::There, "");
        told = std::exchange(server().requests, {});
        page = std::make_shared<PageOutlet>();
        room->join({1, "Anna", true, {.visible = true}, page, {{"event", "welcome"}}});
    }
    test::PlayedServer& server() { return world.servers["hall"]; }
    std::vector<std::string>& asked() { return world.renderer.requests; }
    void status(float eye, bool idle = true, std::uint64_t revision = 1) {
        ipc::Status status;
        status.width = 64;
        status.height = 48;
        status.progress = 1;
        status.eye[0] = eye;
        status.parallelWidth = parallelWidth;
        status.idle = idle ? 1 : 0;
        status.imageRevision = revision;
        status.stateRevision = ++states_;
        server().events.status(status);
    }
    void pass(double seconds) {
        for (double passed = 0; passed < seconds; passed += 0.05) {
            world.clock.pass(0.05);
            room->tick();
        }
    }
    /// Does what the room asked the server for.
    void exportAll(ipc::ReplyStatus result = ipc::ReplyStatus::Done) {
        for (std::size_t i = answered_; i < server().requests.size(); ++i) server().answer(i, "full", result);
        answered_ = server().requests.size();
    }
    /// From a view that rests to an image that is asked for.
    void begin(float eye = 1) {
        status(eye);
        pass(0.3);
        exportAll();
    }
    std::uint64_t run() { return server().preview ? server().preview->run : 0; }
    void progressed(double part, std::uint32_t samples, float error = -1) {
        server().frames.preview({run(), part, part >= 1, samples, error, 9 * error});
    }

    test::RoomWorld world;
    bridge::Limits limits;
    std::unique_ptr<bridge::Room> room;
    std::shared_ptr<PageOutlet> page;
    float parallelWidth = 0;
    std::vector<test::PlayedServer::Request> told; ///< what a server is asked for when it is found

  private:
    std::size_t answered_ = 0;
    std::uint64_t states_ = 0;
};

TEST_F(RestingViews, NeedNoLightThatTheServerLearnsForThemAlone) {
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].line, "rest-light walk");
}

TEST_F(RestingViews, AreRenderedAQuarterOfASecondAfterTheLastMovement) {
    status(1);
    pass(0.2);
    status(2);
    pass(0.2);
    EXPECT_TRUE(server().requests.empty());
    pass(0.1);
    ASSERT_EQ(server().requests.size(), 2U);
    EXPECT_TRUE(server().requests[0].line.starts_with("export scene /files/"));
    EXPECT_TRUE(server().requests[1].line.starts_with("export camera /files/"));
    EXPECT_TRUE(asked().empty()) << "not before its files are written";
    exportAll();
    ASSERT_EQ(asked().size(), 1U);
    ASSERT_TRUE(server().preview);
    EXPECT_EQ(server().preview->instance, "preview-of-a-test");
    EXPECT_TRUE(asked()[0].starts_with(std::to_string(run()) + " /files/"));
    pass(5);
    EXPECT_EQ(asked().size(), 1U) << "once";
}

TEST_F(RestingViews, AreNotRenderedWhileAnythingMovesOrNobodyLooks) {
    status(1, false);
    pass(1);
    EXPECT_TRUE(server().requests.empty());
    room->leave(1);
    status(1);
    pass(1);
    EXPECT_TRUE(server().requests.empty());
}

TEST_F(RestingViews, StayWhateverIsKeptWithTheScene) {
    begin();
    const std::uint64_t before = run();
    status(1); // there is another note
    EXPECT_EQ(run(), before);
    pass(1);
    EXPECT_EQ(asked().size(), 1U);
}

TEST_F(RestingViews, AreOutOfDateOnceSomethingMovesOrIsEdited) {
    begin();
    const std::uint64_t before = run();
    status(2, false);
    EXPECT_FALSE(server().preview);
    EXPECT_EQ(asked().back(), "give up");
    begin(2);
    EXPECT_GT(run(), before);
    status(2, true, 2); // an edit that no live frame shows
    EXPECT_FALSE(server().preview);
    pass(0.3);
    exportAll();
    EXPECT_EQ(std::ranges::count(asked(), "give up"), 2);
    EXPECT_TRUE(server().preview);
}

TEST_F(RestingViews, AreOutOfDateOnceOneWithoutPerspectiveIsMagnified) {
    parallelWidth = 20;
    begin();
    EXPECT_TRUE(server().preview);
    status(1);
    EXPECT_TRUE(server().preview) << "it is the same view";
    parallelWidth = 19;
    status(1);
    EXPECT_FALSE(server().preview);
}

TEST_F(RestingViews, AreOutOfDateAsSoonAsTheDriverPressesAKey) {
    begin();
    std::array<std::uint8_t, 17> message{2, 1};
    message[4] = 1;
    message[16] = 'W';
    room->binary(1, message);
    EXPECT_FALSE(server().preview);
    EXPECT_EQ(asked().back(), "give up");
}

TEST_F(RestingViews, AreNotGivenUpOnceTheyAreDone) {
    begin();
    pass(2000);
    EXPECT_TRUE(world.renderer.wanted) << "however long it takes, its Renderer is not let go";
    progressed(1, 256);
    room->leave(1);
    pass(1);
    EXPECT_FALSE(world.renderer.wanted);
    EXPECT_EQ(asked().size(), 1U);
    EXPECT_TRUE(server().preview);
}

TEST_F(RestingViews, AreGivenUpWhenNobodyLooksAnyMore) {
    begin();
    progressed(0.5, 16);
    room->leave(1);
    pass(0.1);
    EXPECT_EQ(asked().back(), "give up");
}

TEST_F(RestingViews, TellPagesHowTheImageWasMade) {
    begin();
    pass(0.1);
    EXPECT_EQ(page->count("image"), 0U) << "there is none yet";
    progressed(0.25, 16, 0.5F);
    pass(0.1);
    const nlohmann::json event = page->last("image");
    EXPECT_EQ(event["paths"], true);
    EXPECT_EQ(event["samples"], 16);
    EXPECT_EQ(event["part"], 0.25);
    EXPECT_EQ(event["error"], 0.5);
    EXPECT_EQ(event["largestError"], 4.5);
    auto second = std::make_shared<PageOutlet>();
    room->join({2, "Ben", false, {.visible = true}, second, {{"event", "welcome"}}});
    EXPECT_EQ(second->last("image"), event) << "one that comes later, too";
    status(2, false);
    pass(0.1);
    EXPECT_EQ(page->last("image"), (nlohmann::json{{"event", "image"}, {"paths", false}}));
}

TEST_F(RestingViews, TellWhyThereIsNone) {
    status(1);
    pass(0.3);
    exportAll(ipc::ReplyStatus::Failed);
    EXPECT_EQ(world.notes, std::vector<std::string>{"hall: no images by paths: full"});
    pass(3);
    EXPECT_TRUE(asked().empty()) << "not again for the same view";
    world.renderer.trouble = "is missing";
    begin(2);
    ASSERT_EQ(world.notes.size(), 2U);
    EXPECT_NE(world.notes[1].find("is missing"), std::string::npos);
    begin(3);
    EXPECT_EQ(world.notes.size(), 2U) << "each reason once";
    world.renderer.trouble.clear();
    begin(4);
    world.renderer.code = 65;
    pass(0.1);
    EXPECT_EQ(world.notes.size(), 2U) << "another one is tried, once";
    pass(0.3);
    exportAll();
    EXPECT_TRUE(server().preview);
    world.renderer.code = 65;
    pass(0.1);
    EXPECT_FALSE(server().preview);
    EXPECT_EQ(world.notes.back(), "hall: no images by paths: the Renderer ended with exit code 65");
}

TEST_F(RestingViews, AnswersThatComeTooLateAreAnotherImages) {
    status(1);
    pass(0.3);
    status(2);
    exportAll();
    EXPECT_EQ(asked(), std::vector<std::string>{"give up"});
    pass(0.3);
    exportAll();
    EXPECT_EQ(asked().size(), 2U);
}

} // namespace

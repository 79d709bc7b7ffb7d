// A WebSocket until it has said who it is: hello, or why not.
#include "bridge/visitor.h"

#include "bridge/room/room.h"

#include "unit/bridge/room_world.h"

#include <gtest/gtest.h>

namespace {

using bridge::CloseCode;
using bridge::Right;
using nlohmann::json;
using test::PageOutlet;

/// Knows three tokens and one room.
class PlayedReception : public bridge::Reception {
  public:
    explicit PlayedReception(bridge::Room& room) : room_(room) {}
    Right rightOf(std::string_view token) override {
        return token == "driver"   ? Right::Drive
               : token == "viewer" ? Right::View
               : token == "used"   ? Right::Used
                                   : Right::None;
    }
    bridge::Room* room(const std::string& name) override {
        return name.empty() || name == "hall" ? &room_ : nullptr;
    }
    std::string instanceList() const override { return "hall"; }
    Entrance enter(const bridge::Room&, std::string_view token, Right) override {
        entered.emplace_back(token);
        return {static_cast<bridge::SessionId>(entered.size()), "own", {{"event", "welcome"}}};
    }
    void left(std::string_view own, bool inOrder) override { lefts.emplace_back(own, inOrder); }
    void closed() override { ++closes; }
    void refused(const char* reason, const std::string& address) override {
        refusals.push_back(reason + (" " + address));
    }
    void note(const std::string& text) override { notes.push_back(text); }

    std::vector<std::string> entered, refusals, notes;
    std::vector<std::pair<std::string, bool>> lefts;
    int closes = 0;

  private:
    bridge::Room& room_;
};

class VisitorAtTheDoor : public testing::Test {
  protected:
    static json hello(const std::string& token) {
        return {{"do", "hello"}, {"v", bridge::kPageVersion}, {"token", token}, {"name", "An\nna"}};
    }
    void say(const json& message) { visitor.text(message.dump()); }
    bool isInRoom() const { return page->count("welcome") == 1 && !visitor.isNewcomer(); }

    test::RoomWorld world;
    bridge::Limits limits;
    bridge::Room room{"hall", limits, {}, world.services()};
    PlayedReception reception{room};
    std::shared_ptr<PageOutlet> page = std::make_shared<PageOutlet>();
    bridge::Visitor visitor{reception, page, world.clock};
};

TEST_F(VisitorAtTheDoor, ComesInByHello) {
    EXPECT_TRUE(visitor.isNewcomer());
    json message = hello("viewer");
    message["instance"] = "hall";
    say(message);
    EXPECT_TRUE(isInRoom());
    EXPECT_FALSE(page->closeCode);
    EXPECT_EQ(reception.entered, std::vector<std::string>{"viewer"});
    EXPECT_EQ(page->last("welcome")["role"], "viewer");
    EXPECT_EQ(page->last("roles")["people"][0]["name"], "Anna");
    EXPECT_EQ(reception.notes, std::vector<std::string>{"hall: viewer 1, Anna, came from 127.0.0.1"});
}

TEST_F(VisitorAtTheDoor, MayDriveByADriversToken) {
    say(hello("driver"));
    EXPECT_EQ(page->last("welcome")["role"], "driver");
}

TEST_F(VisitorAtTheDoor, OfAnotherVersionIsToldSo) {
    for (const json& version : {json(1), json(bridge::kPageVersion + 1), json("2"), json()}) {
        page->closeCode.reset();
        json message = hello("driver");
        message["v"] = version;
        say(message);
        EXPECT_EQ(page->closeCode, CloseCode::OtherVersion) << version;
    }
    EXPECT_EQ(static_cast<int>(CloseCode::OtherVersion), 4010);
    EXPECT_EQ(page->closeReason, "this bridge speaks version " + std::to_string(bridge::kPageVersion));
    EXPECT_TRUE(reception.entered.empty());
}

TEST_F(VisitorAtTheDoor, WithAWrongTokenIsRefusedAndCounted) {
    say(hello("wrong"));
    EXPECT_EQ(page->closeCode, CloseCode::BadToken);
    EXPECT_EQ(reception.refusals, std::vector<std::string>{"token 127.0.0.1"});
    EXPECT_TRUE(reception.entered.empty()) << "no link is used up by it";
}

TEST_F(VisitorAtTheDoor, WithAUsedLinkIsToldSo) {
    say(hello("used"));
    EXPECT_EQ(page->closeCode, CloseCode::UsedLink);
    EXPECT_EQ(reception.refusals, std::vector<std::string>{"used 127.0.0.1"});
}

TEST_F(VisitorAtTheDoor, OfNoInstanceIsToldWhichThereAre) {
    json message = hello("driver");
    message["instance"] = "cellar";
    say(message);
    EXPECT_EQ(page->closeCode, CloseCode::NoInstance);
    EXPECT_EQ(page->closeReason, "hall");
    EXPECT_TRUE(reception.entered.empty());
}

TEST_F(VisitorAtTheDoor, SaysHelloFirst) {
    for (const char* text :
         {"", "x", "[]", R"({"do":"walk","id":1})", R"({"do":7})", "[[[[[[[[[[1]]]]]]]]]]"}) {
        page->closeCode.reset();
        visitor.text(text);
        EXPECT_EQ(page->closeCode, CloseCode::BadMessage) << text;
    }
    page->closeCode.reset();
    visitor.binary(std::vector<std::uint8_t>{2, 0, 0});
    EXPECT_EQ(page->closeCode, CloseCode::BadMessage);
    EXPECT_TRUE(visitor.isNewcomer());
}

TEST_F(VisitorAtTheDoor, HasFiveSecondsForHello) {
    world.clock.pass(4.9);
    visitor.tick();
    EXPECT_FALSE(page->closeCode);
    world.clock.pass(0.2);
    visitor.tick();
    EXPECT_EQ(page->closeCode, CloseCode::NoHello);
}

TEST_F(VisitorAtTheDoor, MayBeSilentOnceItIsInARoom) {
    say(hello("viewer"));
    world.clock.pass(100);
    visitor.tick();
    EXPECT_FALSE(page->closeCode);
}

TEST_F(VisitorAtTheDoor, IsHeardByItsRoomFromThenOn) {
    say(hello("driver"));
    visitor.text(R"({"do":"walk","id":5})");
    EXPECT_EQ(world.servers["hall"].lines(), std::vector<std::string>{"walk"});
    world.servers["hall"].frames.deliver(test::frameSet(1));
    EXPECT_EQ(page->binaries.size(), 1U);
    page->isBusy = true;
    world.servers["hall"].frames.deliver(test::frameSet(2));
    page->isBusy = false;
    visitor.writable();
    EXPECT_EQ(page->binaries.size(), 2U);
    visitor.ponged(0.01);
    EXPECT_FALSE(page->closeCode);
}

TEST_F(VisitorAtTheDoor, TellsOnceWhetherItLeftInOrder) {
    say(hello("driver"));
    world.clock.pass(12);
    visitor.leaves();
    EXPECT_TRUE(visitor.isNewcomer()) << "its place may be another's";
    visitor.closed();
    EXPECT_EQ(reception.lefts, (std::vector<std::pair<std::string, bool>>{{"own", true}}));
    EXPECT_EQ(reception.closes, 1);
    EXPECT_FALSE(visitor.isNewcomer());
    EXPECT_EQ(reception.notes.back(), "hall: driver 1, Anna, left after 12 s");
    EXPECT_FALSE(world.servers["hall"].anyone);
}

TEST_F(VisitorAtTheDoor, ThatIsLostDidNotLeaveInOrder) {
    say(hello("driver"));
    visitor.closed();
    EXPECT_EQ(reception.lefts, (std::vector<std::pair<std::string, bool>>{{"own", false}}));
}

TEST_F(VisitorAtTheDoor, OutlivesItsSocket) {
    page.reset();
    visitor.text(hello("driver").dump());
    visitor.drop();
    world.clock.pass(9);
    visitor.tick();
    EXPECT_TRUE(reception.entered.empty());
    visitor.closed();
    EXPECT_EQ(reception.closes, 1);
}

} // namespace

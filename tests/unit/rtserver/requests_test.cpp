#include "rtserver/commands/requests.h"

#include "told_clients.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace rtserver {
namespace {

using Lines = std::vector<std::string>;

using test::commandOf;

class RequestsTest : public testing::Test {
  protected:
    test::ToldClients told;
    Requests requests{told};
};

TEST_F(RequestsTest, EachLoadIsAnsweredOnce) {
    requests.loaded(); // by the command line
    EXPECT_EQ(told.lines, Lines{});
    requests.addForLoad(commandOf("load a"));
    EXPECT_TRUE(requests.waitsForLoad());
    requests.loaded();
    requests.loaded();
    EXPECT_EQ(told.lines, Lines{"load a: "});
    requests.addForLoad(commandOf("load b"));
    requests.loadFailed(66, "no b");
    requests.loadFailed(66, "no b");
    EXPECT_EQ(told.lines, (Lines{"load a: ", "load b: 66 no b"}));
    EXPECT_FALSE(requests.waitsForLoad());
}

TEST_F(RequestsTest, AllThatWaitForIdleAreAnsweredOnce) {
    requests.addForIdle(commandOf("x", 1));
    requests.addForIdle(commandOf("y", 2));
    EXPECT_TRUE(requests.waitForIdle());
    requests.idle();
    requests.idle();
    EXPECT_EQ(told.lines, (Lines{"x: ", "y: "}));
    EXPECT_FALSE(requests.waitForIdle());
    requests.addForIdle(commandOf("z", 3));
    requests.refuseIdle(app::ExitCode::TryAgain, "no memory");
    requests.idle();
    EXPECT_EQ(told.lines, (Lines{"x: ", "y: ", "z: 75 no memory"}));
}

TEST_F(RequestsTest, NothingWaitsThatWantsNoAnswer) {
    requests.addForIdle(commandOf("x", 1, false));
    requests.addForKey(commandOf("y", 1, false), 7);
    EXPECT_FALSE(requests.waitForIdle() || requests.waitForKeys());
}

TEST_F(RequestsTest, KeysAreAnsweredWhenTheyAreUpAndReleasedWithTheirClient) {
    requests.addForKey(commandOf("a", 1), 10);
    requests.addForKey(commandOf("b", 2), 20);
    requests.addForKey(commandOf("c", 3), 30);
    std::vector<std::uint64_t> down{10, 20, 30}, released;
    const auto answer = [&] {
        requests.answerReleased([&](std::uint64_t press) { return std::ranges::count(down, press) > 0; },
                                [&](std::uint64_t press) { released.push_back(press); });
    };
    answer();
    EXPECT_EQ(told.lines, Lines{});
    std::erase(down, 20U);
    told.gone = 3;
    answer();
    EXPECT_EQ(told.lines, Lines{"b: "});
    EXPECT_EQ(released, std::vector<std::uint64_t>{30});
    EXPECT_TRUE(requests.waitForKeys());
    down.clear();
    answer();
    EXPECT_EQ(told.lines, (Lines{"b: ", "a: "}));
    EXPECT_FALSE(requests.waitForKeys());
}

} // namespace
} // namespace rtserver

#include "rtserver/requests.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace rtserver {
namespace {

/// Writes down what each client is told.
class Told final : public Replies {
  public:
    void answer(const ipc::Command& command, const std::string& text) override {
        lines.push_back(command.text + ": " + text);
    }
    void refuse(const ipc::Command& command, int code, const std::string& text) override {
        lines.push_back(command.text + ": " + std::to_string(code) + " " + text);
    }
    bool isConnected(const ipc::Command& command) const override { return command.client != gone; }

    std::vector<std::string> lines;
    std::uint64_t gone = 0;
};

using Lines = std::vector<std::string>;

ipc::Command command(const std::string& text, std::uint64_t client = 1, bool wantsAnswer = true) {
    ipc::Command command;
    command.text = text;
    command.client = client;
    command.wantsAnswer = wantsAnswer;
    return command;
}

class RequestsTest : public testing::Test {
  protected:
    Told told;
    Requests requests{told};
};

TEST_F(RequestsTest, EachLoadIsAnsweredOnce) {
    requests.loaded(); // by the command line
    EXPECT_EQ(told.lines, Lines{});
    requests.addForLoad(command("load a"));
    EXPECT_TRUE(requests.waitsForLoad());
    requests.loaded();
    requests.loaded();
    EXPECT_EQ(told.lines, Lines{"load a: "});
    requests.addForLoad(command("load b"));
    requests.loadFailed(66, "no b");
    requests.loadFailed(66, "no b");
    EXPECT_EQ(told.lines, (Lines{"load a: ", "load b: 66 no b"}));
    EXPECT_FALSE(requests.waitsForLoad());
}

TEST_F(RequestsTest, AllThatWaitForIdleAreAnsweredOnce) {
    requests.addForIdle(command("x", 1));
    requests.addForIdle(command("y", 2));
    EXPECT_TRUE(requests.waitForIdle());
    requests.idle();
    requests.idle();
    EXPECT_EQ(told.lines, (Lines{"x: ", "y: "}));
    EXPECT_FALSE(requests.waitForIdle());
    requests.addForIdle(command("z", 3));
    requests.refuseIdle(app::ExitCode::TryAgain, "no memory");
    requests.idle();
    EXPECT_EQ(told.lines, (Lines{"x: ", "y: ", "z: 75 no memory"}));
}

TEST_F(RequestsTest, NothingWaitsThatWantsNoAnswer) {
    requests.addForIdle(command("x", 1, false));
    requests.addForKey(command("y", 1, false), 7);
    EXPECT_FALSE(requests.waitForIdle() || requests.waitForKeys());
}

TEST_F(RequestsTest, KeysAreAnsweredWhenTheyAreUpAndReleasedWithTheirClient) {
    requests.addForKey(command("a", 1), 10);
    requests.addForKey(command("b", 2), 20);
    requests.addForKey(command("c", 3), 30);
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

#include "rtserver/commands/command_service.h"

#include "command_room.h"
#include "told_clients.h"

#include "rtserver/commands/state_report_of.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>
#include <vector>

namespace rtserver {
namespace {

using namespace std::chrono_literals;
using rtcore::Change;
using rtcore::Changes;
using test::commandOf;
using Lines = std::vector<std::string>;

class CommandServiceTest : public test::CommandRoom {
  protected:
    void serve(const std::vector<std::string>& lines) {
        std::vector<ipc::Command> commands;
        for (const std::string& line : lines) commands.push_back(commandOf(inFolder(line)));
        service.serve(std::move(commands));
    }
    Arrivals during(const std::string& line, std::uint64_t client = 1) {
        return service.addDuringFrame({commandOf(inFolder(line), client)});
    }
    /// Waits for files that are being written.
    void finishFiles() {
        for (int i = 0; i < 2000 && service.worksBeside(); ++i) {
            service.finishSideWork();
            std::this_thread::sleep_for(1ms);
        }
    }

    test::ToldClients told;
    int published = 0; ///< how often the status was
    CommandService service{
        state, messages, {.host = host, .replies = told, .publishStatus = [this] { ++published; }}};
};

TEST_F(CommandServiceTest, AnswersInOrderAndPublishesTheStatusBefore) {
    serve({"ping", "light 1 off", "lights"});
    EXPECT_EQ(told.take(), (Lines{"ping: pong", "light 1 off: ", "lights: 1 off left\n2 on"}));
    EXPECT_EQ(published, 3);
    EXPECT_EQ(changes(), Changes{Change::Light});
}

TEST_F(CommandServiceTest, RefusesWithTheExitCode) {
    serve({"light 3 on", "nonsense"});
    ASSERT_EQ(told.lines.size(), 2U);
    EXPECT_EQ(told.lines[0], "light 3 on: 2 there is no light 3; the scene has numbers 1 to 2");
    EXPECT_EQ(told.lines[1].rfind("nonsense: 2 ", 0), 0U);
    EXPECT_EQ(messages.count(), 0U);
    service.serve({commandOf("light 3 on", 1, false)});
    EXPECT_NE(messages.since(0).find("there is no light 3"), std::string::npos)
        << "since its client wants no answer";
}

TEST_F(CommandServiceTest, WhatIsInNoImageIsKeptDuringAFrame) {
    for (const char* const line :
         {"note add 0 0 0 dark Ada", "by 7 note text 1 darker", "visitor note add 0 0 0 b Ben",
          "measure keep distance 0 0 0 1 0 0", "also measure name 1 a", "note remove 1", "measure remove all",
          "bookmark rename door gate"}) {
        const std::uint64_t before = document.history().state();
        EXPECT_FALSE(during(line).change) << line;
        EXPECT_EQ(told.take().size(), 1U) << line;
        EXPECT_NE(document.history().state(), before) << line;
    }
    EXPECT_FALSE(changes().any());
    EXPECT_TRUE(during("note go 1").change);
    EXPECT_FALSE(during("note add 0 0 0 behind").change) << "that is to come first";
    EXPECT_TRUE(told.take().empty());
    serve({});
    EXPECT_EQ(told.take().size(), 2U);
}

TEST_F(CommandServiceTest, FailuresDuringAFrameAreMessagesWhereNoAnswerIsWanted) {
    during("note remove 7");
    EXPECT_EQ(messages.count(), 0U) << "its client is told";
    service.addDuringFrame({commandOf("note remove 7", 1, false)});
    const std::string said = messages.since(0);
    EXPECT_NE(said.find("note remove 7"), std::string::npos) << said;
    EXPECT_NE(said.find("warning"), std::string::npos) << said;
}

TEST_F(CommandServiceTest, OutlinesForManyTakeOneThread) {
    for (int i = 0; i < 100; ++i) during("plan outline");
    for (int i = 0; i < 2000 && told.lines.size() < 100; ++i) {
        service.finishSideWork();
        std::this_thread::sleep_for(1ms);
    }
    ASSERT_EQ(told.lines.size(), 100U);
    for (const std::string& line : told.lines) EXPECT_EQ(line.rfind("plan outline: storey 0", 0), 0U) << line;
}

// Neither does the frame end for it, nor does it wait for the frame.
TEST_F(CommandServiceTest, WhatIsFoundOutApartIsToldDuringAFrame) {
    EXPECT_FALSE(during("plan outline").change);
    EXPECT_TRUE(service.worksApart());
    for (int i = 0; i < 2000 && told.lines.empty(); ++i) {
        EXPECT_FALSE(service.addDuringFrame({}).change);
        std::this_thread::sleep_for(1ms);
    }
    ASSERT_EQ(told.lines.size(), 1U);
    EXPECT_EQ(told.lines[0].rfind("plan outline: storey 0", 0), 0U) << told.lines[0];
    EXPECT_FALSE(service.worksApart());
    told.take();
    during("plan outline 7");
    for (int i = 0; i < 2000 && told.lines.empty(); ++i) {
        service.finishSideWork();
        std::this_thread::sleep_for(1ms);
    }
    ASSERT_EQ(told.lines.size(), 1U);
    EXPECT_EQ(told.lines[0].rfind("plan outline 7: 1 there is no storey 7", 0), 0U) << told.lines[0];
}

TEST_F(CommandServiceTest, WhatNeedsAFrameIsRunAgain) {
    serve({"screenshot DIR/b.png", "ping"});
    EXPECT_TRUE(service.waits());
    EXPECT_EQ(told.lines, Lines{}) << "commands of a client keep their order";
    drawFrame();
    serve({});
    EXPECT_FALSE(service.waits());
    EXPECT_TRUE(service.worksBeside());
    finishFiles();
    serve({});
    EXPECT_EQ(told.take(), (Lines{inFolder("screenshot DIR/b.png: live frame, 32 x 24"), "ping: pong"}));
    EXPECT_TRUE(exists("b.png"));
}

// No frame is held for it; but what wants no answer is done all the same.
TEST_F(CommandServiceTest, WhatWaitsForAFrameIsForgottenWithItsClient) {
    serve({"screenshot DIR/b.png"});
    service.serve({commandOf(inFolder("screenshot DIR/c.png"), 2, false)});
    told.gone = 1;
    serve({});
    EXPECT_TRUE(service.waits());
    drawFrame();
    serve({});
    finishFiles();
    EXPECT_FALSE(service.waits());
    EXPECT_FALSE(exists("b.png"));
    EXPECT_TRUE(exists("c.png"));
}

TEST_F(CommandServiceTest, PausesEndPressesForATime) {
    serve({"key press w 60000"});
    move(0ms, {});
    service.answerRequests(false);
    EXPECT_EQ(told.take(), Lines{});
    service.serve({commandOf("pause", 2)});
    service.answerRequests(false);
    EXPECT_EQ(told.take(), (Lines{"pause: ", "key press w 60000: 1 the server was paused"}));
    EXPECT_TRUE(walk.keyboard().down().none());
    serve({"key press w 50"});
    EXPECT_EQ(told.take(), Lines{"key press w 50: 1 the server is paused; resume it first"});
    service.serve({commandOf("resume", 2)});
    EXPECT_TRUE(walk.keyboard().down().none()) << "nothing is pressed later";
}

TEST_F(CommandServiceTest, EditsAreOfAClientAndOfWhomItServes) {
    service.serve({commandOf("by 7 set maxDepth 3", 2)});
    const auto last = [&](std::uint64_t client) { return stateReportOf(document, client).undoEdit; };
    const app::ReportedEdit first = last(2);
    EXPECT_EQ(first.person, 7);
    EXPECT_EQ(last(3), (app::ReportedEdit{first.number, 0})) << "another client is not told for whom";
    service.serve({commandOf("undo", 3), commandOf("set maxDepth 3", 3)});
    EXPECT_GT(last(2).number, first.number) << "no number comes again";
    EXPECT_EQ(last(2).person, 0);
    told.take();
    service.serve(
        {commandOf("undo " + std::to_string(first.number), 2), commandOf("also set maxDepth 4", 3)});
    EXPECT_EQ(document.settings().maxDepth, 4) << "the other's edit stands";
    ASSERT_EQ(told.lines.size(), 2U);
    EXPECT_NE(told.take()[0].find("is not the last one"), std::string::npos);

    const auto steps = [&] { return document.history().position(); };
    const auto before = steps();
    service.serve({commandOf("by 7 also set maxDepth 5", 2)});
    EXPECT_EQ(steps(), before + 1) << "not joined to another's";
    service.serve({commandOf("by 7 also set maxDepth 6", 2)});
    EXPECT_EQ(steps(), before + 1);
    service.serve({commandOf("by 8 also set maxDepth 7", 2)});
    EXPECT_EQ(steps(), before + 2) << "another person of the same client";
    service.serve({commandOf("also set maxDepth 8", 4)});
    EXPECT_EQ(steps(), before + 3);
    const app::ReportedEdit newest = last(4);
    service.serve({commandOf("undo " + std::to_string(newest.number), 2)});
    EXPECT_EQ(stateReportOf(document, 4).redoEdit.number, newest.number);
    EXPECT_EQ(last(2).person, 8);
    told.take();
    for (const char* wrong :
         {"by 0 set maxDepth 3", "by x set maxDepth 3", "by 3", "by 3 undo", "by 3 by 4 set maxDepth 3",
          "also by 3 set maxDepth 3", "undo 0", "undo x", "redo 1 2"}) {
        serve({wrong});
        EXPECT_NE(told.take().at(0).find(": 2 "), std::string::npos) << wrong;
    }
}

TEST_F(CommandServiceTest, WhatWaitsIsRefusedWhenThereIsNoMemory) {
    serve({"wait-idle", "screenshot DIR/b.png"});
    service.refuseWaiting("too large");
    EXPECT_EQ(told.take(),
              (Lines{"wait-idle: 75 too large", inFolder("screenshot DIR/b.png: 75 too large")}));
    EXPECT_FALSE(service.waits());
}

TEST_F(CommandServiceTest, OnlyWhatHoldsUpOthersIsRefusedToClearTheWay) {
    service.serve({commandOf("screenshot /tmp/b.png", 1), commandOf("screenshot /tmp/c.png", 2),
                   commandOf("light 1 off", 2)});
    service.refuseObstructing("given up");
    EXPECT_EQ(told.take(), Lines{"screenshot /tmp/c.png: 75 given up"});
    serve({});
    EXPECT_EQ(told.take(), Lines{"light 1 off: "});
    EXPECT_TRUE(service.waits());
}

TEST_F(CommandServiceTest, AFileThatCannotBeReadIsRefusedWhenThatIsKnown) {
    serve({"load camera DIR/none.cam"});
    EXPECT_EQ(told.lines, Lines{});
    finishFiles();
    ASSERT_EQ(told.lines.size(), 1U);
    EXPECT_EQ(told.lines[0].rfind(inFolder("load camera DIR/none.cam: 66 "), 0), 0U) << told.lines[0];
}

TEST_F(CommandServiceTest, NothingIsRunAfterTheEnd) {
    serve({"quit", "light 1 off"});
    EXPECT_EQ(told.take(), Lines{"quit: "});
    EXPECT_EQ(changes(), Changes{});
}

TEST_F(CommandServiceTest, AFileThatDoesNotAnswerHoldsUpNoEnd) {
    serve({"load camera DIR/a.cam"});
    serve({"quit"});
    EXPECT_TRUE(host.quitted);
}

TEST_F(CommandServiceTest, ALoadIsAnsweredWhenItIsOver) {
    serve({"load scene /a.scn"});
    service.loaded(Failure{66, "no such file"});
    service.loaded(std::nullopt);
    serve({"load scene /b.scn"});
    service.loaded(std::nullopt);
    EXPECT_EQ(told.take(), (Lines{"load scene /a.scn: 66 no such file", "load scene /b.scn: "}));
}

TEST_F(CommandServiceTest, IdlenessIsAnsweredWhenItIsThere) {
    serve({"wait-idle"});
    service.answerRequests(false);
    EXPECT_EQ(told.lines, Lines{});
    service.answerRequests(true);
    EXPECT_EQ(told.take(), Lines{"wait-idle: "});
    serve({"wait-idle"});
    state.paused = true;
    service.answerRequests(false);
    EXPECT_EQ(told.take(), Lines{"wait-idle: 1 the server was paused"});
    state.paused = false;
    serve({"wait-idle"});
    state.idles = false;
    service.answerRequests(false);
    EXPECT_EQ(told.take(), Lines{"wait-idle: 1 idling was turned off"});
}

TEST_F(CommandServiceTest, AKeyIsAnsweredWhenItIsUp) {
    serve({"key press w 50"});
    move(0ms, {});
    service.answerRequests(false);
    EXPECT_EQ(told.lines, Lines{});
    move(60ms, {});
    service.answerRequests(false);
    EXPECT_EQ(told.take(), Lines{"key press w 50: "});
}

TEST_F(CommandServiceTest, DuringAFrameQuestionsAreAnsweredAndChangesWait) {
    const Arrivals question = during("lights");
    EXPECT_EQ(told.take(), Lines{"lights: 1 on left\n2 on"});
    EXPECT_FALSE(question.change || question.end || question.obstructed);
    EXPECT_EQ(published, 0) << "the status tells of the frame that is drawn";
    EXPECT_TRUE(during("light 1 off").change);
    EXPECT_FALSE(during("lights").change);
    EXPECT_EQ(told.lines, Lines{}) << "in their order";
    EXPECT_EQ(changes(), Changes{});
    EXPECT_TRUE(service.hasNew());
    serve({});
    EXPECT_EQ(told.take(), (Lines{"light 1 off: ", "lights: 1 off left\n2 on"}));
}

TEST_F(CommandServiceTest, DuringAFrameOtherClientsAreNoHindrance) {
    during("light 1 off", 1);
    during("lights", 2);
    EXPECT_EQ(told.take(), Lines{"lights: 1 on left\n2 on"});
    during("nonsense", 2);
    ASSERT_EQ(told.lines.size(), 1U);
    EXPECT_EQ(told.lines[0].rfind("nonsense: 2 ", 0), 0U);
}

TEST_F(CommandServiceTest, DuringAFrameWhatNeedsItIsNoChange) {
    EXPECT_FALSE(during("screenshot DIR/b.png").change);
    EXPECT_TRUE(during("quit", 2).end);
}

TEST_F(CommandServiceTest, DuringAFrameCommandsBehindOneThatWaitsObstruct) {
    serve({"screenshot DIR/b.png"});
    EXPECT_FALSE(during("ping", 2).obstructed);
    EXPECT_TRUE(during("light 1 off").obstructed);
    EXPECT_FALSE(during("light 2 off").change) << "its turn comes after the frame";
}

TEST_F(CommandServiceTest, ClientsWithTooManyCommandsAreFull) {
    EXPECT_TRUE(service.full().none());
    std::vector<ipc::Command> many(64, commandOf("screenshot /tmp/b.png", 3));
    service.add(many);
    EXPECT_TRUE(service.full().test(3));
    EXPECT_EQ(service.full().count(), 1U);
    told.gone = 3;
    EXPECT_TRUE(service.full().none()) << "its slot may be another client's";
}

} // namespace
} // namespace rtserver

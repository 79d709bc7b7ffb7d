// Requests of a room's pages: who may, when, and what becomes of the answers.
#include "bridge/room/room_requests.h"

#include "rtcore/settings/render_settings.h"

#include "unit/bridge/room_world.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace {

using bridge::Refused;
using bridge::SessionId;
using nlohmann::json;

constexpr SessionId kAnna = 1, kBen = 2;

json command(const char* name, const json& arguments = json::array()) {
    return {{"do", name}, {"args", arguments}};
}
const json kDeeper = command("set", {"maxDepth", 3});

class RequestsOfARoom : public testing::Test {
  protected:
    struct Asked {
        std::string line;
        std::function<void(const ipc::Reply&)> done;
    };
    void SetUp() override {
        server.link = bridge::ServerLink::There;
        tellState({}, {});
        requests.join(kAnna);
        requests.join(kBen);
    }
    void ask(SessionId by, const json& content, bool drives = true) {
        requests.request(by, drives, content, 7);
    }
    std::string refusal(SessionId by, const json& content, bool drives = true) {
        try {
            ask(by, content, drives);
        } catch (const Refused& refused) {
            return refused.what();
        }
        return "taken";
    }
    void answer(std::size_t index, const std::string& text = "",
                ipc::ReplyStatus status = ipc::ReplyStatus::Done) {
        asked.at(index).done({status, text});
    }
    void tellState(app::ReportedEdit undo, app::ReportedEdit redo = {}) {
        server.facts.read(test::stateReport(undo, redo));
        requests.stateRead();
    }
    void setStatus(double frameSeconds, double wholeSeconds, bool idle) {
        server.status.frameSeconds = frameSeconds;
        server.status.wholeSeconds = wholeSeconds;
        server.status.idle = idle ? 1 : 0;
        server.hasStatus = true;
        server.statusAt = clock.seconds();
    }
    std::vector<std::string> lines() const {
        std::vector<std::string> all;
        for (const Asked& each : asked) all.push_back(each.line);
        return all;
    }
    using Lines = std::vector<std::string>;

    test::HandClock clock;
    bridge::Limits limits;
    bridge::KnownServer server;
    std::vector<Asked> asked;
    std::vector<std::pair<SessionId, json>> sent;
    std::vector<json> sentToAll;
    int refreshes = 0, moves = 0;
    bridge::RoomRequests requests{
        limits,
        server,
        clock,
        {.ask =
             [this](const std::string& line, std::function<void(const ipc::Reply&)> done) {
                 asked.push_back({line, done});
             },
         .refresh = [this] { ++refreshes; },
         .send = [this](SessionId to, const json& event) { sent.emplace_back(to, event); },
         .sendAll = [this](const json& event) { sentToAll.push_back(event); },
         .moves = [this] { ++moves; }}};
};

TEST_F(RequestsOfARoom, GoToTheServerAndEditsInTheNameOfThePage) {
    ask(kAnna, command("walk"));
    ask(kAnna, kDeeper);
    EXPECT_EQ(lines(), (Lines{"walk", "by 1 set maxDepth 3"}));
}

TEST_F(RequestsOfARoom, ThatMoveOrEditAreTheDriversAlone) {
    EXPECT_NE(refusal(kBen, command("walk"), false), "taken");
    EXPECT_NE(refusal(kBen, kDeeper, false), "taken");
    EXPECT_EQ(refusal(kBen, command("parts"), false), "taken") << "looking is everybody's";
    EXPECT_EQ(asked.size(), 1U);
}

json noteBy(const char* author) { return command("note add", {0, 0, 0, "dark", author}); }

TEST_F(RequestsOfARoom, AreNotesOfTheDriverAloneUnlessOthersMay) {
    EXPECT_EQ(refusal(kBen, noteBy("Ben"), false), "only the driver may do that; ask to drive first");
    EXPECT_EQ(refusal(kAnna, command("note add", {0, 0, 0, "dark"})), "taken");
    limits.visitorNotes = true;
    EXPECT_EQ(refusal(kBen, noteBy("Ben"), false), "taken");
    EXPECT_EQ(lines(), (Lines{"by 1 note add 0 0 0 dark", "visitor note add 0 0 0 dark Ben"}));
    answer(1, "2");
    EXPECT_EQ(refreshes, 1) << "the state has another note";
    EXPECT_EQ(refusal(kBen, command("note remove", {1}), false),
              "only the driver may do that; ask to drive first");
}

TEST_F(RequestsOfARoom, AreNotesWithANameAndFewOfThoseThatOnlyLook) {
    limits.visitorNotes = true;
    for (const char* const author : {"", " ", "\a"})
        EXPECT_EQ(refusal(kBen, noteBy(author), false), "a note needs a name");
    const auto taken = [&](SessionId by, int of, bool drives = false) {
        int count = 0;
        for (int i = 0; i < of; ++i) {
            if (refusal(by, noteBy("Ben"), drives) != "taken") continue;
            answer(asked.size() - 1);
            ++count;
        }
        return count;
    };
    EXPECT_EQ(taken(kBen, 9), 3);
    EXPECT_EQ(refusal(kBen, noteBy("Ben"), false), "too many notes; wait a minute");
    EXPECT_EQ(taken(kAnna, 9, true), 9) << "who drives";
    clock.pass(21);
    EXPECT_EQ(taken(kBen, 9), 1);
    int all = 0;
    for (SessionId id = 10; id < 20; ++id) {
        requests.join(id);
        all += taken(id, 9);
    }
    EXPECT_LE(all, 12) << "pages that come again and again";
    EXPECT_GE(all, 9);
    clock.pass(60);
    limits.locked = {"edits"};
    EXPECT_EQ(taken(kAnna, 9, true), 3) << "who drives, and may edit no more than others";
}

TEST_F(RequestsOfARoom, AreNoNotesOfVisitorsWhereTheSceneHasVeryMany) {
    limits.visitorNotes = true;
    app::StateReport state = app::parseStateReport(test::stateReport());
    state.noteCount = bridge::kMaxVisitorNotes;
    server.facts.read(app::formatStateReport(state, 65000));
    requests.stateRead();
    EXPECT_NE(refusal(kBen, noteBy("Ben"), false).find("the most that visitors may have"), std::string::npos);
    EXPECT_EQ(refusal(kAnna, noteBy("Anna")), "taken");
}

TEST_F(RequestsOfARoom, AreNoMoreNotesOfVisitorsThanTheSceneMayHaveInABurst) {
    limits.visitorNotes = true;
    app::StateReport state = app::parseStateReport(test::stateReport());
    state.noteCount = bridge::kMaxVisitorNotes - 3;
    server.facts.read(app::formatStateReport(state, 65000));
    requests.stateRead();
    requests.join(3);
    EXPECT_EQ(refusal(kBen, noteBy("Ben"), false), "taken");
    EXPECT_EQ(refusal(3, noteBy("Cleo"), false), "taken");
    answer(0, std::to_string(bridge::kMaxVisitorNotes - 2));
    EXPECT_EQ(refusal(kBen, noteBy("Ben"), false), "taken") << "two are under way or there";
    EXPECT_NE(refusal(kBen, noteBy("Ben"), false), "taken") << "the state is still that from before";
    answer(1, std::to_string(bridge::kMaxVisitorNotes - 1));
    answer(2, "", ipc::ReplyStatus::Failed);
    EXPECT_EQ(refusal(3, noteBy("Cleo"), false), "taken") << "one was refused by the server";
}

TEST_F(RequestsOfARoom, AreNotesThatCountOnlyWhereTheyAreKept) {
    limits.visitorNotes = true;
    for (int i = 0; i < 9; ++i) {
        EXPECT_EQ(refusal(kBen, noteBy("Ben"), false), "taken") << i;
        answer(asked.size() - 1, "", ipc::ReplyStatus::Failed);
    }
    for (SessionId id = 10; id < 14; ++id) { // all that visitors may add at once
        requests.join(id);
        for (int i = 0; i < 3; ++i)
            if (refusal(id, noteBy("Cleo"), false) == "taken") answer(asked.size() - 1, "1");
    }
    for (int i = 0; i < 9; ++i)
        EXPECT_EQ(refusal(kBen, noteBy("Ben"), false), "too many notes; wait a minute");
    clock.pass(15); // three more of all; those of a page are one in 20 s
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(refusal(kBen, noteBy("Ben"), false), "taken") << "its own are all there";
        answer(asked.size() - 1, "1");
    }
}

TEST_F(RequestsOfARoom, AreNotesOfVisitorsThatAreNoStep) {
    limits.visitorNotes = true;
    tellState({5, kAnna}, {6, kAnna});
    json note = noteBy("Ben");
    note["also"] = true;
    ask(kBen, note, false);
    EXPECT_EQ(lines(), Lines{"visitor note add 0 0 0 dark Ben"});
    EXPECT_TRUE(requests.mayUndo(kAnna)) << "also while it is under way";
    EXPECT_TRUE(requests.mayRedo(kAnna));
    answer(0, "1");
    EXPECT_EQ(refusal(kAnna, command("undo")), "taken");
}

TEST_F(RequestsOfARoom, AreFourWithoutAnAnswerAtMost) {
    for (int i = 0; i < 4; ++i) ask(kAnna, command("walk"));
    EXPECT_EQ(refusal(kAnna, command("walk")), "too many requests at once");
    EXPECT_EQ(refusal(kBen, command("walk")), "taken") << "another page has its own";
    answer(0);
    EXPECT_EQ(refusal(kAnna, command("walk")), "taken");
}

TEST_F(RequestsOfARoom, ThatOnlyLookAreAHundredAtOnceAndFiftyASecond) {
    const auto taken = [&](int of) {
        int count = 0;
        for (int i = 0; i < of; ++i) {
            if (refusal(kBen, command("parts"), false) != "taken") continue;
            answer(asked.size() - 1);
            ++count;
        }
        return count;
    };
    EXPECT_EQ(taken(150), 100);
    clock.pass(1);
    EXPECT_NEAR(taken(100), 50, 1);
}

TEST_F(RequestsOfARoom, AreRefusedWithoutAServer) {
    server.link = bridge::ServerLink::Gone;
    EXPECT_EQ(refusal(kAnna, command("walk")), "there is no server");
    server.link = bridge::ServerLink::Busy;
    EXPECT_EQ(refusal(kAnna, command("walk")), "taken");
    server.link.reset();
    EXPECT_EQ(refusal(kAnna, command("walk")), "taken") << "it was not looked for yet";
}

TEST_F(RequestsOfARoom, AreAnsweredToThePageThatAsked) {
    ask(kAnna, command("walk"));
    answer(0, "done so");
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_EQ(sent[0].first, kAnna);
    EXPECT_EQ(sent[0].second, (json{{"event", "answer"}, {"id", 7}, {"ok", true}, {"text", "done so"}}));
    EXPECT_EQ(refreshes, 1);
}

TEST_F(RequestsOfARoom, ThatFailSayWhyWithoutFolders) {
    ask(kAnna, command("walk"));
    answer(0, "/secret/folder/hall.scn: no floor", ipc::ReplyStatus::Failed);
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_EQ(sent[0].second["ok"], false);
    EXPECT_EQ(sent[0].second["text"], "hall.scn: no floor");
}

TEST_F(RequestsOfARoom, OfAPageThatLeftAreAnsweredToNobody) {
    ask(kAnna, kDeeper);
    requests.leave(kAnna);
    EXPECT_TRUE(requests.moving());
    answer(0);
    EXPECT_TRUE(sent.empty());
    EXPECT_FALSE(requests.moving());
    requests.join(kAnna);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(refusal(kAnna, command("walk")), "taken") << i;
}

TEST_F(RequestsOfARoom, MoveTheCameraFromAskingToTheAnswer) {
    ask(kAnna, command("parts"));
    EXPECT_EQ(moves, 0) << "looking moves nothing";
    ask(kAnna, command("walk"));
    EXPECT_EQ(moves, 1);
    EXPECT_TRUE(requests.moving());
    answer(1);
    EXPECT_EQ(moves, 2);
    EXPECT_FALSE(requests.moving());
}

TEST_F(RequestsOfARoom, UndoTheOwnEditByItsNumber) {
    tellState({5, kBen});
    EXPECT_EQ(refusal(kAnna, command("undo")), "the last edit is not yours");
    ask(kBen, command("undo"));
    EXPECT_EQ(lines(), Lines{"undo 5"});
    answer(0);
    tellState({}, {5, kBen});
    EXPECT_NE(refusal(kAnna, command("redo")), "taken");
    ask(kBen, command("redo"));
    EXPECT_EQ(asked.back().line, "redo 5");
}

TEST_F(RequestsOfARoom, UndoNothingUntilTheLastEditIsKnown) {
    tellState({5, kAnna});
    ask(kAnna, kDeeper);
    EXPECT_EQ(refusal(kAnna, command("undo")), "the last edit is still under way");
    answer(0);
    EXPECT_NE(refusal(kAnna, command("undo")), "taken") << "the server has not told its state since";
    EXPECT_FALSE(requests.mayUndo(kAnna));
    tellState({6, kAnna});
    EXPECT_TRUE(requests.mayUndo(kAnna));
    EXPECT_FALSE(requests.mayUndo(kBen));
    ask(kAnna, command("undo"));
    EXPECT_EQ(asked.back().line, "undo 6");
}

TEST_F(RequestsOfARoom, UndoNothingOfAServerThatIsGone) {
    tellState({5, kAnna});
    EXPECT_TRUE(requests.mayUndo(kAnna));
    requests.serverGone();
    EXPECT_FALSE(requests.mayUndo(kAnna));
}

class HeavyRequests : public RequestsOfARoom {
  protected:
    void edit(const json& content) {
        ask(kAnna, content);
        answer(asked.size() - 1);
    }
    /// Lines that the room sent on its own account since `first`.
    Lines back(std::size_t first) const {
        Lines all = lines();
        all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(first));
        return all;
    }
    const rtcore::RenderSettings before;
};

TEST_F(HeavyRequests, AreTakenBackWhenNoFrameComes) {
    setStatus(0.1, 0.1, false);
    for (const int depth : {7, 8}) edit(command("set", {"maxDepth", depth}));
    edit(command("resolution", {1600, 900}));
    clock.pass(4.9);
    requests.tick();
    EXPECT_TRUE(sentToAll.empty());
    clock.pass(0.2);
    requests.tick();
    EXPECT_EQ(back(3), (Lines{fmt::format("set maxDepth {}", before.maxDepth),
                              fmt::format("resolution {} {}", before.width, before.height)}))
        << "what was before the first";
    ASSERT_EQ(sentToAll.size(), 1U);
    EXPECT_EQ(sentToAll[0]["event"], "notice");
    EXPECT_EQ(sentToAll[0]["code"], "heavy");
    EXPECT_EQ(sentToAll[0]["back"], (json{"maxDepth", "size"}));
    requests.tick();
    EXPECT_EQ(asked.size(), 5U) << "once";
}

TEST_F(HeavyRequests, AreTakenBackWhenWholeFramesLast) {
    setStatus(0.1, 0.1, false);
    edit(command("set", {"maxDepth", 60}));
    clock.pass(1);
    server.lastFrame = clock.seconds();
    setStatus(0.1, 5.5, false);
    requests.tick();
    EXPECT_EQ(back(1), Lines{fmt::format("set maxDepth {}", before.maxDepth)});
}

TEST_F(HeavyRequests, ThatFramesFollowStay) {
    setStatus(0.1, 0.1, false);
    edit(kDeeper);
    for (int i = 0; i < 20; ++i) {
        clock.pass(0.5);
        server.lastFrame = clock.seconds();
        requests.tick();
    }
    EXPECT_EQ(asked.size(), 1U);
}

TEST_F(HeavyRequests, WaitForNoFrameOfAServerThatPausesOrRests) {
    setStatus(0.1, 0.1, false);
    server.status.paused = 1;
    edit(kDeeper);
    clock.pass(6);
    requests.tick();
    EXPECT_EQ(asked.size(), 1U);
}

TEST_F(HeavyRequests, ThatWereQuickAtRestStayWhateverComesLater) {
    setStatus(0.1, 0.1, true);
    edit(kDeeper);
    clock.pass(0.6);
    requests.tick();
    setStatus(0.1, 9, false);
    requests.tick();
    EXPECT_EQ(asked.size(), 1U);
}

TEST_F(HeavyRequests, ThatMendHeavyFramesStay) {
    setStatus(7, 7, false);
    edit(kDeeper);
    clock.pass(0.1);
    setStatus(7, 7, false);
    requests.tick();
    EXPECT_EQ(asked.size(), 1U);
}

TEST_F(HeavyRequests, AreWatchedFromTheirAnswerOn) {
    setStatus(0.1, 0.1, false);
    ask(kAnna, kDeeper);
    clock.pass(4);
    answer(0);
    clock.pass(2);
    requests.tick();
    EXPECT_EQ(asked.size(), 1U);
    clock.pass(4);
    requests.tick();
    EXPECT_EQ(asked.size(), 2U);
}

TEST_F(HeavyRequests, OfUndoAreMadeAgain) {
    setStatus(0.1, 0.1, false);
    tellState({5, kAnna});
    edit(command("undo"));
    clock.pass(6);
    requests.tick();
    EXPECT_EQ(back(1), Lines{"redo 5"});
    ASSERT_EQ(sentToAll.size(), 1U);
    EXPECT_EQ(sentToAll[0]["back"], json::array({"lastEdit"}));
}

TEST_F(HeavyRequests, OfAServerThatIsGoneAreForgotten) {
    setStatus(0.1, 0.1, false);
    edit(kDeeper);
    requests.serverGone();
    clock.pass(6);
    requests.tick();
    EXPECT_EQ(asked.size(), 1U);
}

} // namespace

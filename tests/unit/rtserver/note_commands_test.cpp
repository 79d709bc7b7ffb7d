// Notes: added, changed, undone, saved, listed, exported, and looked at. The room: a floor of 20 x 20, and a
// box from (-0.5, 0, -3) to (0.5, 1, -2).
#include "command_room.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

namespace rtserver {
namespace {

class NoteCommands : public test::CommandRoom {
  protected:
    const rtcore::SceneNote& note(std::size_t number) const { return document.notes().at(number - 1); }
    std::string exported() {
        answer("note export DIR/n.csv");
        std::ifstream file(folder / "n.csv", std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    void clearTimes() {
        rtcore::SceneNotes all = document.notes();
        for (rtcore::SceneNote& each : all) each.written.clear();
        document.setNotes(all);
    }
};

TEST_F(NoteCommands, KeepATextWithItsAuthorAndItsTime) {
    EXPECT_EQ(answer("note add 0 0.5 -2 \"too dark\nhere\" Ada"), "1");
    EXPECT_EQ(note(1).point, (rtcore::Vec3d{0, 0.5, -2}));
    EXPECT_EQ(note(1).text, "too dark\nhere");
    EXPECT_EQ(note(1).author, "Ada");
    EXPECT_TRUE(rtcore::isDateTime(note(1).written)) << note(1).written;
    EXPECT_EQ(answer("note add 1 0 0 brighter"), "2");
    EXPECT_EQ(note(2).author, "");
    EXPECT_EQ(answer("note list"), "1 0 0.5 -2 Ada: too dark here\n2 1 0 0 brighter");
    EXPECT_EQ(answer("note list 2"), "2 1 0 0 brighter");
    EXPECT_EQ(answer("note list 3"), "");
    EXPECT_EQ(answer("note get 1"), "too dark\nhere");
}

TEST_F(NoteCommands, TakeNoControlCharacters) {
    answer("note add 0 0 0 \"\x1B[31mred \xE2\x80\xAE<b>\" \"A\a\nb\"");
    EXPECT_EQ(note(1).text, "[31mred <b>");
    EXPECT_EQ(note(1).author, "A b");
    EXPECT_NE(refusal("note add 0 0 0 \"\a\"").text.find("no text"), std::string::npos);
    EXPECT_EQ(document.notes().size(), 1U);
}

TEST_F(NoteCommands, AreStepsOfUndo) {
    const std::uint64_t before = document.history().state();
    answer("note add 0 0 0 one");
    answer("note text 1 another Ada");
    answer("note text 1 third");
    EXPECT_EQ(note(1).author, "Ada") << "stays";
    answer("note text 1 third \"\"");
    EXPECT_EQ(note(1).author, "");
    answer("note remove 1");
    EXPECT_TRUE(document.notes().empty());
    answer("undo");
    answer("undo");
    answer("undo");
    EXPECT_EQ(note(1).text, "another");
    answer("undo");
    EXPECT_EQ(note(1).text, "one");
    answer("undo");
    EXPECT_TRUE(document.notes().empty());
    EXPECT_EQ(document.history().state(), before);
    answer("redo");
    EXPECT_EQ(note(1).text, "one");
}

TEST_F(NoteCommands, OfVisitorsAreNoStepsAndStayWhateverIsTakenBack) {
    answer("note add 0 0 0 one");
    answer("light 1 off");
    answer("note text 1 another");
    answer("undo");
    const int last = document.history().last()->number, next = document.history().next()->number;
    const std::uint64_t made = document.history().state();
    EXPECT_EQ(answer("visitor note add 1 0 0 dark Ben"), "2");
    EXPECT_EQ(answer("visitor note at 0.5 0.9 floor Cleo"), "3");
    ASSERT_NE(document.history().next(), nullptr) << "redo stays";
    EXPECT_EQ(document.history().last()->number, last);
    EXPECT_EQ(document.history().next()->number, next);
    EXPECT_NE(document.history().state(), made) << "there is something to save";
    answer("redo");
    EXPECT_EQ(answer("note list"), "1 0 0 0 another\n2 1 0 0 Ben: dark\n" + answer("note list 3"));
    answer("undo");
    answer("undo");
    answer("undo");
    EXPECT_EQ(document.history().last(), nullptr);
    ASSERT_EQ(document.notes().size(), 2U);
    EXPECT_EQ(note(1).author, "Ben");
    EXPECT_EQ(note(2).author, "Cleo");
    EXPECT_TRUE(document.modified());
    answer("redo");
    answer("note remove 2");
    EXPECT_EQ(document.notes().size(), 2U);
    answer("undo");
    EXPECT_EQ(note(2).author, "Ben") << "to remove it is a step";
}

TEST_F(NoteCommands, OfVisitorsLeaveStatesThatWereSavedAlone) {
    answer("note add 0 0 0 one");
    answer("save as DIR/n.scn");
    answer("camera set 1 2 3 0 0 -1");
    EXPECT_FALSE(document.modified());
    answer("visitor note add 0 0 0 dark Ben");
    EXPECT_TRUE(document.modified());
    answer("undo");
    EXPECT_TRUE(document.modified()) << "the file has no such note";
    answer("save as DIR/n.scn");
    answer("redo");
    EXPECT_FALSE(document.modified()) << "it placed the camera alone";
}

TEST_F(NoteCommands, OfVisitorsAreForAddingAlone) {
    answer("note add 0 0 0 one");
    for (const char* const line :
         {"visitor note remove 1", "visitor note text 1 a", "visitor light 1 off", "visitor",
          "visitor also note add 0 0 0 a", "by 1 visitor note add 0 0 0 a"})
        EXPECT_EQ(refusal(line).code, 2) << line;
    EXPECT_EQ(note(1).text, "one");
}

TEST_F(NoteCommands, OfVisitorsAreNoMoreThanAnyStepHasRoomFor) {
    const rtcore::SceneNotes many(rtcore::kMaxNotes,
                                  rtcore::SceneNote{.point = {0, 0, 0}, .text = "a", .view = {}});
    document.setNotes(many);
    answer("note remove all");
    EXPECT_EQ(refusal("visitor note add 0 0 0 b Ben").code, 1) << "undo would bring back a thousand";
    EXPECT_TRUE(document.notes().empty());
    answer("undo");
    EXPECT_EQ(document.notes().size(), rtcore::kMaxNotes);
}

TEST_F(NoteCommands, AreSavedAndSurviveOtherEdits) {
    answer("camera set 0 1 3 0 0 -1 60");
    answer("note add 0 0.5 -2 \"a \\\"b\\\"\n\\\\c\" Ada");
    answer("part hide box");
    answer("save as DIR/n.scn");
    const rtcore::SceneNotes saved = rtcore::readSceneFile(folder / "n.scn").notes;
    EXPECT_EQ(saved, document.notes());
    ASSERT_EQ(saved.size(), 1U);
    ASSERT_TRUE(saved[0].view);
    EXPECT_EQ(saved[0].view->eye, (rtcore::Vec3{0, 1, 3}));
}

TEST_F(NoteCommands, KeepTheViewThatHasThePoint) {
    answer("camera set 0 1 3 0 0 -1 60");
    answer("note add 0 1 -2 before");
    answer("note add 0 1 5 behind");
    answer("note add 20 1 -2 beside");
    answer("camera orthographic 0 1 3 0 0 -1 4");
    answer("note add 1.9 1 -2 within");
    answer("note add 2.1 1 -2 without");
    EXPECT_TRUE(note(1).view);
    EXPECT_FALSE(note(2).view);
    EXPECT_FALSE(note(3).view);
    EXPECT_TRUE(note(4).view);
    EXPECT_FALSE(note(5).view);
}

TEST_F(NoteCommands, ArePlacedWhereTheImageShowsTheModel) {
    answer("camera orthographic 0 0.5 3 0 0 -1 4");
    answer("resolution 400 300");
    answer("note at 0.55 0.53 face");
    EXPECT_NEAR(note(1).point.x, 0.2, 1e-5);
    EXPECT_NEAR(note(1).point.z, -2, 1e-5);
    EXPECT_TRUE(note(1).view);
    answer("camera set 0 5 0 0 1 0.1");
    EXPECT_EQ(refusal("note at 0.5 0.5 sky").text, "nothing of the model is seen there");
}

TEST_F(NoteCommands, LeadToTheirView) {
    answer("camera set 0 1 3 0 0 -1 60");
    answer("note add 0 1 -2 seen");
    answer("camera set 7 7 7 1 0 0 60");
    answer("note go 1");
    EXPECT_EQ(document.camera().eye, (rtcore::Vec3{0, 1, 3}));
    EXPECT_EQ(document.camera().forward, (rtcore::Vec3{0, 0, -1}));
}

TEST_F(NoteCommands, LeadToAPointThatNoViewWasKeptOf) {
    answer("camera set 0 1 3 0 0 1 60");
    answer("note add 0 0.5 -2 \"on the box\""); // behind the camera
    ASSERT_FALSE(note(1).view);
    answer("note go 1");
    const rtcore::Camera& camera = document.camera();
    const rtcore::Vec3 off = rtcore::Vec3{0, 0.5F, -2} - camera.eye;
    EXPECT_GT(length(off), 1.4F);
    EXPECT_GT(camera.eye.z, -2) << "before the face that it is on";
    EXPECT_GT(dot(normalize(off), normalize(camera.forward)), 0.9999F);
    EXPECT_FALSE(rtcore::areParallel(camera.forward, camera.up));
    answer("camera set 0 0.5 -2.5 0 0 1 60"); // within the box, which is too near to its walls
    answer("note go 1");
    EXPECT_FALSE(document.camera().eye.z < -2 && document.camera().eye.z > -3 &&
                 std::abs(document.camera().eye.x) < 0.5F);
}

TEST_F(NoteCommands, AreExportedAsTablesHaveThem) {
    EXPECT_EQ(exported(), "number,author,written,point,text\r\n");
    answer("note add 0 0.5 -2 \"a \\\"b\\\",\nc\" @Ada");
    answer("note add 0.1 0 0 \"=1+2\n=3; -x - 4\"");
    clearTimes();
    EXPECT_EQ(exported(), "number,author,written,point,text\r\n"
                          "1,'@Ada,,0 0.5 -2,\"a \"\"b\"\",\nc\"\r\n"
                          "2,,,0.1 0 0,\"'=1+2\n'=3; -x - 4\"\r\n");
}

TEST_F(NoteCommands, AreAThousandAtMost) {
    rtcore::SceneNotes many(rtcore::kMaxNotes,
                            rtcore::SceneNote{.point = {0, 0, 0}, .text = "a", .view = {}});
    document.setNotes(many);
    EXPECT_EQ(refusal("note add 0 0 0 b").code, 1);
    answer("note remove 1000");
    EXPECT_EQ(answer("note add 0 0 0 b"), "1000");
    answer("note remove all");
    EXPECT_TRUE(document.notes().empty());
}

} // namespace
} // namespace rtserver

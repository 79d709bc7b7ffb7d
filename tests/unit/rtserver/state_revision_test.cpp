#include "command_room.h"

#include "rtserver/commands/state_report_of.h"
#include "rtserver/loop/image_revision.h"
#include "rtserver/loop/state_revision.h"

#include <gtest/gtest.h>

namespace rtserver {
namespace {

class Revised : public test::CommandRoom {
  protected:
    std::uint64_t now() { return revision_.of(state, true); }

  private:
    StateRevision revision_;
};

TEST_F(Revised, GrowsWithEachAnswerThatIsAnother) {
    std::uint64_t last = now();
    EXPECT_EQ(now(), last) << "nothing happened";
    for (const char* const line : {"set maxDepth 3",
                                   "resolution 64 48",
                                   "light 1 off",
                                   "light name 1 bulb",
                                   "environment 2",
                                   "undo",
                                   "redo",
                                   "bookmark add here",
                                   "measure keep distance 0 0 0 1 0 0",
                                   "measure name 1 a",
                                   "measure unit mm",
                                   "note add 0 0 0 a",
                                   "note text 1 b",
                                   "material set 1 diffuse 1 0 0",
                                   "part hide box",
                                   "camera angle 80",
                                   "camera turn 10 0",
                                   "up -y",
                                   "units cm",
                                   "section add 0 0.5 0 0 1 0",
                                   "section hatching on",
                                   "bind k jump",
                                   "sky on"}) {
        const std::string before = app::formatStateReport(stateReportOf(document, 0), 65520);
        answer(line);
        EXPECT_GT(now(), last) << line;
        last = now();
        const bool bindings = std::string(line).starts_with("bind");
        EXPECT_TRUE(bindings || before != app::formatStateReport(stateReportOf(document, 0), 65520)) << line;
    }
    for (const char* const line :
         {"ping", "state", "lights", "get maxDepth", "camera pivot", "pause", "resume"}) {
        answer(line);
        EXPECT_EQ(now(), last) << line;
    }
}

TEST_F(Revised, LeavesAMovingCameraToTheStatus) {
    StateRevision revision;
    const std::uint64_t first = revision.of(state, true);
    run("camera turn 10 0");
    EXPECT_EQ(revision.of(state, false), first);
    EXPECT_GT(revision.of(state, true), first) << "once it rests";
}

TEST_F(Revised, CountsImagesByWhatTheyShow) {
    ImageRevision revision;
    std::uint64_t last = revision.of(document);
    EXPECT_GT(last, 0U);
    for (const char* const line :
         {"note add 0 0 0 a", "note text 1 b", "note remove 1", "undo", "measure keep distance 0 0 0 1 0 0",
          "measure unit mm", "bookmark add here", "bookmark rename here there", "light name 1 bulb",
          "camera turn 10 0", "resolution 64 48", "set maxDepth 5", "pause", "resume", "bind k jump"}) {
        answer(line);
        EXPECT_EQ(revision.of(document), last) << line;
    }
    for (const char* const line : {"set maxDepth 3", "light 1 off", "undo", "redo", "environment 2",
                                   "material set 1 diffuse 1 0 0", "part hide box", "up -y", "units cm",
                                   "section add 0 0.5 0 0 1 0", "section hatching on", "sky on"}) {
        answer(line);
        EXPECT_GT(revision.of(document), last) << line;
        last = revision.of(document);
    }
}

} // namespace
} // namespace rtserver

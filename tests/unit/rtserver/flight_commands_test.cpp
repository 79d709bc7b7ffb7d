// Flights: key frames kept, changed, undone, saved, shown in real time, and written as lists of cameras.
#include "command_room.h"

#include "rtcore/io/recording/camera_list.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace rtserver {
namespace {

using namespace std::chrono_literals;

class FlightCommands : public test::CommandRoom {
  protected:
    const rtcore::Flight& flight(const std::string& name) const {
        const auto found = rtcore::findFlight(document.flights(), name);
        EXPECT_NE(found, document.flights().end()) << name;
        return *found;
    }
    /// The answer.
    std::string keep(const std::string& name, double x, const std::string& time = "") {
        answer("camera set " + std::to_string(x) + " 1.8 3 0 0 -1");
        return answer("flight key add " + name + " " + time);
    }
    float eye(std::size_t key, const std::string& name = "a") const {
        return flight(name).keys.at(key - 1).camera.eye.x;
    }
    std::string why(const std::string& line) { return refusal(line).text; }
};

TEST_F(FlightCommands, KeepViewsAsKeyFrames) {
    EXPECT_EQ(keep("a", 0), "1");
    EXPECT_EQ(keep("a", 1), "2");
    EXPECT_EQ(keep("a", 4), "3");
    EXPECT_EQ(flight("a").keys.size(), 3U);
    EXPECT_EQ(flight("a").timing, rtcore::FlightTiming::Even);
    EXPECT_EQ(eye(3), 4);
    answer("flight seconds a 12.5");
    answer("flight closed a on");
    answer("flight target a 0 0.5 -2.5");
    EXPECT_EQ(answer("flight list"), "12.5 3 a");
    EXPECT_NE(answer("flight get a").find("target = [0.0, 0.5, -2.5]"), std::string::npos);
    answer("flight target a");
    EXPECT_FALSE(flight("a").target);
    answer("flight key move a 3 1");
    EXPECT_EQ(eye(1), 4);
    EXPECT_EQ(eye(3), 1);
    answer("camera set 7 1.8 3 0 0 -1");
    answer("flight key set a 2");
    EXPECT_EQ(eye(2), 7);
    answer("flight key exposure a 2 0.5");
    EXPECT_EQ(flight("a").keys[1].exposure, 0.5F);
    answer("flight key exposure a 2 automatic");
    EXPECT_FALSE(flight("a").keys[1].exposure);
    EXPECT_NE(why("flight key set a 4").find("3 key frames"), std::string::npos);
    EXPECT_NE(why("flight key add a 3").find("even speed"), std::string::npos);
    EXPECT_NE(why("flight key time a 2 3").find("even speed"), std::string::npos);
    EXPECT_NE(why("flight key exposure a 1 1e-50").find("above 0"), std::string::npos);
    for (int i = 0; i < 3; ++i) answer("flight key remove a 1");
    EXPECT_TRUE(document.flights().empty()) << "the last key frame goes with its flight";
}

TEST_F(FlightCommands, ByTimesHaveTheirPlaceByThem) {
    keep("a", 0, "0");
    keep("a", 8, "8");
    EXPECT_EQ(keep("a", 4, "4"), "2");
    EXPECT_EQ(eye(2), 4);
    keep("a", 9);
    EXPECT_EQ(flight("a").keys[3].time, 11) << "three seconds behind the last";
    answer("flight key time a 2 5");
    EXPECT_EQ(flight("a").keys[1].time, 5);
    EXPECT_NE(why("flight key time a 2 9").find("number 3"), std::string::npos);
    EXPECT_NE(why("flight key time a 1 1").find("is 0"), std::string::npos);
    EXPECT_NE(why("flight closed a on").find("by times"), std::string::npos);
    answer("flight seconds a 22");
    EXPECT_EQ(flight("a").keys[1].time, 10);
    answer("flight key remove a 1");
    EXPECT_EQ(flight("a").keys[0].time, 0);
    EXPECT_EQ(flight("a").keys[1].time, 6);
}

TEST_F(FlightCommands, ChangeTheirTimingInPlace) {
    keep("a", 0);
    keep("a", 1);
    keep("a", 4);
    answer("flight seconds a 8");
    answer("flight timing a times");
    EXPECT_EQ(flight("a").keys[0].time, 0);
    EXPECT_NEAR(flight("a").keys[1].time, 8 * 0.25, 1) << "a quarter of the way";
    EXPECT_EQ(flight("a").keys[2].time, 8);
    answer("flight trim a 1 6");
    EXPECT_EQ(flight("a").keys.size(), 3U);
    EXPECT_EQ(flight("a").keys[2].time, 5);
    answer("flight timing a even");
    EXPECT_EQ(flight("a").seconds, 5);
    EXPECT_NE(why("flight trim a 6 7").find("after 5 seconds"), std::string::npos);
}

TEST_F(FlightCommands, GoThroughBookmarksAndAroundTheModel) {
    answer("bookmark add here");
    answer("camera set 5 1.8 3 0 0 -1");
    answer("bookmark add there");
    answer("flight through all 9");
    EXPECT_EQ(flight("all").keys.size(), document.bookmarks().size());
    answer("flight through two 9 there here");
    ASSERT_EQ(flight("two").keys.size(), 2U);
    EXPECT_EQ(eye(1, "two"), 5);
    answer("camera pivot 0.5 0.9");
    answer("flight turntable round 8");
    EXPECT_EQ(flight("round").turns, 1);
    EXPECT_EQ(answer("flight list"), "9 3 all\n9 2 two\n8 turntable round");
    EXPECT_NE(why("flight key add round").find("turntable"), std::string::npos);
    answer("flight timing round times");
    EXPECT_EQ(flight("round").keys.size(), 13U) << "every 30 degrees";
    answer("flight copy two three");
    answer("flight rename three four");
    EXPECT_NE(why("flight rename four two").find("another flight is called 'two'"), std::string::npos);
    answer("flight remove two");
    EXPECT_EQ(document.flights().size(), 3U);
}

TEST_F(FlightCommands, AreStepsOfUndoAndSaved) {
    const std::uint64_t before = document.history().state();
    keep("a", 0);
    keep("a", 1);
    answer("flight seconds a 3");
    const rtcore::Flights kept = document.flights();
    answer("undo");
    EXPECT_EQ(flight("a").seconds, 10);
    answer("redo");
    EXPECT_EQ(document.flights(), kept);
    answer("export scene DIR/f.scn");
    EXPECT_EQ(rtcore::readSceneFile(folder / "f.scn", document.scene()->origin).flights, kept);
    while (document.history().last() != nullptr) answer("undo");
    EXPECT_EQ(document.history().state(), before);
    EXPECT_TRUE(document.flights().empty());
}

TEST_F(FlightCommands, AreShownAndWritten) {
    keep("a", 0);
    keep("a", 4);
    answer("flight seconds a 2");
    answer("flight go a 1");
    EXPECT_NEAR(document.camera().eye.x, 2, 1e-5);
    EXPECT_EQ(answer("flight export a DIR/f.lst 10"), "21 frames");
    const auto files = rtcore::readCameraList(folder / "f.lst");
    ASSERT_EQ(files.size(), 21U);
    EXPECT_EQ(rtcore::readCameraFile(files[0]).camera, flight("a").keys[0].camera);
    EXPECT_EQ(rtcore::readCameraFile(files[20]).camera, flight("a").keys[1].camera);
    EXPECT_EQ(rtcore::readCameraFile(files[5]).time, 0.5);
    EXPECT_EQ(refusal("flight export a DIR/f.lst").code, 73) << "nothing is written over";
    // And back: a straight way with its ease is a few key frames again.
    const std::string keys = answer("flight from DIR/f.lst back 0.01");
    EXPECT_LE(std::stoi(keys), 12) << keys;
    for (int i = 0; i <= 20; ++i) {
        const rtcore::Camera& wanted = rtcore::readCameraFile(files[static_cast<std::size_t>(i)]).camera;
        answer("flight go back " + std::to_string(i * 0.1));
        EXPECT_NEAR(document.camera().eye.x, wanted.eye.x, 0.0101);
    }
    // Two recordings, one behind the other, are one way.
    std::ofstream(folder / "twice.lst") << "f.cams/000001.cam\nf.cams/000021.cam\nf.cams/000001.cam\n"
                                        << "f.cams/000021.cam\n";
    EXPECT_EQ(answer("flight from DIR/twice.lst twice 0.01"), "4");
    EXPECT_NEAR(flight("twice").keys[3].time, 2 + 1.0 / 30 + 2, 1e-9);
    answer("flight seconds a 86400");
    EXPECT_NE(why("flight export a DIR/long.lst 1000").find("86400001 frames"), std::string::npos);
    EXPECT_FALSE(exists("long.lst"));
    answer("flight seconds a 2");
    answer("camera set 9 1.8 3 0 0 -1");
    answer("flight play a 1");
    move(1ms, {});
    EXPECT_NEAR(document.camera().eye.x, 2, 1e-5);
    for (int i = 0; i < 5; ++i) move(250ms, {});
    EXPECT_EQ(document.camera().eye.x, 4);
}

} // namespace
} // namespace rtserver

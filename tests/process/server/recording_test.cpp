/// Paths that are recorded, rendered and played.
#include "process/server/live_server.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/cam.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace {

using namespace test;
using namespace std::chrono_literals;

class Recordings : public LiveServer {
  protected:
    std::vector<rtcore::CameraFile> cameras(const std::string& list) const {
        std::vector<rtcore::CameraFile> result;
        for (const auto& path : rtcore::readCameraList(folder() / list))
            result.push_back(rtcore::readCameraFile(path));
        return result;
    }
};

TEST_F(Recordings, GoAtAnEvenPace) {
    start();
    ask({"wait-idle"});
    EXPECT_EQ(ask({"export", "video"}), "off\n");
    ask({"export", "video", "start", "walk.lst", "50"});
    refused({"export", "video", "start", "other.lst"}, 1, "under way");
    EXPECT_NE(ask({"status", "--json"}).find("\"recording\":true"), std::string::npos);
    ask({"key", "press", "w", "--for=400"});
    ask({"light", "1", "off"});
    std::this_thread::sleep_for(300ms);
    const std::string list = (folder() / "walk.lst").string();
    const std::string recording = ask({"export", "video"});
    EXPECT_EQ(recording.rfind("on ", 0), 0U) << recording;
    EXPECT_GT(std::atof(recording.c_str() + 3), 0.5) << recording;
    EXPECT_NE(recording.find(' ' + list + '\n'), std::string::npos) << recording;
    const int frames = std::atoi(ask({"export", "video", "stop", "walk.lst"}).c_str());
    refused({"export", "video", "stop"}, 1, "nothing is being recorded");
    EXPECT_EQ(ask({"export", "video"}), "off " + list + "\n");

    const std::vector<rtcore::CameraFile> path = cameras("walk.lst");
    ASSERT_EQ(path.size(), static_cast<std::size_t>(frames));
    EXPECT_GT(frames, 30) << "50 a second, standing still or not";
    for (std::size_t i = 0; i < path.size(); ++i) {
        ASSERT_TRUE(path[i].time && path[i].exposure &&
                    path[i].lightsOn.size() + path[i].lightsOff.size() == 1);
        EXPECT_NEAR(*path[i].time, static_cast<double>(i) / 50, 1e-9);
    }
    EXPECT_GT(length(path.back().camera.eye - path.front().camera.eye), 0.5F);
    EXPECT_EQ(path.front().lightsOn, std::vector{1});
    EXPECT_EQ(path.back().lightsOff, std::vector{1});
    refused({"export", "video", "start", "walk.lst"}, 73, "exists");

    const ProgramResult film = renderer({"room.obj", "-l", "walk.lst", "-o", "f%03d.png", "--frames=1-3"},
                                        {.folder = folder().path()});
    EXPECT_EQ(film.exitCode, 0) << film.error;
}

TEST_F(Recordings, SurviveTheirServer) {
    start();
    ask({"export", "video", "start", "walk.lst", "100"});
    ask({"key", "press", "a"});
    std::this_thread::sleep_for(500ms);
    EXPECT_EQ(end(SIGKILL).signal, SIGKILL);
    const std::vector<rtcore::CameraFile> path = cameras("walk.lst");
    EXPECT_GT(path.size(), 20U);
    EXPECT_GT(length(path.back().camera.eye - path.front().camera.eye), 0.1F);
}

TEST_F(Recordings, ArePlayed) {
    start();
    ask({"set", "exposure.key", "0.3"});
    ask({"wait-idle"});
    ask({"export", "video", "start", "walk.lst"});
    ask({"key", "press", "d", "--for=300"});
    ask({"export", "video", "stop"});
    const std::vector<rtcore::CameraFile> path = cameras("walk.lst");

    ask({"camera", "set", "0", "3", "9", "0", "0", "-1"});
    ask({"play", "walk.lst"});
    ask({"wait-idle"});
    ask({"export", "camera", "last.cam"});
    EXPECT_EQ(rtcore::readCameraFile(folder() / "last.cam").camera, path.back().camera);
    EXPECT_EQ(ask({"get", "exposure.mode"}), "incident\n") << "a played exposure is no setting";

    ask({"play", "walk.lst"});
    ask({"key", "tap", "i"}); // a movement ends the playback
    ask({"wait-idle"});
    ask({"export", "camera", "mine.cam"});
    EXPECT_NE(rtcore::readCameraFile(folder() / "mine.cam").camera.eye, path.back().camera.eye);

    writeText(folder() / "empty.lst", "# nothing\n");
    refused({"play", "empty.lst"}, 65, "names no camera");
    refused({"play", "none.lst"}, 66, "none.lst");
    writeText(folder() / "gap.lst", path.empty() ? "" : "walk.cams/000001.cam\nnone.cam\n");
    refused({"play", "gap.lst"}, 66, "none.cam");
    ask({"exit"});

    start({"--play=walk.lst"});
    ask({"wait-idle"});
    ask({"export", "camera", "again.cam"});
    EXPECT_EQ(rtcore::readCameraFile(folder() / "again.cam").camera, path.back().camera);
}

TEST_F(Recordings, ABrokenPathEndsPlaying) {
    start();
    writeCamera(folder() / "a.cam", 0.5);
    writeText(folder() / "broken.cam", "version = 1\neye = \"here\"\n");
    writeText(folder() / "walk.lst", "a.cam\nbroken.cam\n");
    ask({"play", "walk.lst"});
    ASSERT_TRUE(server->waitForError("playing ended: ")) << server->wait().error;
    ask({"wait-idle"});
    ask({"export", "camera", "now.cam"});
}

TEST_F(Recordings, APathThatCannotBePlayedIsNoWayToBegin) {
    writeText(folder() / "empty.lst", "# nothing\n");
    for (const auto& [list, code] : {std::pair{"none.lst", 66}, std::pair{"empty.lst", 65}}) {
        for (const char* how : {"--fps-limit=0", "--daemon"}) {
            run({std::string("--play=") + list, how});
            const ProgramResult result = server->wait();
            EXPECT_EQ(result.exitCode, code) << result.error;
            EXPECT_NE(result.error.find(list), std::string::npos) << result.error;
            EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
            EXPECT_TRUE(instance.segments().empty());
        }
    }
}

} // namespace

/// A walk through a real model, from the first key to the film's frames. Needs RT_TEST_SCENES.
#include "process/server/live_server.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/cam.h"

#include <cstdlib>

namespace {

using namespace test;

class RealScene : public LiveServer {};

TEST_F(RealScene, IsWalkedRecordedAndRenderedTheSame) {
    const char* scenes = std::getenv("RT_TEST_SCENES");
    if (scenes == nullptr) GTEST_SKIP() << "skipped: RT_TEST_SCENES is not set";
    const std::string model = std::string(scenes) + "/sibenik/sibenik.obj";
    start({"--resolution=160x120"}, model);
    writeText(folder() / "walk.txt", "export video start walk.lst\nkey press shift\n"
                                     "key press w --for 3600\ncamera turn 170 0\nkey press w --for 3200\n"
                                     "camera turn -60 10\nkey tap space\nkey press w --for 400\n"
                                     "key release all\nexport video stop\n");
    writeText(folder() / "end.txt", "screenshot a.png\nexport camera a.cam\nexport scene a.scn\nexit\n");
    // Each has its own minute: learning the light of a view takes seconds even of a machine that is idle.
    ask({"walk"});
    ask({"wait-idle"});
    ask({"script", "walk.txt"});
    ask({"wait-idle"});
    ask({"script", "end.txt"});
    const auto list = rtcore::readCameraList(folder() / "walk.lst");
    ASSERT_GT(list.size(), 100U);
    double metres = 0;
    rtcore::Vec3 last = rtcore::readCameraFile(list.front()).camera.eye;
    for (const auto& file : list) {
        const rtcore::Vec3 eye = rtcore::readCameraFile(file).camera.eye;
        metres += static_cast<double>(length(eye - last));
        last = eye;
    }
    EXPECT_GT(metres, 20);

    const ProgramResult still =
        renderer({"a.scn", "--camera=a.cam", "-o", "b.png"}, {.folder = folder().path()});
    EXPECT_EQ(still.exitCode, 0) << still.error;
    EXPECT_TRUE(bytes("b.png") == bytes("a.png"));
    start({"--camera=a.cam", "--resolution=160x120"}, model);
    ask({"wait-idle"});
    ask({"screenshot", "c.png"});
    EXPECT_TRUE(bytes("c.png") == bytes("a.png")) << "started again where it was";
    const ProgramResult film = renderer({"a.scn", "-l", "walk.lst", "-o", "f%04d.png", "--frames=50-54"},
                                        {.folder = folder().path()});
    EXPECT_EQ(film.exitCode, 0) << film.error;
}

} // namespace

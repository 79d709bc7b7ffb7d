/// The live view and the Renderer agree: a screenshot is, bit for bit, what the Renderer makes of the
/// exported view.
#include "process/server/live_server.h"

#include "rtcore/io/recording/camera_list.h"

#include <chrono>
#include <thread>

namespace {

using namespace test;
using namespace std::chrono_literals;

class Pictures : public LiveServer {
  protected:
    void exportAll(const std::string& name) {
        ask({"wait-idle"});
        ask({"screenshot", name + ".png"});
        ask({"export", "camera", name + ".cam"});
        ask({"export", "scene", name + ".scn"});
    }
    std::string rendered(const Names& words) {
        Names all = words;
        all.insert(all.end(), {"-o", "rendered.png", "--force"});
        const ProgramResult result = renderer(all, {.folder = folder().path()});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return bytes("rendered.png");
    }
};

TEST_F(Pictures, AreThoseOfTheRenderer) {
    start({"--setting=antialiasing=2"});
    ask({"set", "maxDepth", "3"});
    ask({"resolution", "97", "61"});
    ask({"camera", "look-at", "1", "2", "7.5", "-0.5", "0.3", "0", "71"});
    ask({"key", "tap", "w"});
    ask({"key", "press", "d"});
    ask({"key", "release", "d"});
    exportAll("view");
    const std::string shown = bytes("view.png");
    EXPECT_EQ(pngSize(shown), (PictureSize{97, 61}));
    EXPECT_EQ(rendered({"view.scn", "--camera=view.cam"}), shown) << "with the exposure of the .cam";
    EXPECT_EQ(rendered({"view.scn"}), shown) << "with an exposure of its own";

    ask({"exit"});
    start({"--camera=view.cam", "--setting=maxDepth=3", "--resolution=97x61"});
    exportAll("again");
    EXPECT_EQ(bytes("again.png"), shown);
    EXPECT_EQ(bytes("again.cam"), bytes("view.cam"));
}

TEST_F(Pictures, FollowEachChange) {
    start();
    exportAll("before");
    ask({"light", "1", "off"});
    exportAll("dark");
    EXPECT_NE(bytes("dark.png"), bytes("before.png"));
    EXPECT_EQ(rendered({"dark.scn"}), bytes("dark.png")) << "the scene knows which lights are on";
    ask({"light", "1", "on"});
    ask({"wait-idle"});
    EXPECT_EQ(ask({"screenshot", "after.png"}), "live frame, 64 x 48\n")
        << "not what a window renders at rest";
    EXPECT_EQ(bytes("after.png"), bytes("before.png"));
}

TEST_F(Pictures, OfASceneFileKeepItsParts) {
    writeText(folder() / "nave.scn",
              "version = 1\nmodel = \"room.obj\"\nbackground = [0.1, 0.2, 0.3]\n"
              "ambient = [0.05, 0.05, 0.05]\n[[light]]\nkind = \"spot\"\n"
              "position = [2.0, 8.0, 4.0]\ndirection = [-0.3, -1.0, -0.6]\n"
              "intensity = [300.0, 250.0, 200.0]\nouterAngle = 40.0\ninnerAngle = 21.0\n"
              "[[material]]\nname = \"*\"\nreflectivity = [0.3, 0.3, 0.3]\n"
              "[live]\nexposure.key = 0.3\n");
    start({}, "nave.scn");
    exportAll("view");
    EXPECT_EQ(rendered({"view.scn"}), bytes("view.png"));
}

TEST_F(Pictures, WithEveryEffectAreThoseOfTheRendererAndOfFilms) {
    writeText(folder() / "foggy.scn", "version = 1\nmodel = \"room.obj\"\nbackground = [5.0, 5.0, 6.0]\n"
                                      "[[light]]\nkind = \"sphere\"\nposition = [2.0, 8.0, 4.0]\n"
                                      "radius = 0.5\nintensity = [900.0, 700.0, 500.0]\n"
                                      "[fog]\nkind = \"homogeneous\"\ndensity = 0.03\n"
                                      "[live]\nantialiasing = 3\nadaptive = 0.1\nsampling = \"poisson\"\n"
                                      "denoise = 1\nbloom = 3\nexposure.local = 0.5\nexposure.key = 0.3\n"
                                      "ambientOcclusion.on = true\ndepthOfField.on = true\nfog.shafts = 3\n");
    start({}, "foggy.scn");
    ask({"export", "video", "start", "walk.lst"});
    ask({"camera", "turn", "12", "-3"});
    exportAll("view");
    ask({"screenshot", "view.exr"});
    std::this_thread::sleep_for(100ms); // three moments at least of what the screenshots show
    ask({"export", "video", "stop"});
    EXPECT_TRUE(rendered({"view.scn", "--camera=view.cam", "-o", "rendered.exr"}) == bytes("view.png"));
    EXPECT_TRUE(bytes("rendered.exr") == bytes("view.exr"));
    const std::string last = std::to_string(rtcore::readCameraList(folder() / "walk.lst").size());
    rendered({"view.scn", "--list=walk.lst", "--frames=" + last + "-" + last, "-o", "film#.exr", "-o",
              "film#.png"});
    EXPECT_TRUE(bytes("film" + last + ".png") == bytes("view.png"));
    EXPECT_TRUE(bytes("film" + last + ".exr") == bytes("view.exr"));
}

TEST_F(Pictures, KeepTheAspectAndTheKindOfACamera) {
    start();
    for (const std::string kind : {"fov = 50.0\n", "orthographicWidth = 9.5\n"}) {
        writeText(folder() / "a.cam", "version = 1\neye = [1.0, 2.0, 7.5]\nforward = [-0.2, -0.2, -1.0]\n"
                                      "aspect = 0.75\nwidth = 90\nheight = 50\n" +
                                          kind);
        ask({"load", "camera", "a.cam"});
        ask({"key", "tap", "d"});
        exportAll("view");
        EXPECT_TRUE(rendered({"view.scn", "--camera=view.cam"}) == bytes("view.png"));
        ask({"resolution", "40", "64"});
        exportAll("tall");
        EXPECT_TRUE(rendered({"view.scn", "--camera=tall.cam"}) == bytes("tall.png"));
        EXPECT_NE(bytes("tall.cam").find(kind + "aspect = 0.75\n"), std::string::npos) << bytes("tall.cam");
    }
}

TEST_F(Pictures, LoadedCamerasAreLookedThrough) {
    start();
    writeCamera(folder() / "a.cam", 1.5, "width = 50\nheight = 40\nexposure = 0.75\n");
    ask({"load", "camera", "a.cam"});
    ask({"wait-idle"});
    ask({"screenshot", "a.png"});
    EXPECT_EQ(rendered({"room.obj", "--camera=a.cam"}), bytes("a.png"));
}

} // namespace

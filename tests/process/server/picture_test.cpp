/// The live view and the Renderer agree: a screenshot is, bit for bit, what the Renderer makes of the
/// exported view.
#include "process/server/live_server.h"

namespace {

using namespace test;

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
    ask({"light", "0", "off"});
    exportAll("dark");
    EXPECT_NE(bytes("dark.png"), bytes("before.png"));
    EXPECT_EQ(rendered({"dark.scn"}), bytes("dark.png")) << "the scene knows which lights are on";
    ask({"light", "0", "on"});
    ask({"wait-idle"});
    ask({"screenshot", "after.png"});
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

TEST_F(Pictures, LoadedCamerasAreLookedThrough) {
    start();
    writeCamera(folder() / "a.cam", 1.5, "width = 50\nheight = 40\nexposure = 0.75\n");
    ask({"load", "camera", "a.cam"});
    ask({"wait-idle"});
    ask({"screenshot", "a.png"});
    EXPECT_EQ(rendered({"room.obj", "--camera=a.cam"}), bytes("a.png"));
}

} // namespace

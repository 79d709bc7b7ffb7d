/// --hide, --show, --isolate and --lights: the same bits as by commands, and as by a scene that was saved.
#include "process/server/live_server.h"

#include <csignal>

namespace {

using namespace test;

class SelectionOptions : public LiveServer {
  protected:
    void SetUp() override {
        writeText(folder() / "room.obj", "v -4 0 -4\nv 4 0 -4\nv 4 0 4\nv -4 0 4\nv 4 5 -4\nv -4 5 -4\n"
                                         "v -1 1 0\nv 1 1 0\nv 0 2.5 0\no floor\nf 1 2 3\nf 1 3 4\n"
                                         "o wall\nf 1 2 5\nf 1 5 6\no ball\nf 7 8 9\n");
        writeText(folder() / "room.scn",
                  "version = 2\nmodel = 'room.obj'\n[camera]\neye = [0, 1.7, 6]\nlookAt = [0, 1.5, 0]\n"
                  "[[light]]\nname = 'spot'\nkind = 'point'\nposition = [2, 4, 3]\nintensity = [30, 28, 25]\n"
                  "[[light]]\nid = 9\nkind = 'point'\nposition = [-2, 3, 2]\nintensity = [9, 9, 19]\n"
                  "[still]\nexposure.mode = 'fixed'\n[live]\nexposure.mode = 'fixed'\n");
    }
    ProgramResult render(const Names& options, const std::string& scene) const {
        Names words{scene, "-o", "still.png", "-w", "64", "-h", "48", "--force"};
        words.insert(words.end(), options.begin(), options.end());
        return renderer(words, {.folder = folder().path()});
    }
    std::string rendered(const Names& options, const std::string& scene = "room.scn") const {
        const ProgramResult result = render(options, scene);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return bytes("still.png");
    }
    std::string shot() const {
        ask({"wait-idle"});
        ask({"screenshot", "shot.png"});
        return bytes("shot.png");
    }
};

TEST_F(SelectionOptions, GiveTheBitsOfCommandsAndOfSavedScenes) {
    struct Case {
        Names options;
        std::vector<Names> commands;
    };
    start({}, "room.scn");
    std::vector<std::string> images{shot()};
    for (const Case& each :
         {Case{{"--hide=ball"}, {{"part", "hide", "ball"}}},
          Case{{"--isolate=2"}, {{"part", "isolate", "2"}}},
          Case{{"--hide=*", "--show=*l"}, {{"part", "hide", "*"}, {"part", "show", "*l"}}},
          Case{{"--lights=9"}, {{"light", "1", "off"}}},
          Case{{"--lights=none", "--hide=wall"},
               {{"light", "1", "off"}, {"light", "9", "off"}, {"part", "hide", "wall"}}}}) {
        SCOPED_TRACE(testing::PrintToString(each.options));
        for (const Names& command : each.commands) ask(command);
        const std::string image = shot();
        EXPECT_TRUE(rendered(each.options) == image);
        const std::string saved = "saved" + std::to_string(images.size()) + ".scn";
        ask({"save", "as", saved});
        EXPECT_TRUE(rendered({}, saved) == image);
        for (const std::string& other : images) EXPECT_FALSE(image == other);
        images.push_back(image);
        ask({"part", "show-all"});
        ask({"light", "1", "on"});
        ask({"light", "9", "on"});
        EXPECT_TRUE(shot() == images.front());
    }
}

TEST_F(SelectionOptions, OfTheServerAreForItsFirstScene) {
    start({"--hide=ball", "--lights=spot"}, "room.scn");
    EXPECT_TRUE(shot() == rendered({"--hide=ball", "--lights=spot"}));
    EXPECT_EQ(ask({"lights"}), "1 on spot\n9 off\n");
    ask({"load", "scene", "room.scn"});
    EXPECT_TRUE(shot() == rendered({}));
}

TEST_F(SelectionOptions, CountForEveryCamera) {
    writeCamera(folder() / "on.cam", 0, "lights = [true, true]\n");
    EXPECT_TRUE(rendered({"--camera=on.cam", "--lights=9"}) ==
                rendered({"--camera=on.cam", "--lights=none", "--lights=9"}));
    EXPECT_FALSE(rendered({"--camera=on.cam", "--lights=9"}) == rendered({"--camera=on.cam"}));
}

TEST_F(SelectionOptions, WhatIsNotThereIsRefused) {
    for (const std::string option : {"--hide=attic", "--isolate=4", "--show=attic", "--lights=2"}) {
        const ProgramResult result = render({option}, "room.scn");
        EXPECT_EQ(result.exitCode, 2) << option;
        EXPECT_NE(result.error.find("; it has "), std::string::npos) << result.error;
        run({option}, "room.scn");
        const ProgramResult served = server->wait();
        EXPECT_EQ(served.exitCode, 2) << option;
        EXPECT_NE(served.error.find("; it has "), std::string::npos) << served.error;
    }
}

} // namespace

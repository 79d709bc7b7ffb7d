/// Renderer --stand-by: one image after another, as lines on its standard input ask for them.
#include "process/preview/live_preview.h"

#include "rtcore/io/images/image_file.h"

#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

using namespace test;

class StandBy : public LivePreview {
  protected:
    void SetUp() override {
        LivePreview::SetUp();
        for (int i = 0; i < 3; ++i) writeCamera(folder() / (std::to_string(i) + ".cam"), i);
        writeText(folder() / "a.scn",
                  "version = 2\nmodel = \"room.bsp\"\ndefaultLight = false\n[[light]]\nkind = \"point\"\n"
                  "position = [0.0, 2.0, 1.0]\nintensity = [5.0, 5.0, 5.0]\n");
        ASSERT_EQ(::mkfifo((folder() / "requests").c_str(), 0600), 0);
    }
    ~StandBy() override { endInput(); }

    void begin(const std::string& options) {
        program.emplace("/bin/sh",
                        Names{"-c", "exec " + programPath("Renderer").string() +
                                        " a.scn --camera=0.cam -w 60 -h 45 --progress=none -v --stand-by "
                                        "--run-id=1 --preview=" +
                                        instance.name() + " " + options + " < requests"},
                        ProgramSettings{.folder = folder().path()});
        input_ = ::open((folder() / "requests").c_str(), O_WRONLY | O_CLOEXEC);
        ASSERT_GE(input_, 0);
        look();
    }
    void write(const std::string& line) const {
        const std::string bytes = line + "\n";
        ASSERT_EQ(::write(input_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    void ask(int run, const std::string& scene, const std::string& camera) const {
        write(std::to_string(run) + "\t" + scene + "\t" + camera);
    }
    void endInput() {
        if (input_ >= 0) ::close(std::exchange(input_, -1));
    }
    /// Waits for the last frame of a run.
    ipc::Frame lastOf(std::uint64_t run) {
        ipc::Frame frame;
        while (viewer->waitForFrame(frame, std::chrono::seconds(60)))
            if (frame.info.run == run && frame.info.tag == ipc::kPreviewDone) return frame;
        ADD_FAILURE() << "run " << run << " did not end";
        return frame;
    }
    /// Whether the frame is the file that the Renderer writes by itself.
    bool isImageOf(const ipc::Frame& frame, const std::string& scene, const std::string& camera) const {
        EXPECT_EQ(renderer({scene, "--camera=" + camera, "-w", "60", "-h", "45", "-o", "own.png"},
                           {.folder = folder().path()})
                      .exitCode,
                  0);
        const rtcore::LdrImage own = rtcore::readLdrImage(folder() / "own.png");
        return frame.pixels.size() == own.pixels.size() * sizeof(rtcore::Rgba8) &&
               std::memcmp(frame.pixels.data(), own.pixels.data(), frame.pixels.size()) == 0;
    }
    /// How often the scene was loaded; after the end.
    int loads() {
        endInput();
        const ProgramResult result = program->wait();
        EXPECT_EQ(result.exitCode, 0) << result.error;
        int count = 0;
        for (std::size_t at = 0; (at = result.error.find("reading the scene took", at)) != std::string::npos;
             ++at)
            ++count;
        return count;
    }

  private:
    int input_ = -1;
};

TEST_F(StandBy, ShowsOneViewAfterAnotherOfASceneThatIsLoadedOnce) {
    begin("");
    EXPECT_TRUE(isImageOf(lastOf(1), "a.scn", "0.cam"));
    ask(2, "a.scn", "1.cam");
    EXPECT_TRUE(isImageOf(lastOf(2), "a.scn", "1.cam"));
    writeText(folder() / "b.scn", test::readBytes(folder() / "a.scn") +
                                      "[camera]\neye = [0.0, 1.0, 3.0]\nforward = [0.0, 0.0, -1.0]\n");
    ask(3, "b.scn", "2.cam");
    EXPECT_TRUE(isImageOf(lastOf(3), "b.scn", "2.cam"));
    EXPECT_EQ(loads(), 1) << "another camera in the description is no other scene";
}

TEST_F(StandBy, LoadsAgainWhatHasChanged) {
    begin("");
    lastOf(1);
    writeText(folder() / "b.scn",
              "version = 1\nmodel = \"room.bsp\"\n[[light]]\nkind = \"point\"\nposition = [0.0, 2.0, 1.0]\n"
              "intensity = [5.0, 1.0, 1.0]\n");
    ask(2, "b.scn", "0.cam");
    EXPECT_TRUE(isImageOf(lastOf(2), "b.scn", "0.cam"));
    writeText(folder() / "c.scn", "version = 1\nmodel = \"room.obj\"\n");
    ask(3, "c.scn", "0.cam");
    EXPECT_TRUE(isImageOf(lastOf(3), "c.scn", "0.cam"));
    writeText(folder() / "room.obj", "v -9 0 -9\nv 9 0 -9\nv 0 0 9\nf 1 3 2\n");
    ask(4, "c.scn", "0.cam");
    EXPECT_TRUE(isImageOf(lastOf(4), "c.scn", "0.cam")) << "the model's file is another one";
    ask(5, "room.obj", "0.cam");
    lastOf(5);
    writeText(folder() / "room.obj", "v -9 0 -9\nv 9 0 -9\nv 0 2 9\nf 1 3 2\n");
    ask(6, "room.obj", "0.cam");
    EXPECT_TRUE(isImageOf(lastOf(6), "room.obj", "0.cam")) << "the same where it is the scene itself";
    EXPECT_EQ(loads(), 6);
}

TEST_F(StandBy, GivesUpWhatIsNotWantedAnyMore) {
    begin("-a 16 --ambient-occlusion --ao-samples=4096");
    write("");
    ask(2, "gone.scn", "0.cam");
    ask(3, "a.scn", "1.cam");
    write("");
    EXPECT_EQ(loads() / 2, 0) << "once, or not even that";
}

TEST_F(StandBy, EndsWithASentenceWhereARequestIsBad) {
    begin("");
    lastOf(1);
    write("2 a.scn 1.cam");
    const ProgramResult result = program->wait();
    EXPECT_EQ(result.exitCode, 65) << result.error;
    EXPECT_NE(result.error.find("standard input"), std::string::npos) << result.error;
}

TEST_F(StandBy, EndsWhereASceneIsMissing) {
    begin("");
    lastOf(1);
    ask(2, "gone.scn", "1.cam");
    EXPECT_EQ(program->wait().exitCode, 66);
}

TEST_F(StandBy, NeedsAPreviewAndWritesNothing) {
    EXPECT_EQ(renderer({"a.scn", "--stand-by"}, {.folder = folder().path()}).exitCode, 2);
    EXPECT_EQ(run({"--stand-by", "-o", "a.png"}).exitCode, 2);
}

} // namespace

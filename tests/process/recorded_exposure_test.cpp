/// Recorded walks rendered by paths: what becomes of their exposures, and of the noise from frame to frame.
#include "process/sample_scene.h"

#include "rtcore/io/images/image_file.h"

#include <gtest/gtest.h>

namespace {

using Words = std::vector<std::string>;

class RecordedExposure : public testing::Test {
  protected:
    // A closed white room with a light, in which paths bring much more of it. The second camera looks into a
    // corner, where they do so even more.
    void SetUp() override {
        test::writeText(folder / "den.obj",
                        "v -4 0 -6\nv 4 0 -6\nv 4 0 8\nv -4 0 8\n"
                        "v -4 5 -6\nv 4 5 -6\nv 4 5 8\nv -4 5 8\n"
                        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n");
        test::writeText(folder / "den.scn", "version = 1\nmodel = \"den.obj\"\n[[light]]\nkind = \"point\"\n"
                                            "position = [0.0, 2.5, 0.0]\nintensity = [9.0, 9.0, 9.0]\n");
        test::writeCamera(folder / "1.cam", 0, "exposure = 0.9\n");
        test::writeText(folder / "2.cam", "version = 1\neye = [3.0, 4.0, 6.0]\nforward = [1.0, -0.5, 1.5]\n"
                                          "exposure = 0.7\n");
        test::writeText(folder / "walk.lst", "1.cam\n2.cam\n");
    }

    test::ProgramResult run(Words extra) {
        extra.insert(extra.begin(), {"den.scn", "-w", "32", "-h", "18", "--force"});
        return test::renderer(extra, {.folder = folder.path()});
    }
    void render(Words extra) {
        const test::ProgramResult result = run(std::move(extra));
        EXPECT_EQ(result.exitCode, 0) << result.error;
    }
    /// The list by paths into NAME1.png and NAME2.png.
    void renderWalk(const std::string& name, Words extra) {
        extra.insert(extra.end(),
                     {"-l", "walk.lst", "--integrator=path", "--samples=16", "-o", name + "#.png"});
        render(std::move(extra));
    }
    bool same(const std::string& a, const std::string& b) const {
        return test::readBytes(folder / a) == test::readBytes(folder / b);
    }
    /// The mean of the display's green values, 0..255.
    double brightness(const std::string& name) const {
        const rtcore::LdrImage image = rtcore::readLdrImage(folder / name);
        double sum = 0;
        for (const rtcore::Rgba8& pixel : image.pixels) sum += pixel.g;
        return sum / static_cast<double>(image.pixels.size());
    }

    test::TemporaryFolder folder;
};

TEST_F(RecordedExposure, ExactIsWhatTheCameraSays) {
    renderWalk("f", {"--setting=exposure.recorded=exact"});
    render({"--camera", "2.cam", "--integrator=path", "--samples=16", "--exposure=0.7", "-o", "own.png"});
    EXPECT_TRUE(same("f2.png", "own.png"));
}

TEST_F(RecordedExposure, AutomaticIsMeasured) {
    renderWalk("f", {"--setting=exposure.recorded=automatic"});
    render({"--camera", "2.cam", "--integrator=path", "--samples=16", "--setting=exposure.mode=automatic",
            "-o", "own.png"});
    EXPECT_TRUE(same("f2.png", "own.png"));
}

TEST_F(RecordedExposure, ScaledTheFirstFrameIsAsBrightAsRecorded) {
    render({"--camera", "1.cam", "-o", "live.png"});
    renderWalk("scaled", {});
    renderWalk("exact", {"--setting=exposure.recorded=exact"});
    const double live = brightness("live.png");
    EXPECT_GT(brightness("exact1.png"), 1.2 * live);
    EXPECT_NEAR(brightness("scaled1.png"), live, 0.1 * live);
}

// Whoever renders which part of the list.
TEST_F(RecordedExposure, ScaledIsByTheListsFirstFrame) {
    renderWalk("whole", {});
    renderWalk("part", {"--frames=2", "--threads=1"});
    EXPECT_TRUE(same("part2.png", "whole2.png"));
    renderWalk("chunk", {"--chunk=2/2"});
    EXPECT_TRUE(same("chunk2.png", "whole2.png"));
    test::writeText(folder / "walk.lst", "1.cam\n2.cam\n# end\n");
    renderWalk("followed", {"--follow", "--follow-timeout=1", "--frames=2"});
    EXPECT_TRUE(same("followed2.png", "whole2.png"));
    render({"--camera", "2.cam", "--integrator=path", "--samples=16", "-o", "own.png"});
    EXPECT_FALSE(same("own.png", "whole2.png")) << "by itself";
}

TEST_F(RecordedExposure, LightsOfTheFirstFrameStayThere) {
    test::writeText(folder / "unlit.cam", "version = 1\neye = [3.0, 4.0, 6.0]\nforward = [1.0, -0.5, 1.5]\n"
                                          "lights = [false]\n");
    test::writeText(folder / "walk.lst", "unlit.cam\n2.cam\n");
    renderWalk("f", {"--frames=2"});
    renderWalk("exact", {"--frames=2", "--setting=exposure.recorded=exact"});
    EXPECT_TRUE(same("f2.png", "exact2.png")) << "black by either, which scales nothing";
    EXPECT_GT(brightness("f2.png"), 20);
}

TEST_F(RecordedExposure, WithoutPathsScaledIsExact) {
    render({"--camera", "1.cam", "-o", "scaled.png"});
    render({"--camera", "1.cam", "--setting=exposure.recorded=exact", "-o", "exact.png"});
    EXPECT_TRUE(same("scaled.png", "exact.png"));
}

TEST_F(RecordedExposure, OneOfTheCommandLineIsNotScaled) {
    renderWalk("scaled", {"--exposure=0.9"});
    renderWalk("exact", {"--exposure=0.9", "--setting=exposure.recorded=exact"});
    EXPECT_TRUE(same("scaled1.png", "exact1.png"));
}

TEST_F(RecordedExposure, ABadFirstFrameIsNamedByTheOthers) {
    test::writeText(folder / "1.cam", "version = 1\neye = \"here\"\n");
    const test::ProgramResult result =
        run({"-l", "walk.lst", "--integrator=path", "--samples=1", "--frames=2", "-o", "f#.png"});
    EXPECT_EQ(result.exitCode, 65) << result.error;
    EXPECT_NE(result.error.find("1.cam:2"), std::string::npos) << result.error;
}

TEST_F(RecordedExposure, FramesMayHaveNoiseOfTheirOwn) {
    test::writeText(folder / "walk.lst", "1.cam\n1.cam\n");
    const Words exact{"--setting=exposure.recorded=exact"};
    renderWalk("still", exact);
    EXPECT_TRUE(same("still1.png", "still2.png"));
    renderWalk("moving", {exact[0], "--setting=path.seedPerFrame=on", "--setting=path.seed=3"});
    EXPECT_FALSE(same("moving1.png", "moving2.png"));
    render({"--camera", "1.cam", exact[0], "--integrator=path", "--samples=16", "--setting=path.seed=5", "-o",
            "own.png"});
    EXPECT_TRUE(same("moving2.png", "own.png"));
}

} // namespace

/// Films of flights and of turntables: their frames are those of the lists that can be written of them.
#include "process/sample_scene.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/cam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace {

using Names = std::vector<std::string>;

class FlightFilms : public testing::Test {
  protected:
    void SetUp() override {
        test::writeRoom(folder / "room.obj");
        test::writeText(folder / "room.scn",
                        "version = 2\nmodel = \"room.obj\"\n[[flight]]\nname = \"in\"\nseconds = 1\n"
                        "[[flight.key]]\neye = [-1, 1, 2]\nforward = [0, 0, -1]\n"
                        "[[flight.key]]\neye = [0, 1, 1.5]\nforward = [0.3, 0, -1]\nexposure = 0.5\n"
                        "[[flight.key]]\neye = [1, 1, 2]\nforward = [0, 0, -1]\n");
    }
    test::ProgramResult render(Names extra) const {
        extra.insert(extra.begin(), {"-w", "24", "-h", "18", "--setting=indirect.mode=off"});
        return test::renderer(extra, {.folder = folder.path()});
    }
    test::ProgramResult flight(Names extra) const {
        extra.insert(extra.begin(), {"room.scn", "--flight=in", "--fps=5"});
        return render(extra);
    }
    std::string bytes(const std::string& file) const { return test::readBytes(folder / file); }

    test::TemporaryFolder folder;
};

TEST_F(FlightFilms, HaveTheFramesOfTheListThatIsWrittenOfThem) {
    const test::ProgramResult all = flight({"-o", "a#.png"});
    ASSERT_EQ(all.exitCode, 0) << all.error;
    ASSERT_EQ(flight({"--make-list=in.lst"}).exitCode, 0);
    EXPECT_EQ(rtcore::readCameraList(folder / "in.lst").size(), 6U);
    ASSERT_EQ(render({"room.scn", "-l", "in.lst", "-o", "l#.png"}).exitCode, 0);
    ASSERT_EQ(flight({"-o", "b#.png", "--chunk=2/2", "--threads=1"}).exitCode, 0);
    for (const char* const frame : {"1", "2", "3", "4", "5", "6"})
        EXPECT_EQ(bytes(std::string("a") + frame + ".png"), bytes(std::string("l") + frame + ".png"));
    EXPECT_EQ(bytes("b6.png"), bytes("a6.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "b3.png"));
    EXPECT_NE(bytes("a1.png"), bytes("a6.png"));
}

TEST_F(FlightFilms, AreVerifiedWithoutTheModel) {
    ASSERT_EQ(flight({"-o", "a#.png", "--frames=2-6"}).exitCode, 0);
    std::filesystem::remove(folder / "room.obj");
    const test::ProgramResult verified = flight({"-o", "a#.png", "--verify"});
    EXPECT_EQ(verified.exitCode, 1) << verified.error;
    EXPECT_NE(verified.output.find("1\ta1.png\tmissing"), std::string::npos) << verified.output;
    EXPECT_NE(verified.error.find("1 of 6 frames"), std::string::npos) << verified.error;
}

TEST_F(FlightFilms, OfATurntableGoOnceAround) {
    const Names table{"room.obj", "--turntable=2", "--fps=4"};
    Names list = table, back = table;
    list.push_back("--make-list=table.lst");
    const test::ProgramResult made = render(list);
    ASSERT_EQ(made.exitCode, 0) << made.error;
    const auto cameras = rtcore::readCameraList(folder / "table.lst");
    ASSERT_EQ(cameras.size(), 8U);
    const rtcore::Vec3 first = rtcore::readCameraFile(cameras[0]).camera.eye;
    const rtcore::Vec3 half = rtcore::readCameraFile(cameras[4]).camera.eye;
    EXPECT_NEAR(first.y, half.y, 1e-5F);
    EXPECT_GT(length(first - half), 1.0F);
    // All that a .cam says counts for the film, too.
    test::writeText(folder / "own.cam", "version = 1\neye = [0, 1, 2]\nforward = [0, 0, -1]\nup = [0, 1, 0]\n"
                                        "fov = 60\nexposure = 0.5\nantialiasing = 3\n");
    ASSERT_EQ(
        render({"room.obj", "--turntable=2", "--fps=4", "--camera=own.cam", "--make-list=own.lst"}).exitCode,
        0);
    const rtcore::CameraFile own = rtcore::readCameraFile(rtcore::readCameraList(folder / "own.lst")[3]);
    EXPECT_EQ(own.exposure, 0.5F);
    EXPECT_EQ(own.antialiasing, 3);
    back.insert(back.end(), {"--turns=-0.5", "--make-list=back.lst"});
    ASSERT_EQ(render(back).exitCode, 0);
    const auto reversed = rtcore::readCameraList(folder / "back.lst");
    ASSERT_EQ(reversed.size(), 9U);
    EXPECT_LT(length(rtcore::readCameraFile(reversed[8]).camera.eye - half), 1e-4F);
}

TEST_F(FlightFilms, HaveTheExposureOfTheWholeInEachPart) {
    const auto exposures = [&](const std::string& list) {
        std::vector<std::optional<float>> all;
        for (const auto& camera : rtcore::readCameraList(folder / list))
            all.push_back(rtcore::readCameraFile(camera).exposure);
        return all;
    };
    const Names table{"room.obj", "--turntable=2", "--fps=4"};
    const auto with = [&](Names words) {
        words.insert(words.begin(), table.begin(), table.end());
        const test::ProgramResult result = render(words);
        EXPECT_EQ(result.exitCode, 0) << result.error;
    };
    with({"--make-list=table.lst"});
    const auto around = exposures("table.lst");
    ASSERT_EQ(around.size(), 8U);
    ASSERT_TRUE(around[0]);
    EXPECT_EQ(std::count(around.begin(), around.end(), around[0]), 8) << "it flickers";
    with({"--make-list=one.lst", "--threads=1"});
    EXPECT_EQ(exposures("one.lst"), around);
    with({"--make-list=paths.lst", "--setting=integrator=path"});
    EXPECT_TRUE(exposures("paths.lst")[0]);
    // Unless each image is to find its own.
    with({"--make-list=each.lst", "--setting=exposure.mode=automatic"});
    EXPECT_FALSE(exposures("each.lst")[0]);
    with({"--make-list=anew.lst", "--setting=exposure.recorded=automatic"});
    EXPECT_FALSE(exposures("anew.lst")[0]);

    test::writeText(folder / "free.scn",
                    "version = 2\nmodel = \"room.obj\"\n[[flight]]\nname = \"in\"\nseconds = 1\n"
                    "[[flight.key]]\neye = [-1, 1, 2]\nforward = [0, 0, -1]\n"
                    "[[flight.key]]\neye = [1, 1, 2]\nforward = [0, 0, 1]\n");
    const Names film{"free.scn", "--flight=in", "--fps=5", "--setting=integrator=path",
                     "--setting=path.samples=4"};
    const auto filmed = [&](Names words) {
        words.insert(words.begin(), film.begin(), film.end());
        const test::ProgramResult result = render(words);
        EXPECT_EQ(result.exitCode, 0) << result.error;
    };
    filmed({"-o", "a#.png"});
    filmed({"-o", "b#.png", "--chunk=2/2", "--threads=1"});
    EXPECT_EQ(bytes("b6.png"), bytes("a6.png"));
    filmed({"--make-list=free.lst"});
    ASSERT_EQ(render({"free.scn", "-l", "free.lst", "-o", "l#.png", film[3], film[4]}).exitCode, 0);
    for (const char* const frame : {"1", "4", "6"})
        EXPECT_EQ(bytes(std::string("a") + frame + ".png"), bytes(std::string("l") + frame + ".png"));
}

TEST_F(FlightFilms, OfOddOrdersAreRefused) {
    const auto refused = [&](const Names& words, int code, const std::string& part) {
        const test::ProgramResult result = render(words);
        EXPECT_EQ(result.exitCode, code) << result.error;
        EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
    };
    refused({"room.scn", "--flight=out", "-o", "a#.png"}, 66, "no flight 'out', but 'in'");
    refused({"room.scn", "--flight=out", "-o", "a#.png", "--verify"}, 66, "no flight 'out', but 'in'");
    refused({"room.obj", "--flight=out", "-o", "a#.png"}, 66, "a .scn has them");
    refused({"room.scn", "--flight=in", "--turntable=2"}, 2, "exclude each other");
    refused({"room.scn", "--flight=in", "--list=a.lst"}, 2, "leave out --flight");
    refused({"room.scn", "--flight=in", "--camera=a.cam"}, 2, "a flight has its cameras");
    refused({"room.scn", "--turns=2"}, 2, "--turns needs --turntable");
    refused({"room.scn", "--turntable=2", "--turns=0"}, 2, "other than 0");
    refused({"room.scn", "--make-list=a.lst"}, 2, "--make-list needs");
    refused({"room.scn", "--flight=in", "--make-list=a.lst", "-o", "a.png"}, 2, "leave out --output");
    refused({"room.scn", "--fps=3", "-o", "a.png"}, 2, "--fps needs");
    refused({"room.scn", "--flight=in", "--follow", "-o", "a#.png"}, 2, "--follow needs --list");
    refused({"room.scn", "--turntable=86400", "--fps=1000", "-o", "a#.png"}, 2, "frames at that rate");
    refused({"room.scn", "--turntable=86400", "--fps=1000", "-o", "a#.png", "--verify"}, 2,
            "frames at that rate");
    test::writeText(folder / "there.lst", "mine\n");
    refused({"room.scn", "--flight=in", "--make-list=there.lst"}, 73, "there.lst");
    EXPECT_EQ(bytes("there.lst"), "mine\n");
}

} // namespace

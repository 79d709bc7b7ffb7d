#include "rtcore/io/text/cam.h"

#include "support/temporary_folder.h"
#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

using rtcore::CameraFile;
using rtcore::parseCameraFile;

const std::string kMin = "version = 1\neye = [1, 2, 3]\nforward = [0, 0, -1]\n";

std::string problem(const std::string& text) {
    return test::badData([&] { parseCameraFile(text, "x.cam"); });
}
/// The problem of the least file with one line more, the fourth.
std::string problemWith(const std::string& line) { return problem(kMin + line); }

TEST(Cam, TheLeastFileHasDefaults) {
    const CameraFile file = parseCameraFile(kMin, "x.cam");
    EXPECT_EQ(file.camera.eye, (rtcore::Vec3{1, 2, 3}));
    EXPECT_EQ(file.camera.forward, (rtcore::Vec3{0, 0, -1}));
    EXPECT_EQ(file.camera.up, (rtcore::Vec3{0, 1, 0}));
    EXPECT_EQ(file.camera.horizontalFov, 60.0F);
    EXPECT_FALSE(file.width || file.height || file.antialiasing || file.bloom || file.exposure ||
                 file.lights || file.environment || file.time);
}

TEST(Cam, EveryKeyIsRead) {
    const CameraFile file = parseCameraFile(
        kMin + "up=[1,0,0]\nfov=150\nwidth=320\nheight=240\nantialiasing=3\nbloom=9\nexposure=2\n"
               "lights=[true,false]\nenvironment=4\ntime=0.04\n",
        "x.cam");
    EXPECT_EQ(file.camera.up, (rtcore::Vec3{1, 0, 0}));
    EXPECT_EQ(file.camera.horizontalFov, 150.0F);
    EXPECT_EQ(file.width, 320);
    EXPECT_EQ(file.height, 240);
    EXPECT_EQ(file.antialiasing, 3);
    EXPECT_EQ(file.bloom, 9);
    EXPECT_EQ(file.exposure, 2.0F);
    EXPECT_EQ(file.lights, (std::vector<bool>{true, false}));
    EXPECT_EQ(file.environment, 4);
    EXPECT_EQ(file.time, 0.04);
}

TEST(Cam, ErrorsNameTheirPlace) {
    EXPECT_EQ(problemWith("fow = 70"), "x.cam:4:1: unknown key 'fow'; did you mean 'fov'?");
    EXPECT_EQ(problemWith("fov = 180"), "x.cam:4:7: fov is 180, but takes a number above 0 and below 180");
    EXPECT_EQ(problemWith("  width =  0"),
              "x.cam:4:12: width is 0, but takes a whole number from 1 to 32768");
    EXPECT_EQ(problemWith("width = 1.5"),
              "x.cam:4:9: width is a number, but takes a whole number from 1 to 32768");
    EXPECT_EQ(problemWith("lights = [true, 1]"),
              "x.cam:4:17: lights is a whole number, but takes only true and false");
    EXPECT_EQ(problemWith("up = [0, 1]"), "x.cam:4:6: up has 2 values, but takes three numbers in brackets");
    EXPECT_EQ(problemWith("up = [0, \"a\", 0]"), "x.cam:4:10: up is text, but takes a finite number");
    EXPECT_EQ(problemWith("time = -1"), "x.cam:4:8: time is -1, but takes a finite number at least 0");
    EXPECT_EQ(problemWith("exposure = 1979-05-27"),
              "x.cam:4:12: exposure is a date or time, but takes a number at least 1e-30 and at most 1e+30");
    // The column counts characters, not bytes.
    EXPECT_EQ(problemWith("\"\u00e4\u20ac\" = 1").substr(0, 11), "x.cam:4:1: ");
    EXPECT_EQ(problem("version = 1\neye = [0,0,0]\nforward = [\n  0, 0,\n  nan]\n"),
              "x.cam:5:3: forward is nan, but takes a finite number");
}

TEST(Cam, NamesLightsByTheirIdsInVersionTwo) {
    const std::string second = "version = 2" + kMin.substr(kMin.find('\n'));
    const CameraFile file = parseCameraFile(second + "lightsOn = [4, 1]\nlightsOff = [7]\n", "x.cam");
    EXPECT_EQ(file.lightsOn, (std::vector<int>{4, 1}));
    EXPECT_EQ(file.lightsOff, (std::vector<int>{7}));
    EXPECT_FALSE(file.lights);
    EXPECT_EQ(parseCameraFile(second + "lights = [true]\n", "x.cam").lights, (std::vector<bool>{true}));
    EXPECT_NE(problemWith("lightsOn = [1]").find("version"), std::string::npos);
    EXPECT_EQ(problem(second + "lightsOn = [0]"),
              "x.cam:4:12: lightsOn has 0, but takes only whole numbers from 1 to 1000000000");
    EXPECT_EQ(problem(second + "lightsOff = [true]"),
              "x.cam:4:14: lightsOff is true or false, but takes only whole numbers from 1 to 1000000000");
    EXPECT_EQ(problem(second + "lightsOn = [2, 2]"), "x.cam:4:12: light 2 is named twice");
    EXPECT_EQ(problem(second + "lightsOn = [2]\nlightsOff = [3, 2]"), "x.cam:5:13: light 2 is named twice");
    EXPECT_EQ(problem(second + "lights = [true]\nlightsOff = [3]"),
              "x.cam:5:13: lights and lightsOff are both given");
}

/// Files are written for older programs where these can read them.
TEST(Cam, IsOfVersionOneWithoutIds) {
    CameraFile file;
    EXPECT_TRUE(rtcore::formatCameraFile(file).starts_with("version = 1\n"));
    file.lightsOff = {3};
    EXPECT_TRUE(rtcore::formatCameraFile(file).starts_with("version = 2\n"));
}

TEST(Cam, SyntaxErrorsNameTheirPlace) {
    EXPECT_EQ(problem("version = 1\neye = = 3\n").substr(0, 10), "x.cam:2:7:");
    EXPECT_EQ(problem("version = 1\nversion = 1\n").substr(0, 8), "x.cam:2:");
    EXPECT_EQ(problem(kMin + "fov = 1e999").substr(0, 8), "x.cam:4:");
    EXPECT_EQ(problem(kMin + "width = 99999999999999999999").substr(0, 8), "x.cam:4:");
}

TEST(Cam, WhatIsMissingIsNamed) {
    EXPECT_EQ(problem(""), "x.cam:1:1: the version is missing; begin the file with: version = 2");
    EXPECT_EQ(problem("version = 3"), "x.cam:1:11: version 3 is unknown; this program reads version 1 to 2");
    EXPECT_EQ(problem("version = \"1\""), "x.cam:1:11: version is text, but takes 2");
    EXPECT_EQ(problem("version = 1\nforward = [0,0,1]"), "x.cam:1:1: the key 'eye' is missing here; add it");
    EXPECT_EQ(problem("version = 1\neye = [0,0,1]"), "x.cam:1:1: the key 'forward' is missing here; add it");
    // A misspelt key is reported as such, not as a missing one.
    EXPECT_EQ(problem("version = 1\neye = [0,0,1]\nforwrad = [0,0,1]"),
              "x.cam:3:1: unknown key 'forwrad'; did you mean 'forward'?");
}

TEST(Cam, NumbersThatNoFloatHoldsAreRefused) {
    for (const char* number : {"nan", "inf", "-inf", "1e39", "-1e39", "1e300"})
        EXPECT_EQ(problem("version=1\neye=[0,0,0]\nforward=[0," + std::string(number) + ",1]").substr(0, 11),
                  "x.cam:3:12:")
            << number;
    EXPECT_NE(problemWith("time = inf"), "no error");
    EXPECT_NE(problemWith("fov = 1e-60"), "no error"); // rounds to 0
}

TEST(Cam, DirectionsThatMakeNoViewAreRefused) {
    EXPECT_EQ(problem("version=1\neye=[0,0,0]\nforward=[0,0,0]"),
              "x.cam:3:9: forward is zero; the camera needs a direction");
    EXPECT_EQ(problemWith("up = [0, 0.0, 0]"),
              "x.cam:4:6: up is zero; give the direction that is up in the image");
    EXPECT_EQ(problemWith("up = [0, 0, 1e-30]"),
              "x.cam:4:6: up is parallel to the view direction; give another up");
    EXPECT_EQ(problemWith("up = [0, 1e-3, 1]"), "no error");
    // Tiny and huge directions are directions.
    EXPECT_EQ(problem("version=1\neye=[0,0,0]\nforward=[0,0,1e-40]\nup=[0,1e30,0]"), "no error");
}

/// Only an up that the file gives can be wrong.
TEST(Cam, LooksStraightUpAndDownWithoutAnUp) {
    const auto upOf = [](const char* forward) {
        return parseCameraFile("version=1\neye=[0,0,0]\nforward=" + std::string(forward), "x.cam").camera.up;
    };
    EXPECT_EQ(upOf("[0,-7,0]"), (rtcore::Vec3{0, 0, -1})); // as if one had looked along -z before
    EXPECT_EQ(upOf("[0,7,0]"), (rtcore::Vec3{0, 0, 1}));
    EXPECT_EQ(upOf("[1e-9,-7,0]"), (rtcore::Vec3{0, 0, -1}));
    EXPECT_EQ(upOf("[0.1,-7,0]"), (rtcore::Vec3{0, 1, 0}));
}

TEST(Cam, OrthographicCamerasHaveAWidth) {
    const rtcore::Camera camera =
        parseCameraFile(kMin + "orthographicWidth = 4.5\naspect = 1.25\n", "x.cam").camera;
    EXPECT_EQ(camera.kind, rtcore::CameraKind::Orthographic);
    EXPECT_EQ(camera.orthographicWidth, 4.5F);
    EXPECT_EQ(camera.aspect, 1.25F);
    EXPECT_EQ(parseCameraFile(kMin, "x.cam").camera.kind, rtcore::CameraKind::Perspective);
    EXPECT_EQ(problemWith("fov = 60\northographicWidth = 1"),
              "x.cam:4:7: fov and orthographicWidth are both given; leave one out");
    for (const char* wrong : {"orthographicWidth = 0", "orthographicWidth = -1", "orthographicWidth = 1e19",
                              "aspect = 0", "aspect = 1e-5", "aspect = 40000"})
        EXPECT_NE(problemWith(wrong), "no error") << wrong;
}

TEST(Cam, LineEndsAndByteOrderMarkDoNotMatter) {
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : kMin) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_EQ(parseCameraFile(windows, "x.cam"), parseCameraFile(kMin, "x.cam"));
    EXPECT_EQ(problem(windows + "fow = 1\r\n").substr(0, 11), "x.cam:4:1: ");
    EXPECT_EQ(problem("\xEF\xBB\xBFversion = 3").substr(0, 12), "x.cam:1:11: ");
}

TEST(Cam, BytesThatAreNoUtf8AreRefused) {
    EXPECT_EQ(problemWith("# \xFF\n").substr(0, 10), "x.cam:4:3:");
    EXPECT_EQ(problem("\xFF\xFE v").substr(0, 8), "x.cam:1:");
    EXPECT_NE(problemWith(std::string("#\0\n", 3)), "no error");
}

CameraFile randomCamera(test::Random& random) {
    CameraFile file;
    file.camera.eye = {random.number(), random.number(), random.number()};
    file.camera.forward = {random.number(), random.number(), 0};
    file.camera.up = {0, random.number(), random.number()};
    if (random.flag()) {
        file.camera.horizontalFov = 0.001F + 179.9F * random.fraction();
    } else {
        file.camera.kind = rtcore::CameraKind::Orthographic;
        file.camera.orthographicWidth = 0.001F + 1000 * random.fraction();
    }
    if (random.flag()) file.camera.aspect = 0.1F + random.fraction();
    if (random.flag()) file.width = 1 + static_cast<int>(random.below(32768));
    if (random.flag()) file.height = 1 + static_cast<int>(random.below(32768));
    if (random.flag()) file.antialiasing = 1 + static_cast<int>(random.below(16));
    if (random.flag()) file.bloom = static_cast<int>(random.below(4097));
    if (random.flag()) file.exposure = random.positive();
    if (random.flag()) file.environment = static_cast<int>(random.below(9));
    if (random.flag()) file.time = static_cast<double>(random.positive()) / 3;
    if (random.flag()) {
        file.lights.emplace(random.below(5), random.flag());
    } else {
        for (int id = 1; id < 9; ++id) {
            if (random.flag()) (random.flag() ? file.lightsOn : file.lightsOff).push_back(3 * id);
        }
    }
    return file;
}

TEST(Cam, RandomCamerasSurviveTheRoundTripBitForBit) {
    test::Random random(11);
    int compared = 0;
    for (int i = 0; i < 1500; ++i) {
        const CameraFile file = randomCamera(random);
        const std::string text = rtcore::formatCameraFile(file);
        // Random directions may come out as good as parallel.
        if (problem(text).find("parallel") != std::string::npos) continue;
        EXPECT_EQ(parseCameraFile(text, "x.cam"), file) << text;
        ++compared;
    }
    EXPECT_GT(compared, 1000);
}

TEST(Cam, ExtremeFloatsSurviveTheRoundTrip) {
    using limits = std::numeric_limits<float>;
    for (const float x : {limits::max(), limits::lowest(), limits::min(), limits::denorm_min(), -0.0F, 0.1F,
                          16777216.0F, 9.999999e9F, 1e20F, 3.4028233e38F, 8.41e21F, 1.1754942e-38F}) {
        CameraFile file;
        file.camera.eye = {x, -x, x};
        const CameraFile again = parseCameraFile(rtcore::formatCameraFile(file), "x.cam");
        EXPECT_EQ(std::signbit(again.camera.eye.x), std::signbit(x)) << x;
        EXPECT_EQ(again, file) << x;
    }
}

TEST(Cam, FilesAreWrittenAndRead) {
    const test::TemporaryFolder folder;
    test::Random random(12);
    CameraFile file = randomCamera(random);
    file.camera.forward = {0, 0, 1};
    rtcore::writeCameraFile(folder / "a.cam", file);
    EXPECT_EQ(rtcore::readCameraFile(folder / "a.cam"), file);
}

TEST(Cam, WhatCouldNotBeReadIsNotWritten) {
    const test::TemporaryFolder folder;
    rtcore::writeCameraFile(folder / "a.cam", {});
    const std::string before = test::fileContent(folder / "a.cam");
    CameraFile file;
    file.camera.eye.x = std::numeric_limits<float>::quiet_NaN();
    try {
        rtcore::writeCameraFile(folder / "a.cam", file);
        FAIL() << "written";
    } catch (const rtcore::FileError& error) {
        EXPECT_EQ(error.kind, rtcore::FailureKind::CannotWrite);
    }
    EXPECT_EQ(test::fileContent(folder / "a.cam"), before);
}

TEST(Cam, MissingFilesAreNoInput) {
    const test::TemporaryFolder folder;
    try {
        rtcore::readCameraFile(folder / "none.cam");
        FAIL() << "read";
    } catch (const rtcore::FileError& error) {
        EXPECT_EQ(error.kind, rtcore::FailureKind::NoInput);
    }
}

const std::string kFar =
    "version = 1\norigin = [458213, 5428765, 312]\neye = [0.1, -2.5, 3]\nforward = [0, 0, -1]\n";

TEST(Cam, AnOriginSaysFromWhereTheEyeCounts) {
    const rtcore::LocalOrigin zero{{458213, 5428765, 312}};
    const CameraFile file = parseCameraFile(kFar, "x.cam");
    EXPECT_EQ(file.origin, zero);
    EXPECT_EQ(file.camera.eye, (rtcore::Vec3{0.1F, -2.5F, 3}));
    EXPECT_EQ(parseCameraFile(kFar, "x.cam", zero), file);
    EXPECT_EQ(rtcore::formatCameraFile(file).find("version = 1\norigin = [458213.0, 5428765.0, 312.0]\n"),
              0U);
    EXPECT_EQ(parseCameraFile(rtcore::formatCameraFile(file), "x.cam", zero), file);
    // A model that is not on the grid, and a camera by hand on a model that is.
    EXPECT_EQ(parseCameraFile(kFar, "x.cam", rtcore::LocalOrigin()).camera.eye,
              (rtcore::Vec3{458213.1F, 5428762.5F, 315}));
    const CameraFile byHand = parseCameraFile(
        "version = 1\neye = [458213.1, 5428762.5, 315]\nforward = [0, 0, -1]\n", "x.cam", zero);
    EXPECT_EQ(byHand, file);
    EXPECT_EQ(problem("version = 1\norigin = [1, 2, 1e13]\neye = [0, 0, 0]\nforward = [0, 0, -1]\n"),
              "x.cam:2:17: origin is 1e+13, but takes a number at least -1e+12 and at most 1e+12");
}

} // namespace

/// Luminance and illuminance as colours, by the Renderer.
#include "process/sample_scene.h"

#include "rtcore/io/images/image_file.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace {

using Pixel = std::array<int, 3>;

/// A panel of 10 x 10 that emits a radiance of 1 and fills the image.
class PanelOfLight : public testing::Test {
  protected:
    PanelOfLight() {
        test::writeText(folder / "panel.mtl", "newmtl light\nKd 0 0 0\n");
        test::writeText(folder / "panel.obj", "mtllib panel.mtl\nusemtl light\nv -5 -5 0\nv 5 -5 0\nv 5 5 0\n"
                                              "v -5 5 0\nf 1 2 3 4\n");
        writeScene("panel.scn", "");
    }
    void writeScene(const std::string& name, const std::string& more) const {
        test::writeText(folder / name, "version = 2\nmodel = \"panel.obj\"\ndefaultLight = false\n" + more +
                                           "[camera]\neye = [0, 0, 3]\nforward = [0, 0, -1]\nfov = 40\n"
                                           "[[material]]\nname = \"light\"\nemission = [1, 1, 1]\n");
    }
    test::ProgramResult render(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"-o", "a.ppm", "-w", "160", "-h", "120", "--force"});
        return test::renderer(arguments, {.folder = folder.path()});
    }
    std::string picture(std::vector<std::string> settings, const std::string& scene = "panel.scn") {
        std::vector<std::string> arguments{scene, "--setting=falseColours.on=true"};
        for (const std::string& each : settings) arguments.push_back("--setting=falseColours." + each);
        const test::ProgramResult result = render(arguments);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        error = result.error;
        return test::readBytes(folder / "a.ppm");
    }
    static Pixel pixel(const std::string& ppm, int x, int y) {
        const std::size_t at = ppm.size() - 3 * (160 * 120) + 3 * static_cast<std::size_t>(160 * y + x);
        const auto code = [&](std::size_t i) { return int{static_cast<unsigned char>(ppm.at(at + i))}; };
        return {code(0), code(1), code(2)};
    }

    test::TemporaryFolder folder;
    std::string error;
};

// A third of the way from 6.83 to 6 830 000 cd/m^2 in the logarithm: the sixth of 16 colours.
TEST_F(PanelOfLight, HasTheColourOfItsLuminance) {
    constexpr Pixel kExpected{0x31, 0x68, 0x8E};
    EXPECT_EQ(pixel(picture({"from=6.83", "to=6830000"}), 140, 60), kExpected);
    EXPECT_EQ(error, "") << "the light has a unit";
    EXPECT_EQ(pixel(picture({"from=683", "to=6830"}), 140, 60), (Pixel{0x44, 0x01, 0x54}));
    EXPECT_EQ(pixel(picture({"from=68.3", "to=683"}), 140, 60), (Pixel{0xFD, 0xE7, 0x25}));
}

TEST_F(PanelOfLight, HasALegendAtTheLeft) {
    const std::string with = picture({"from=6.83", "to=6830000"}),
                      without = picture({"from=6.83", "to=6830000", "legend=false"});
    EXPECT_EQ(pixel(with, 140, 60), pixel(without, 140, 60));
    EXPECT_NE(pixel(with, 12, 30), pixel(without, 12, 30));
}

// Sky and panel in one image: each in its own unit. The panel is not as bright as without the sky.
TEST_F(PanelOfLight, BesideASkyHasTheSameColour) {
    writeScene("sky.scn", "[sky]\n");
    EXPECT_EQ(pixel(picture({"from=6.83", "to=6830000"}, "sky.scn"), 140, 60), (Pixel{0x31, 0x68, 0x8E}));
}

// Under an even sky of radiance 1, white paper has that radiance, whatever the panel is: black, and it
// shines.
TEST_F(PanelOfLight, HoldsTheLightThatArrivesInFilesOfRadiance) {
    test::writeText(folder / "half.scn", "version = 2\nmodel = \"panel.obj\"\ndefaultLight = false\n"
                                         "background = [1, 1, 1]\n[camera]\neye = [5, 0, 3]\n"
                                         "forward = [0, 0, -1]\nfov = 40\n"
                                         "[[material]]\nname = \"light\"\nemission = [9, 9, 9]\n");
    for (const char* format : {"pfm", "exr", "hdr"}) {
        const std::string file = std::string("a.") + format;
        const test::ProgramResult result = test::renderer(
            {"half.scn", "-w", "40", "-h", "30", "-o", file, "--integrator=path", "--samples=16",
             "--setting=falseColours.on=true", "--setting=falseColours.quantity=illuminance"},
            {.folder = folder.path()});
        ASSERT_EQ(result.exitCode, 0) << result.error;
        const rtcore::HdrImage image = rtcore::readHdrImage(folder / file);
        float sum = 0;
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 18; ++x) sum += image.at(x, y).g;
        EXPECT_NEAR(sum / (30 * 18), 1, 0.005F) << format;
        EXPECT_EQ(image.at(35, 15).g, std::string(format) == "hdr" ? 0.0F : -1.0F) << "nothing is there";
    }
}

TEST_F(PanelOfLight, WithoutAUnitIsToldOnce) {
    test::writeText(folder / "panel.mtl", "newmtl light\nKd 0 0 0\nKe 1 1 1\n");
    test::writeText(folder / "bare.scn",
                    "version = 2\nmodel = \"panel.obj\"\ndefaultLight = false\n[camera]\n"
                    "eye = [0, 0, 3]\nforward = [0, 0, -1]\nfov = 40\n");
    picture({}, "bare.scn");
    EXPECT_NE(
        error.find("the light of this scene has no absolute unit (surfaces that emit as the model's file "
                   "says)"),
        std::string::npos)
        << error;
}

} // namespace

/// Images of the Renderer without their background: what files hold, what stands in its place, and what is
/// refused.
#include "process/sample_scene.h"

#include "rtcore/io/images/image_file.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using Names = std::vector<std::string>;

class Backgrounds : public testing::Test {
  protected:
    void SetUp() override {
        test::writeRoom(folder / "room.obj");
        // So far away that there is much around the room.
        test::writeText(folder / "far.cam", "version = 1\neye = [0, 30, 60]\nforward = [0, -0.45, -1]\n"
                                            "up = [0, 1, 0]\nfov = 40\n");
    }
    test::ProgramResult render(Names extra) const {
        const Names common{"room.obj",
                           "--camera=far.cam",
                           "-w",
                           "48",
                           "-h",
                           "36",
                           "-a",
                           "2",
                           "--setting=exposure.mode=fixed",
                           "--setting=exposure.value=1"};
        extra.insert(extra.begin(), common.begin(), common.end());
        return test::renderer(extra, {.folder = folder.path()});
    }
    rtcore::LdrImage image(const std::string& file) const { return rtcore::readLdrImage(folder / file); }

    test::TemporaryFolder folder;
};

TEST_F(Backgrounds, AreTransparentInFilesThatCanHoldThat) {
    ASSERT_EQ(render({"--alpha", "-o", "a.png", "-o", "a.tga", "-o", "a.tif", "-o", "a.exr"}).exitCode, 0);
    const rtcore::LdrImage png = image("a.png");
    int clear = 0, opaque = 0;
    for (const rtcore::Rgba8 pixel : png.pixels) {
        clear += pixel.a == 0 ? 1 : 0;
        opaque += pixel.a == 255 ? 1 : 0;
    }
    EXPECT_GT(clear, 400);
    EXPECT_GT(opaque, 100);
    EXPECT_EQ(png.pixels, image("a.tga").pixels);
    EXPECT_EQ(png.pixels, image("a.tif").pixels);
    // Where the model fills a pixel, it looks as before the scene's own background.
    ASSERT_EQ(render({"-o", "b.png"}).exitCode, 0);
    const rtcore::LdrImage shown = image("b.png");
    for (std::size_t i = 0; i < png.pixels.size(); ++i) {
        if (png.pixels[i].a < 255) continue;
        EXPECT_NEAR(png.pixels[i].g, shown.pixels[i].g, 1);
    }
}

TEST_F(Backgrounds, AreReplacedByColoursGradientsAndImages) {
    ASSERT_EQ(render({"--backdrop=#ff0000", "-o", "red.png"}).exitCode, 0);
    EXPECT_EQ(image("red.png").at(0, 0), (rtcore::Rgba8{255, 0, 0}));
    ASSERT_EQ(render({"--backdrop=#ff0000,#0000ff", "-o", "both.jpg"}).exitCode, 0);
    const rtcore::LdrImage both = image("both.jpg");
    EXPECT_GT(both.at(0, 0).r, 230);
    EXPECT_GT(both.at(0, 35).b, 230);
    ASSERT_EQ(render({"--backdrop=red.png", "-o", "of.png"}).exitCode, 0);
    EXPECT_EQ(image("of.png").at(0, 0), (rtcore::Rgba8{255, 0, 0}));
}

TEST_F(Backgrounds, AreTransparentByPathsToo) {
    ASSERT_EQ(render({"--alpha", "--integrator=path", "--samples=4", "-o", "p.png"}).exitCode, 0);
    EXPECT_EQ(image("p.png").at(0, 0).a, 0);
}

TEST_F(Backgrounds, TakeTheShadowOfTheModel) {
    for (const char* const by : {"--integrator=whitted", "--integrator=path"}) {
        const Names common{"--alpha", by, "--samples=4", "-o"};
        const auto with = [&](Names names) {
            names.insert(names.begin(), common.begin(), common.end());
            return names;
        };
        ASSERT_EQ(render(with({"plain.png"})).exitCode, 0);
        ASSERT_EQ(render(with({"shadow.png", "--ground-shadow"})).exitCode, 0);
        const rtcore::LdrImage plain = image("plain.png"), shadow = image("shadow.png");
        int shaded = 0;
        for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
            const rtcore::Rgba8 before = plain.pixels[i], after = shadow.pixels[i];
            EXPECT_TRUE(before.a < 255 || before == after);
            EXPECT_GE(after.a, before.a);
            if (before.a > 0 || after.a < 25) continue;
            EXPECT_EQ(after.r + after.g + after.b, 0);
            ++shaded;
        }
        EXPECT_GT(shaded, 10) << by;
        EXPECT_EQ(shadow.at(0, 0).a, 0) << by; // far from the model
    }
}

TEST_F(Backgrounds, AreRefusedWhereTheyMakeNoSense) {
    const auto refused = [&](const Names& arguments, int code, const std::string& remedy) {
        const test::ProgramResult result = render(arguments);
        EXPECT_EQ(result.exitCode, code) << result.error;
        EXPECT_NE(result.error.find(remedy), std::string::npos) << result.error;
    };
    refused({"--alpha", "-o", "a.jpg"}, 2, ".png, .tif");
    refused({"--alpha", "-o", "a.hdr"}, 2, ".exr");
    refused({"--alpha", "--format=ppm", "-o", "-"}, 2, ".png");
    refused({"--alpha", "--backdrop=#000000", "-o", "a.png"}, 2, "leave one of them out");
    refused({"--ground-shadow", "-o", "a.png"}, 2, "--alpha or --backdrop");
    refused({"--alpha", "--turntable=1", "--video=a.mp4"}, 2, "films have no alpha");
    refused({"--alpha", "--make-light=a.light"}, 2, "leave out --make-light");
    refused({"--backdrop=#00000", "-o", "a.png"}, 2, "#8090a0");
    refused({"--backdrop=#000000", "-o", "a.exr"}, 2, "--alpha with an .exr");
    refused({"--backdrop=none.png", "-o", "a.png"}, 66, "none.png");
    test::writeText(folder / "no.png", "no image");
    refused({"--backdrop=no.png", "-o", "a.png"}, 65, "no.png");
    ASSERT_EQ(render({"-o", "own.png"}).exitCode, 0);
    refused({"--backdrop=own.png", "-o", "own.png"}, 2, "own.png");
}

} // namespace

// Renderer --plan: drawings to scale, and what is said where there can be none.
#include "process/sample_scene.h"

#include "rtcore/io/images/image_file.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

/// A box of 6 x 3 x 4 with walls of .3 m, closed, seen from inside by its camera.
class Plans : public testing::Test {
  protected:
    Plans() {
        std::string text;
        int first = 1;
        const auto box = [&](double x, double y, double z, double x2, double y2, double z2) {
            for (int i = 0; i < 8; ++i)
                text += "v " + std::to_string((i & 1) != 0 ? x2 : x) + " " +
                        std::to_string((i & 2) != 0 ? y2 : y) + " " + std::to_string((i & 4) != 0 ? z2 : z) +
                        "\n";
            for (const auto& face : {std::array{0, 4, 6, 2},
                                     {1, 3, 7, 5},
                                     {0, 1, 5, 4},
                                     {2, 6, 7, 3},
                                     {0, 2, 3, 1},
                                     {4, 5, 7, 6}}) {
                text += "f";
                for (const int corner : face) text += " " + std::to_string(first + corner);
                text += "\n";
            }
            first += 8;
        };
        box(0, -.3, 0, 6.6, 0, 4.6);
        box(0, 0, 0, 6.6, 3, .3);
        box(0, 0, 4.3, 6.6, 3, 4.6);
        box(0, 0, .3, .3, 3, 4.3);
        box(6.3, 0, .3, 6.6, 3, 4.3);
        test::writeText(folder / "room.obj", text);
    }
    test::ProgramResult draw(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "room.obj");
        return test::renderer(arguments, {.folder = folder.path()});
    }
    bool exists(const std::string& file) const { return std::filesystem::exists(folder / file); }

    test::TemporaryFolder folder;
};

TEST_F(Plans, AreDrawnAndTellWhatWasFound) {
    for (const std::string file : {"plan.svg", "plan.pdf", "plan.dxf"}) {
        const test::ProgramResult result = draw({"--units=m", "--plan", file});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        EXPECT_NE(result.error.find("storey 1 of 1: its floor is at 0.00 m, the cut at 1.20 m"),
                  std::string::npos)
            << result.error;
        EXPECT_NE(result.error.find("rooms: 1, 24.00 m2 together"), std::string::npos) << result.error;
    }
    EXPECT_NE(test::readBytes(folder / "plan.svg").find("24.00 m\u00B2"), std::string::npos);
    EXPECT_EQ(test::filesIn(folder.path()),
              (std::vector<std::string>{"plan.dxf", "plan.pdf", "plan.svg", "room.obj"}));
    const std::string first = test::readBytes(folder / "plan.pdf");
    ASSERT_EQ(draw({"--units=m", "--plan", "plan.pdf", "--threads=1"}).exitCode, 0);
    EXPECT_EQ(test::readBytes(folder / "plan.pdf"), first) << "whatever the threads";
}

TEST_F(Plans, AreInTheUnitOfTheModel) {
    ASSERT_EQ(draw({"--units=mm", "--plan", "small.svg", "--plan-scale=0.1"}).exitCode, 0);
    ASSERT_EQ(draw({"--units=m", "--plan", "large.svg"}).exitCode, 0);
    const auto sizeOf = [&](const std::string& file) {
        const std::string svg = test::readBytes(folder / file);
        return svg.substr(svg.find("width="), 17);
    };
    EXPECT_EQ(sizeOf("large.svg"), "width=\"120.00000m");
    EXPECT_EQ(sizeOf("small.svg"), "width=\"120.00000m")
        << "6.6 mm at 10:1 are 66 mm, and the margin's least";
}

TEST_F(Plans, ThatCannotBeAreRefusedBeforeAnythingIsWritten) {
    struct Refusal {
        std::vector<std::string> arguments;
        int code;
        std::string text;
    };
    for (const Refusal& refusal : std::vector<Refusal>{
             {{"--plan", "a.svg"}, 1, "the unit of room.obj is not known"},
             {{"--units=m", "--plan", "a.jpg"}, 2, ".svg, .pdf, .dxf, .png or .tif"},
             {{"--units=m", "--plan", "a.svg", "--plan-dpi=100"}, 2, "--plan-dpi is of a .png or .tif"},
             {{"--units=m", "--plan", "a.png", "--plan-scale=1", "--plan-dpi=600"},
              1,
              "than an image can have"},
             {{"--units=m", "--plan", "none/a.svg"}, 73, "make it first"},
             {{"--units=m", "--plan", "room.obj.svg", "--plan-storey=2"},
              1,
              "there is no storey 2; 1 were found"},
             {{"--units=m", "--plan", "a.svg", "--plan-from=section"},
              1,
              "a scene with just one; this one has 0"},
             {{"--units=m", "--plan", "a.svg", "--plan-from=front", "--plan-height=2"},
              2,
              "of plans from above"},
             {{"--units=m", "--plan", "a.svg", "--plan-paper=A4", "--plan-scale=10"}, 1, "sheets of A4"},
             {{"--units=m", "--plan", "a.pdf", "--plan-scale=1"}, 1, "5.08 m"},
             {{"--units=m", "--plan", "a.svg", "-o", "a.png"}, 2, "leave out --output"},
             {{"--plan-scale=50"}, 2, "--plan-scale needs --plan"},
             {{"--units=m", "--plan", "a.svg", "--plan-floor=-50"}, 1, "there is nothing to draw"}}) {
        const test::ProgramResult result = draw(refusal.arguments);
        EXPECT_EQ(result.exitCode, refusal.code) << refusal.text << ": " << result.error;
        EXPECT_NE(result.error.find(refusal.text), std::string::npos) << result.error;
    }
    EXPECT_EQ(test::filesIn(folder.path()), std::vector<std::string>{"room.obj"});
}

// Of the light on the floor, of what is cut, and of the paper around.
TEST_F(Plans, ShowTheLightOfARoom) {
    for (const std::string picture : {"light", "both"}) {
        const test::ProgramResult result =
            draw({"--units=m", "--plan", "plan.png", "--plan-dpi=60", "--plan-image=" + picture, "--look=sky",
                  "--antialiasing=1"});
        ASSERT_EQ(result.exitCode, 0) << result.error;
        const rtcore::LdrImage image = rtcore::readLdrImage(folder / "plan.png");
        const auto at = [&](double x, double z) { // millimetres of the drawing, which begins 10 mm further
            return image.at(static_cast<int>((x + 10) * 60 / 25.4), static_cast<int>((z + 10) * 60 / 25.4));
        };
        EXPECT_NE(at(33, 10), (rtcore::Rgba8{255, 255, 255, 255})) << "the floor has its own colour";
        EXPECT_EQ(at(-3, 10), (rtcore::Rgba8{255, 255, 255, 255}));
        EXPECT_GE(image.height, image.width / 3);
    }
    const test::ProgramResult sheets =
        draw({"--units=m", "--plan", "plan.tif", "--plan-dpi=30", "--plan-scale=10", "--plan-paper=A3"});
    ASSERT_EQ(sheets.exitCode, 0) << sheets.error;
    EXPECT_NE(sheets.error.find("4 sheets: plan-A1.tif to plan-B2.tif"), std::string::npos) << sheets.error;
}

TEST_F(Plans, AreNotWrittenOverWhatIsRead) {
    std::filesystem::rename(folder / "room.obj", folder / "room.svg");
    const test::ProgramResult result =
        test::renderer({"room.svg", "--units=m", "--plan", "room.svg"}, {.folder = folder.path()});
    EXPECT_NE(result.exitCode, 0);
    EXPECT_EQ(test::readBytes(folder / "room.svg").substr(0, 2), "v ");
}

} // namespace

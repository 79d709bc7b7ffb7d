/// Images of variants: those that the scene shows, that are asked for, and all of them.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace {

using Names = std::vector<std::string>;

class VariantImages : public testing::Test {
  protected:
    void SetUp() override {
        test::writeRoom(folder / "room.obj");
        write("");
    }
    void write(const std::string& first, const std::string& more = {}) {
        test::writeText(folder / "room.scn",
                        "version = 2\nmodel = \"room.obj\"\n" + first +
                            "[camera]\neye = [0, 1, 2]\nforward = [0, 0, -1]\n"
                            "[[variant]]\nname = \"red room\"\n"
                            "[[variant.material]]\nname = \"*\"\ndiffuse = [0.9, 0.1, 0.1]\n"
                            "[[variant]]\nname = \"red/room\"\n"
                            "[[variant.material]]\nname = \"*\"\ndiffuse = [0.1, 0.9, 0.1]\n" +
                            more);
    }
    test::ProgramResult render(Names extra) const {
        extra.insert(extra.begin(), {"room.scn", "-w", "24", "-h", "18", "--setting=indirect.mode=off"});
        return test::renderer(extra, {.folder = folder.path()});
    }
    std::string image(const Names& extra) const {
        Names all{"-o", "one.png"};
        all.insert(all.end(), extra.begin(), extra.end());
        const test::ProgramResult result = render(all);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return bytes("one.png");
    }
    std::string bytes(const std::string& file) const { return test::readBytes(folder / file); }

    test::TemporaryFolder folder;
};

TEST_F(VariantImages, AreThoseThatAreAskedFor) {
    const std::string base = image({}), red = image({"--variant=red room"});
    EXPECT_NE(red, base);
    write("activeVariant = \"red room\"\n");
    EXPECT_EQ(image({}), red) << "as it was saved";
    EXPECT_EQ(image({"--variant=none"}), base);
    write("activeVariant = \"red room\"\n", "[shown]\n");
    EXPECT_EQ(image({}), base);
}

TEST_F(VariantImages, OfAllHaveTheirNames) {
    const test::ProgramResult all = render({"--variant=all", "-o", "a.png"});
    ASSERT_EQ(all.exitCode, 0) << all.error;
    EXPECT_EQ(bytes("a_red-room.png"), image({"--variant=red room"}));
    EXPECT_EQ(bytes("a_red-room-2.png"), image({"--variant=red/room"}));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
    ASSERT_EQ(render({"--variant=all"}).exitCode, 0);
    EXPECT_EQ(bytes("room_red-room.png"), bytes("a_red-room.png"));
}

TEST_F(VariantImages, ThatAreNotThereAreRefused) {
    const test::ProgramResult none = render({"--variant=blue"});
    EXPECT_EQ(none.exitCode, 66);
    EXPECT_NE(none.error.find("it has no variant 'blue', but 'red room', 'red/room'"), std::string::npos)
        << none.error;
    EXPECT_EQ(render({"--variant=all", "-o", "-"}).exitCode, 2);
    EXPECT_EQ(render({"--variant=all", "--preview=p"}).exitCode, 2);
    const test::ProgramResult model =
        test::renderer({"room.obj", "--variant=all"}, {.folder = folder.path()});
    EXPECT_EQ(model.exitCode, 66);
    EXPECT_NE(model.error.find("nor any other"), std::string::npos) << model.error;
}

} // namespace

#include "rtcore/io/import/materials/texture_files.h"

#include "import_support.h"

#include <gtest/gtest.h>

namespace {

using rtcore::findTextureFile;

class TextureFiles : public testing::Test {
  protected:
    void file(const std::string& name) {
        std::filesystem::create_directories((folder_ / name).parent_path());
        test::writeText(folder_ / name, "x");
    }
    /// Relative to the folder; "" = not found.
    std::string found(const std::string& name) {
        const auto path = findTextureFile(folder_ / "model", name);
        return path ? std::filesystem::weakly_canonical(*path)
                          .lexically_relative(std::filesystem::canonical(folder_.path()))
                          .string()
                    : "";
    }
    test::TemporaryFolder folder_;
};

TEST_F(TextureFiles, AreFoundAsModelsSpellThem) {
    file("model/maps/Wood Fine.png");
    file("model/leaf.png");
    file("model/textures/brick.png");
    file("textures/stone.jpg");
    EXPECT_EQ(found("maps/Wood Fine.png"), "model/maps/Wood Fine.png");
    EXPECT_EQ(found("maps\\Wood Fine.png"), "model/maps/Wood Fine.png");
    EXPECT_EQ(found("MAPS\\wood fine.PNG"), "model/maps/Wood Fine.png");
    EXPECT_EQ(found("maps/Wood%20Fine.png"), "model/maps/Wood Fine.png");
    EXPECT_EQ(found("./leaf.png"), "model/leaf.png");
    EXPECT_EQ(found("C:\\Users\\me\\leaf.png"), "model/leaf.png");
    EXPECT_EQ(found("/gone/BRICK.png"), "model/textures/brick.png");
    EXPECT_EQ(found("stone.jpg"), "textures/stone.jpg");
    EXPECT_EQ(found("../textures/stone.jpg"), "textures/stone.jpg");
    EXPECT_EQ(found((folder_ / "model/leaf.png").string()), "model/leaf.png");
}

TEST_F(TextureFiles, AreMissedWithoutFuss) {
    file("model/leaf.png");
    for (const char* name : {"", "none.png", "..", ".", "/", "textures", "leaf.png/", "%", "%zz", "a\\"}) {
        EXPECT_EQ(found(name), "") << name;
    }
    EXPECT_EQ(found(std::string(100000, 'a')), "");
    EXPECT_EQ(found(std::string("leaf.png\0junk", 13)), "model/leaf.png");
}

} // namespace

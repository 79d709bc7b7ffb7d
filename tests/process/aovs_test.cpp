/// --aovs, read back as other programs do.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

#ifdef RT_HAVE_OPENEXR
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#endif

namespace {

using Names = std::vector<std::string>;

class AovFile : public testing::Test {
  protected:
    void SetUp() override {
        // A wall 5 away that faces the camera, and nothing beside it.
        test::writeText(folder / "wall.obj",
                        "mtllib wall.mtl\nusemtl clay\nv -50 -50 0\nv 0 -50 0\nv 0 50 0\nv -50 50 0\n"
                        "f 1 2 3\nf 1 3 4\n");
        test::writeText(folder / "wall.mtl", "newmtl clay\nKd 0.5 0.25 0.125\n");
        test::writeText(folder / "wall.scn",
                        "version = 1\nmodel = \"wall.obj\"\n[camera]\neye = [0.0, 0.0, 5.0]\n"
                        "forward = [0.0, 0.0, -1.0]\nfov = 90.0\n[[light]]\nkind = \"point\"\n"
                        "position = [0.0, 0.0, 4.0]\nintensity = [50.0, 50.0, 50.0]\n");
    }
    test::ProgramResult render(Names extra) {
        extra.insert(extra.begin(), {"wall.scn", "-w", "40", "-h", "30", "--aovs"});
        return test::renderer(extra, {.folder = folder.path()});
    }

    test::TemporaryFolder folder;
};

TEST_F(AovFile, NeedsAFileThatCanHoldThem) {
    EXPECT_EQ(render({"-o", "a.png"}).exitCode, 2);
    EXPECT_EQ(render({}).exitCode, 2);
    EXPECT_EQ(test::filesIn(folder.path()), (Names{"wall.mtl", "wall.obj", "wall.scn"}));
}

#ifdef RT_HAVE_OPENEXR
std::vector<float> channelOf(const std::filesystem::path& path, const char* channel) {
    Imf::InputFile file(path.c_str());
    std::vector<float> values(40 * 30, -1.0F);
    Imf::FrameBuffer frame;
    frame.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                     40 * sizeof(float)));
    file.setFrameBuffer(frame);
    file.readPixels(0, 29);
    return values;
}

TEST_F(AovFile, HasTheAovsThatOtherProgramsLookFor) {
    ASSERT_EQ(render({"-o", "a.exr", "-o", "a.png"}).exitCode, 0);
    const std::filesystem::path path = folder / "a.exr";
    const Imf::InputFile file(path.c_str());
    Names names;
    const Imf::ChannelList& channels = file.header().channels();
    for (auto c = channels.begin(); c != channels.end(); ++c) names.emplace_back(c.name());
    EXPECT_EQ(names, (Names{"B", "G", "R", "albedo.B", "albedo.G", "albedo.R", "depth.Z", "direct.B",
                            "direct.G", "direct.R", "normal.X", "normal.Y", "normal.Z", "occlusion.Y"}));
    constexpr std::size_t wall = 15 * 40 + 10, nothing = 15 * 40 + 30;
    EXPECT_NEAR(channelOf(path, "depth.Z")[wall], 5, 1e-4F);
    EXPECT_GT(channelOf(path, "depth.Z")[nothing], 1e9F);
    EXPECT_NEAR(channelOf(path, "normal.Z")[wall], 1, 1e-5F);
    EXPECT_EQ(channelOf(path, "normal.Z")[nothing], 0);
    EXPECT_NEAR(channelOf(path, "albedo.R")[wall], 2 * channelOf(path, "albedo.G")[wall], 1e-3F);
    EXPECT_EQ(channelOf(path, "direct.R")[wall], channelOf(path, "R")[wall]) << "the light is all there is";
    EXPECT_EQ(channelOf(path, "occlusion.Y")[wall], 1);
    // A program that does not know AOVs finds the image.
    ASSERT_EQ(test::renderer({"wall.scn", "-w", "40", "-h", "30", "-o", "b.exr"}, {.folder = folder.path()})
                  .exitCode,
              0);
    EXPECT_EQ(channelOf(path, "R"), channelOf(folder / "b.exr", "R"));
}

TEST_F(AovFile, OfPathsHasGuidesAndTheImageBeforeItsEffects) {
    ASSERT_EQ(render({"-o", "a.exr", "--integrator=path", "--samples=2", "--setting=bloom.radius=3",
                      "--setting=path.filter=0"})
                  .exitCode,
              0);
    const std::filesystem::path path = folder / "a.exr";
    constexpr std::size_t wall = 15 * 40 + 10, edge = 15 * 40 + 19, nothing = 15 * 40 + 30;
    EXPECT_NEAR(channelOf(path, "guideAlbedo.R")[wall], 0.5F, 1e-4F);
    EXPECT_NEAR(channelOf(path, "guideAlbedo.B")[wall], 0.125F, 1e-4F);
    EXPECT_NEAR(channelOf(path, "guideNormal.Z")[wall], 1, 1e-4F);
    EXPECT_EQ(channelOf(path, "guideNormal.Z")[nothing], 0);
    EXPECT_NE(channelOf(path, "sampled.R")[edge], channelOf(path, "R")[edge]);
    ASSERT_EQ(render({"-o", "b.exr", "--integrator=path", "--samples=2", "--setting=path.filter=0"}).exitCode,
              0);
    EXPECT_EQ(channelOf(path, "sampled.R"), channelOf(folder / "b.exr", "R"));
}

TEST_F(AovFile, IsMadeOfEachFrameAndFoundWhole) {
    test::writeCamera(folder / "1.cam", 0);
    test::writeText(folder / "film.lst", "1.cam\n1.cam\n");
    ASSERT_EQ(render({"-l", "film.lst", "-o", "f#.exr"}).exitCode, 0);
    EXPECT_EQ(render({"-l", "film.lst", "-o", "f#.exr", "--verify"}).exitCode, 0);
    EXPECT_EQ(test::readBytes(folder / "f1.exr"), test::readBytes(folder / "f2.exr"));
}
#endif

} // namespace

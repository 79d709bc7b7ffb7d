/// Noise taken away by a trained net: the Renderer's --denoise and --nets.
#include "process/sample_scene.h"

#include "rtcore/neural/net_files.h"
#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

namespace {

using Names = std::vector<std::string>;

class Denoised : public testing::Test {
  protected:
    Denoised() {
        test::writeRoom(folder / "room.obj");
        std::filesystem::create_directory(folder / "none");
    }

    test::ProgramResult render(Names options) {
        const Names first{"room.obj",          "-w",         "48",          "-h", "32",
                          "--integrator=path", "--look=sky", "--samples=4", "-o", "a.ppm"};
        options.insert(options.begin(), first.begin(), first.end());
        return test::renderer(options, {.folder = folder.path()});
    }
    /// The bytes of the image.
    std::string image(const Names& options) {
        const test::ProgramResult result = render(options);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return test::readBytes(folder / "a.ppm");
    }
    bool written() const { return std::filesystem::exists(folder / "a.ppm"); }

    test::TemporaryFolder folder;
};

TEST_F(Denoised, WithoutWeightsNothingIsRenderedAndTheWayToThemIsTold) {
    const test::ProgramResult result = render({"--denoise=base", "--nets=none"});
    EXPECT_EQ(result.exitCode, 66) << result.error;
    EXPECT_NE(result.error.find("rt_hdr_calb_cnrm.tza"), std::string::npos) << result.error;
    EXPECT_NE(result.error.find("nets"), std::string::npos);
    EXPECT_FALSE(written());
}

TEST_F(Denoised, AnotherFileOfTheNameIsRefused) {
    test::writeText(folder / "none" / "rt_hdr_calb_cnrm_small.tza", "not a net");
    const test::ProgramResult result = render({"--denoise=small", "--nets=none"});
    EXPECT_EQ(result.exitCode, 65) << result.error;
    EXPECT_FALSE(written());
}

TEST_F(Denoised, AutomaticIsTheFilterWhereThereAreNoWeights) {
    const test::ProgramResult result =
        render({"--denoise=automatic", "--nets=none", "--setting=path.filter=0"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_NE(result.error.find("rt_hdr_calb_cnrm.tza"), std::string::npos) << result.error;
    const std::string filtered = test::readBytes(folder / "a.ppm");
    EXPECT_TRUE(filtered == image({"--setting=path.filter=3"}));
    EXPECT_FALSE(filtered == image({"--setting=path.filter=0"}));
    EXPECT_TRUE(image({"--denoise=automatic", "--nets=none", "--setting=path.filter=5"}) ==
                image({"--setting=path.filter=5"}));
}

TEST_F(Denoised, AListNamesItsNet) {
    test::writeCamera(folder / "1.cam", 0);
    test::writeText(folder / "film.lst", "1.cam\n");
    const test::ProgramResult result =
        test::renderer({"room.obj", "-l", "film.lst", "-w", "16", "-h", "12", "-o", "f#.png",
                        "--integrator=path", "--samples=1", "--denoise=automatic"},
                       {.folder = folder.path()});
    EXPECT_EQ(result.exitCode, 2) << result.error;
    EXPECT_NE(result.error.find("small, base or large"), std::string::npos) << result.error;
    EXPECT_FALSE(std::filesystem::exists(folder / "f1.png"));
}

TEST_F(Denoised, AMissingNetEndsAListAtItsFirstFrame) {
    test::writeCamera(folder / "1.cam", 0);
    test::writeCamera(folder / "2.cam", 1);
    test::writeText(folder / "film.lst", "1.cam\n2.cam\n");
    const test::ProgramResult result =
        test::renderer({"room.obj", "-l", "film.lst", "-w", "16", "-h", "12", "-o", "f#.png",
                        "--integrator=path", "--samples=1", "--denoise=base", "--nets=none"},
                       {.folder = folder.path()});
    EXPECT_EQ(result.exitCode, 66) << result.error;
    EXPECT_EQ(result.error.find("rt_hdr_calb_cnrm.tza"), result.error.rfind("rt_hdr_calb_cnrm.tza"))
        << "told once: " << result.error;
}

TEST_F(Denoised, ByOtherWeightsThanThoseThatAreMeantNothingIsRendered) {
    const test::ProgramResult other = render({"--denoise=base@0123abcd", "--nets=none"});
    EXPECT_EQ(other.exitCode, 65) << other.error;
    EXPECT_NE(other.error.find("d0057057"), std::string::npos) << other.error;
    EXPECT_EQ(render({"--denoise=base@d0057057", "--nets=none"}).exitCode, 66)
        << "they are known, but not here";
    for (const char* const wrong : {"--denoise=base@", "--denoise=base@xyz", "--denoise=off@d0",
                                    "--denoise=automatic@d0", "--denoise=none", "--denoise=huge@d0057057"})
        EXPECT_EQ(render({wrong}).exitCode, 2) << wrong;
    EXPECT_FALSE(written());
}

TEST_F(Denoised, WhittedsRaysNeedNoNet) {
    EXPECT_EQ(render({"--integrator=whitted", "--denoise=base", "--nets=none"}).exitCode, 0);
}

TEST_F(Denoised, TheSameForEveryThreadAndInstructionSet) {
    if (rtcore::findNet(rtcore::fileOf(rtcore::Net::Base), {}, test::programPath("Renderer").parent_path())
            .file.empty())
        GTEST_SKIP() << "skipped: there are no weights beside the build";
    const std::string denoised = image({"--denoise=base", "--threads=1"});
    EXPECT_TRUE(denoised == image({"--denoise=base", "--threads=3"}));
    for (const std::string& isa : rtcore::instructionSets())
        EXPECT_TRUE(denoised == image({"--denoise=base@d0057057", "--isa=" + isa})) << isa;
    EXPECT_TRUE(denoised == image({"--denoise=automatic"}));
    EXPECT_FALSE(denoised == image({"--denoise=small"}));
    EXPECT_FALSE(denoised == image({}));
}

} // namespace

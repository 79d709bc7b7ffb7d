/// Images all around the eye: the same surfaces as in flat images, no seam, and XMP by which phones know
/// them.
#include "process/sample_scene.h"

#include "rtcore/io/images/image_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using Names = std::vector<std::string>;

class Panoramas : public testing::Test {
  protected:
    void SetUp() override { test::writeRoom(folder / "room.obj"); }
    test::ProgramResult render(Names extra) const {
        const Names common{"room.obj", "--setting=exposure.mode=fixed", "--setting=exposure.value=1", "-a",
                           "2"};
        extra.insert(extra.begin(), common.begin(), common.end());
        return test::renderer(extra, {.folder = folder.path()});
    }
    rtcore::LdrImage image(const std::string& file) const { return rtcore::readLdrImage(folder / file); }

    test::TemporaryFolder folder;
};

int difference(const rtcore::Rgba8& a, const rtcore::Rgba8& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

TEST_F(Panoramas, ShowWhatFlatImagesShow) {
    constexpr int kAround = 512, kSide = 128;
    const test::ProgramResult around = render({"--panorama=512", "-o", "around.png"});
    ASSERT_EQ(around.exitCode, 0) << around.error;
    const rtcore::LdrImage whole = image("around.png");
    ASSERT_EQ(whole.width, kAround);
    ASSERT_EQ(whole.height, kAround / 2);
    // Cubes' faces: ahead, to the right, behind, to the left, by cameras of 90 degrees at the same eye.
    ASSERT_EQ(render({"--turntable=1", "--fps=1", "--make-list=one.lst"}).exitCode, 0);
    const std::string first = test::readBytes(folder / "one.cams/000001.cam");
    const std::string eye =
        first.substr(first.find("eye"), first.find('\n', first.find("eye")) - first.find("eye"));
    const std::vector<std::string> forwards{"0, 0, -1", "1, 0, 0", "0, 0, 1", "-1, 0, 0"};
    int wrong = 0, compared = 0;
    for (std::size_t face = 0; face < forwards.size(); ++face) {
        test::writeText(folder / "face.cam", "version = 1\n" + eye + "\nforward = [" + forwards[face] +
                                                 "]\nup = [0, 1, 0]\nfov = 90\n");
        ASSERT_EQ(
            render({"--camera=face.cam", "-w", "128", "-h", "128", "-o", "face.png", "--force"}).exitCode, 0);
        // The panorama of that camera has the face in its middle.
        ASSERT_EQ(render({"--camera=face.cam", "--panorama=512", "-o", "middle.png", "--force"}).exitCode, 0);
        const rtcore::LdrImage flat = image("face.png"), middle = image("middle.png");
        for (int y = 2; y < kSide; y += 5) {
            for (int x = 2; x < kSide; x += 5) {
                const double right = (x + 0.5) / kSide * 2 - 1, down = (y + 0.5) / kSide * 2 - 1;
                const double column = (std::atan2(right, 1) / 6.283185307 + 0.5) * kAround;
                const double row = (std::atan2(down, std::hypot(right, 1)) / 3.141592654 + 0.5) * kAround / 2;
                const auto& seen = middle.at(static_cast<int>(column), static_cast<int>(row));
                ++compared;
                wrong += difference(seen, flat.at(x, y)) > 12 ? 1 : 0; // an edge lies in one of the pixels
            }
        }
    }
    EXPECT_LT(wrong, compared / 20) << "of " << compared;
}

TEST_F(Panoramas, HaveNoSeam) {
    ASSERT_EQ(render({"--panorama=256", "-o", "around.png"}).exitCode, 0);
    const rtcore::LdrImage whole = image("around.png");
    int inside = 0, seam = 0;
    for (int y = 0; y < whole.height; ++y) {
        inside = std::max(inside, difference(whole.at(64, y), whole.at(65, y)));
        seam = std::max(seam, difference(whole.at(0, y), whole.at(whole.width - 1, y)));
    }
    EXPECT_LE(seam, inside + 60); // two neighbours, as inside, but for an edge that passes there
    double mean = 0;
    for (int y = 0; y < whole.height; ++y) mean += difference(whole.at(0, y), whole.at(whole.width - 1, y));
    EXPECT_LT(mean / whole.height, 8);
}

TEST_F(Panoramas, AreKnownAsSuchAndRenderedByPaths) {
    ASSERT_EQ(render({"--panorama=64", "-o", "a.jpg", "-o", "a.png", "-o", "a.exr",
                      "--setting=integrator=path", "--setting=path.samples=4"})
                  .exitCode,
              0);
    for (const char* const file : {"a.jpg", "a.png"})
        EXPECT_NE(test::readBytes(folder / file).find("GPano:FullPanoWidthPixels=\"64\""), std::string::npos)
            << file;
    ASSERT_EQ(render({"-w", "64", "-o", "flat.png"}).exitCode, 0);
    EXPECT_EQ(test::readBytes(folder / "flat.png").find("GPano"), std::string::npos);
}

TEST_F(Panoramas, OfOddOrdersAreRefused) {
    const auto refused = [&](const Names& words, const std::string& part) {
        const test::ProgramResult result = render(words);
        EXPECT_EQ(result.exitCode, 2) << result.error;
        EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
    };
    refused({"--panorama=65", "-o", "a.png"}, "even number");
    refused({"--panorama=64", "-w", "64", "-o", "a.png"}, "leave out --width");
    refused({"--panorama=64", "--focus-at=3,3", "-o", "a.png"}, "leave out --focus-at");
    refused({"--panorama=0", "-o", "a.png"}, "panorama");
    refused({"--panorama=64000", "-o", "a.png"}, "panorama");
}

} // namespace

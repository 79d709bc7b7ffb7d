#include "test_images.h"

#include "rtcore/math/colour.h"
#include "support/image_texts.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <thread>

namespace rtcore {
namespace {

using test::hdrNoise;
using test::noiseImage;
using test::smoothImage;
using test::TemporaryFolder;

constexpr std::array<std::array<int, 2>, 7> kSizes{
    {{1, 1}, {1, 7}, {7, 1}, {3, 5}, {8, 8}, {17, 13}, {300, 3}}};

int largestDifference(const LdrImage& a, const LdrImage& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const Rgba8 p = a.pixels[i], q = b.pixels[i];
        largest = std::max(
            {largest, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b), std::abs(p.a - q.a)});
    }
    return largest;
}

std::size_t filesIn(const TemporaryFolder& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder.path()), {}));
}

class LosslessFormat : public testing::TestWithParam<const char*> {};

TEST_P(LosslessFormat, KeepsEveryPixel) {
    for (const auto& [w, h] : kSizes) {
        for (const LdrImage& image : {noiseImage(w, h), smoothImage(w, h)}) {
            const LdrImage back = decodeLdrImage(encodeImage(image, GetParam()), "memory");
            ASSERT_EQ(back.width, w);
            ASSERT_EQ(back.height, h);
            EXPECT_EQ(back.pixels, image.pixels) << w << " x " << h;
        }
    }
}

TEST_P(LosslessFormat, ReplacesTheFileAndNothingElse) {
    const TemporaryFolder folder;
    const auto path = folder / (std::string("picture.") + GetParam());
    writeImage(path, noiseImage(9, 2));
    writeImage(path, noiseImage(5, 3));
    EXPECT_EQ(readLdrImage(path).pixels, noiseImage(5, 3).pixels);
    EXPECT_EQ(filesIn(folder), 1U);
}
INSTANTIATE_TEST_SUITE_P(Formats, LosslessFormat,
                         testing::Values("png", "PNG", "bmp", "ppm", "tga", "tif", "tiff", "Tiff"));

class AlphaFormat : public testing::TestWithParam<const char*> {};

TEST_P(AlphaFormat, KeepsAlpha) {
    for (const auto& [w, h] : kSizes) {
        const LdrImage image = noiseImage(w, h, true);
        EXPECT_EQ(decodeLdrImage(encodeImage(image, GetParam()), "memory").pixels, image.pixels)
            << w << " x " << h;
    }
}
INSTANTIATE_TEST_SUITE_P(Formats, AlphaFormat, testing::Values("png", "tga", "tif"));

class OpaqueFormat : public testing::TestWithParam<const char*> {};

TEST_P(OpaqueFormat, DropsAlphaAndKeepsColour) {
    const TemporaryFolder folder;
    const auto path = folder / (std::string("picture.") + GetParam());
    LdrImage image = noiseImage(9, 4, true);
    writeImage(path, image);
    for (Rgba8& p : image.pixels) p.a = 255;
    EXPECT_EQ(readLdrImage(path).pixels, image.pixels);
}
INSTANTIATE_TEST_SUITE_P(Formats, OpaqueFormat, testing::Values("bmp", "ppm"));

TEST(Jpeg, StaysCloseToSmoothPictures) {
    for (const auto& [w, h] : kSizes) {
        const LdrImage image = smoothImage(w, h);
        const LdrImage back = decodeLdrImage(encodeImage(image, "jpeg"), "memory");
        ASSERT_EQ(back.width, w);
        ASSERT_EQ(back.height, h);
        EXPECT_LE(largestDifference(image, back), 24) << w << " x " << h;
    }
}

TEST(Hdr, ExrAndPfmAreExact) {
    const TemporaryFolder folder;
    for (const auto& [w, h] : kSizes) {
        HdrImage image = hdrNoise(w, h);
        image.pixels.front() = {1e6F, 1e-6F, 0};
        image.pixels.back().b = 1e-30F;
        for (const char* name : {"picture.pfm", "picture.exr"}) {
            if (!isWritableFormat(name)) continue;
            writeHdrImage(folder / name, image);
            const HdrImage back = readHdrImage(folder / name);
            ASSERT_EQ(back.width, w);
            EXPECT_EQ(back.pixels, image.pixels) << name << ' ' << w << " x " << h;
        }
    }
}

TEST(Hdr, RadianceIsWithinOnePercentOfTheLargestComponent) {
    const TemporaryFolder folder;
    for (const auto& [w, h] : kSizes) {
        HdrImage image = hdrNoise(w, h);
        image.pixels.front() = {1e6F, 1e6F, 1e6F};
        image.pixels.back() = {1e-6F, 1e-6F, 2e-6F};
        if (w > 150) std::fill(image.pixels.begin() + 20, image.pixels.begin() + 290, Colour{1, 0.5F, 0.25F});
        writeHdrImage(folder / "picture.hdr", image);
        const HdrImage back = readHdrImage(folder / "picture.hdr");
        ASSERT_EQ(back.width, w);
        ASSERT_EQ(back.height, h);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const Colour a = image.pixels[i], b = back.pixels[i];
            EXPECT_LE(maxComponent({std::fabs(a.r - b.r), std::fabs(a.g - b.g), std::fabs(a.b - b.b)}),
                      0.005F * maxComponent(a));
        }
    }
}

TEST(Hdr, RadianceTakesExtremes) {
    const TemporaryFolder folder;
    const auto path = folder / "picture.hdr";
    HdrImage image(6, 1);
    image.pixels = {{0, 0, 0},      {-1, 2, 0},      {1e38F, 1, 1},
                    {1e-40F, 0, 0}, {0.9999F, 0, 0}, {NAN, INFINITY, 0}};
    writeHdrImage(path, image);
    const HdrImage back = readHdrImage(path);
    EXPECT_EQ(back.pixels[0], Colour{});
    EXPECT_EQ(back.pixels[1], (Colour{0, 2, 0}));
    EXPECT_NEAR(back.pixels[2].r / 1e38F, 1, 0.005);
    EXPECT_EQ(back.pixels[3], Colour{});
    EXPECT_NEAR(back.pixels[4].r, 1, 0.005);
    EXPECT_TRUE(isFinite(back.pixels[5]));
    EXPECT_GT(back.pixels[5].g, 1.6e38F); // the most that the format holds
}

TEST(Hdr, ValuesThatAreNotFiniteAreReplaced) {
    const TemporaryFolder folder;
    HdrImage image(2, 1);
    image.pixels = {{NAN, INFINITY, -INFINITY}, {-1, 2, 3}};
    writeHdrImage(folder / "picture.pfm", image);
    const HdrImage back = readHdrImage(folder / "picture.pfm");
    EXPECT_EQ(back.pixels[0], (Colour{0, 65504, -65504}));
    EXPECT_EQ(back.pixels[1], (Colour{-1, 2, 3}));
    EXPECT_EQ(readLdrImage(folder / "picture.pfm").pixels[0].g, 255);
}

TEST(Conversion, EightBitsBecomeLinearAndComeBack) {
    const TemporaryFolder folder;
    LdrImage ramp(256, 1);
    for (int i = 0; i < 256; ++i) {
        const auto v = static_cast<std::uint8_t>(i);
        ramp.at(i, 0) = {v, v, v, 255};
    }
    writeImage(folder / "ramp.png", ramp);
    const HdrImage linear = readHdrImage(folder / "ramp.png");
    for (int i = 0; i < 256; ++i) EXPECT_EQ(linear.at(i, 0).g, srgbDecode(static_cast<float>(i) / 255.0F));
    writeHdrImage(folder / "ramp.pfm", linear);
    EXPECT_EQ(readLdrImage(folder / "ramp.pfm").pixels, ramp.pixels);
    writeImage(folder / "again.pfm", ramp); // a linear format takes an image of eight bits, too
    EXPECT_EQ(readHdrImage(folder / "again.pfm").pixels, linear.pixels);
}

TEST(Formats, AreKnownByExtension) {
    for (const char* name : {"a.exr", "a.HDR", "/b.c/a.pfm"}) EXPECT_TRUE(isHdrFormat(name)) << name;
    for (const char* name : {"a.png", "a", "exr", ".exr", ""}) EXPECT_FALSE(isHdrFormat(name)) << name;
    for (const char* name : {"a.png", "a.jpg", "a.jpeg", "a.bmp", "a.ppm", "a.tga", "a.tif", "a.tiff",
                             "a.hdr", "a.pfm", "A.PNG"}) {
        EXPECT_TRUE(isWritableFormat(name)) << name;
    }
    for (const char* name : {"a.txt", "a", "a.pdf", "a.mp4", "a.svg", "a.png.gz", ""}) {
        EXPECT_FALSE(isWritableFormat(name)) << name;
    }
    EXPECT_EQ(writableFormats().rfind("png, jpg", 0), 0U) << writableFormats();
}

TEST(Formats, EveryWritableOneCanBeReadBack) {
    const TemporaryFolder folder;
    const LdrImage image = smoothImage(64, 48);
    std::istringstream list(writableFormats());
    for (std::string extension; std::getline(list >> std::ws, extension, ',');) {
        const auto path = folder / ("picture." + extension);
        if (extension == "pcx") continue; // has no mark of its own: written only
        writeImage(path, image);
        const LdrImage back = readLdrImage(path);
        EXPECT_EQ(back.width, 64) << extension;
        EXPECT_EQ(back.height, 48) << extension;
        EXPECT_LE(largestDifference(image, back), 48) << extension;
    }
}

TEST(Formats, ContentCountsNotTheName) {
    const TemporaryFolder folder;
    const LdrImage image = noiseImage(5, 5);
    writeImage(folder / "a.png", image);
    std::filesystem::rename(folder / "a.png", folder / "a.jpg");
    EXPECT_EQ(readLdrImage(folder / "a.jpg").pixels, image.pixels);
}

std::string asText(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(Formats, PngAndExrHoldTexts) {
    const TemporaryFolder folder;
    const LdrImage image = noiseImage(5, 5);
    const std::vector<ImageText> texts{{"Software", "a program 1.0"}, {"samples", "16"}, {"empty", ""}};
    const test::Texts expected{{"Software", "a program 1.0"}, {"samples", "16"}, {"empty", ""}};
    const auto textsOf = [&](const char* name) {
        return test::imageTexts(asText(test::loadBytes(folder / name)));
    };
    writeImage(folder / "a.png", image, {.texts = texts});
    EXPECT_EQ(textsOf("a.png"), expected);
    EXPECT_EQ(readLdrImage(folder / "a.png").pixels, image.pixels);
    EXPECT_EQ(encodeImage(image, "png", {.texts = texts}), test::loadBytes(folder / "a.png"));
    writeImage(folder / "none.png", image);
    EXPECT_EQ(textsOf("none.png"), test::Texts());
    writeImage(folder / "a.jpg", image, {.texts = texts});
    writeImage(folder / "none.jpg", image);
    EXPECT_EQ(test::loadBytes(folder / "a.jpg"), test::loadBytes(folder / "none.jpg"));
    if (!isWritableFormat("a.exr")) GTEST_SKIP() << "this build has no OpenEXR";
    const HdrImage linear(3, 2, {0.5F, 1, 2});
    writeHdrImage(folder / "a.exr", linear, texts);
    EXPECT_EQ(textsOf("a.exr"), expected);
    EXPECT_EQ(readHdrImage(folder / "a.exr").pixels, linear.pixels);
    const ImageChannel channel{"Y", &linear.pixels.front().r, 3};
    writeExrChannels(folder / "b.exr", 3, 2, std::span(&channel, 1), texts);
    EXPECT_EQ(textsOf("b.exr"), expected);
}

// As their specifications have it: 11,811 pixels to a metre, and a fraction of inches.
TEST(Formats, PngAndTiffKeepTheirResolution) {
    const TemporaryFolder folder;
    const LdrImage image = noiseImage(5, 5);
    writeImage(folder / "a.png", image, {.dpi = 300});
    const std::string png = asText(test::loadBytes(folder / "a.png"));
    const std::string size("pHYs\0\0\x2E\x23\0\0\x2E\x23\1", 13);
    EXPECT_NE(png.find(size), std::string::npos);
    EXPECT_EQ(readLdrImage(folder / "a.png").pixels, image.pixels) << "its checksums are right";
    writeImage(folder / "a.tif", image, {.dpi = 300});
    const std::string tiff = asText(test::loadBytes(folder / "a.tif"));
    EXPECT_NE(tiff.find(std::string("\x1B\1\5\0\1\0\0\0", 8)), std::string::npos) << "XResolution is there";
    EXPECT_EQ(readLdrImage(folder / "a.tif").pixels, image.pixels);
    writeImage(folder / "none.png", image);
    EXPECT_EQ(asText(test::loadBytes(folder / "none.png")).find("pHYs"), std::string::npos);
}

TEST(Memory, EncodedPicturesAreTheFilesContent) {
    const TemporaryFolder folder;
    const LdrImage image = noiseImage(31, 7);
    for (const char* format : {"png", "ppm", "jpg", "bmp", "tga", "tif"}) {
        const auto path = folder / (std::string("a.") + format);
        writeImage(path, image);
        const std::vector<std::byte> bytes = encodeImage(image, format);
        EXPECT_EQ(bytes, test::loadBytes(path)) << format;
        if (std::string(format) != "jpg") {
            EXPECT_EQ(decodeLdrImage(bytes, "memory").pixels, image.pixels);
        }
    }
    EXPECT_THROW(encodeImage(image, "nothing"), FileError);
}

void expectCannotWrite(const std::filesystem::path& path, const LdrImage& image) {
    try {
        writeImage(path, image);
        ADD_FAILURE() << path << " was written";
    } catch (const FileError& error) {
        EXPECT_EQ(error.kind, FailureKind::CannotWrite) << error.what();
        EXPECT_NE(std::string(error.what()).find(path.filename().string()), std::string::npos)
            << error.what();
    }
}

TEST(Writing, FailuresAreErrorsAndLeaveNothing) {
    const TemporaryFolder folder;
    for (const char* name :
         {"a.png", "a.jpg", "a.bmp", "a.ppm", "a.tga", "a.tif", "a.hdr", "a.pfm", "a.exr"}) {
        expectCannotWrite(folder / "missing" / name, noiseImage(3, 3));
        expectCannotWrite(folder / name, LdrImage{});
    }
    expectCannotWrite(folder / "a.xyz", noiseImage(3, 3));
    expectCannotWrite(folder / "a", noiseImage(3, 3));
    LdrImage lying(3, 3);
    lying.width = 30;
    expectCannotWrite(folder / "a.png", lying);
    EXPECT_THROW(writeHdrImage(folder / "a.png", hdrNoise(2, 2)), FileError);
    EXPECT_EQ(filesIn(folder), 0U);
}

/// libjpeg's and CImg's own way with a full disk is to end the process, or not to notice.
TEST(Writing, AFullDiskIsAnError) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const TemporaryFolder folder;
    for (const char* name : {"a.png", "a.jpg", "a.bmp", "a.ppm", "a.tga", "a.tif", "a.hdr", "a.pfm"}) {
        std::filesystem::create_symlink("/dev/full", folder / name);
        expectCannotWrite(folder / name, noiseImage(200, 200));
    }
}

TEST(Writing, AFailureKeepsTheOldFile) {
    const TemporaryFolder folder;
    const LdrImage image = noiseImage(4, 4);
    writeImage(folder / "a.png", image);
    expectCannotWrite(folder / "a.png", LdrImage{});
    EXPECT_EQ(readLdrImage(folder / "a.png").pixels, image.pixels);
    EXPECT_EQ(filesIn(folder), 1U);
}

TEST(Threads, MayReadAndWriteAtOnce) {
    const TemporaryFolder folder;
    std::vector<std::thread> threads;
    std::array<bool, 8> same{};
    for (unsigned i = 0; i < same.size(); ++i) {
        threads.emplace_back([&, i] {
            const char* formats[] = {"png", "bmp", "ppm", "tif"};
            const auto path = folder / (std::to_string(i) + "." + formats[i % 4]);
            const LdrImage image = noiseImage(40, 40, false, i);
            writeImage(path, image);
            same[i] = readLdrImage(path).pixels == image.pixels;
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const bool ok : same) EXPECT_TRUE(ok);
}

} // namespace

TEST(ImageNotes, OfAPanoramaAreXmpThatReadersPass) {
    const LdrImage image = test::noiseImage(64, 32, false);
    for (const char* const format : {"png", "jpg"}) {
        const std::vector<std::byte> bytes = encodeImage(image, format, {.panorama = true});
        const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        EXPECT_NE(text.find("GPano:ProjectionType=\"equirectangular\""), std::string::npos) << format;
        EXPECT_NE(text.find("GPano:FullPanoWidthPixels=\"64\" GPano:FullPanoHeightPixels=\"32\""),
                  std::string::npos)
            << format;
        EXPECT_EQ(decodeLdrImage(bytes, "memory").pixels,
                  decodeLdrImage(encodeImage(image, format), "memory").pixels)
            << format;
    }
    const std::vector<std::byte> flat = encodeImage(image, "png");
    const std::string text(reinterpret_cast<const char*>(flat.data()), flat.size());
    EXPECT_EQ(text.find("GPano"), std::string::npos);
}

} // namespace rtcore

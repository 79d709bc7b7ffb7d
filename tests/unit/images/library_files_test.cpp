/// Files that only the libraries can make: JPEG in grey, CMYK and progressive, EXR in half precision.
#include "test_images.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>

#ifdef RT_HAVE_OPENEXR
#include "support/temporary_folder.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#endif

namespace rtcore {
namespace {

/// 16 x 16 pixels of one value.
test::Bytes jpegOf(J_COLOR_SPACE space, std::vector<JSAMPLE> pixel, bool progressive) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &buffer, &size);
    info.image_width = info.image_height = 16;
    info.input_components = static_cast<int>(pixel.size());
    info.in_color_space = space;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, 100, TRUE);
    if (progressive) jpeg_simple_progression(&info);
    jpeg_start_compress(&info, TRUE);
    std::vector<JSAMPLE> row;
    for (int x = 0; x < 16; ++x) row.insert(row.end(), pixel.begin(), pixel.end());
    JSAMPROW rows = row.data();
    for (int y = 0; y < 16; ++y) jpeg_write_scanlines(&info, &rows, 1);
    jpeg_finish_compress(&info);
    jpeg_destroy_compress(&info);
    const auto* data = reinterpret_cast<const std::byte*>(buffer);
    test::Bytes bytes(data, data + size);
    std::free(buffer);
    return bytes;
}

void expectColour(const test::Bytes& bytes, Rgba8 expected) {
    const LdrImage image = decodeLdrImage(bytes, "made.jpg");
    ASSERT_EQ(image.width, 16);
    for (const Rgba8 p : image.pixels) {
        EXPECT_NEAR(p.r, expected.r, 2);
        EXPECT_NEAR(p.g, expected.g, 2);
        EXPECT_NEAR(p.b, expected.b, 2);
        EXPECT_EQ(p.a, 255);
    }
}

TEST(JpegFiles, EveryColourSpace) {
    for (const bool progressive : {false, true}) {
        expectColour(jpegOf(JCS_GRAYSCALE, {90}, progressive), {90, 90, 90, 255});
        expectColour(jpegOf(JCS_RGB, {200, 100, 50}, progressive), {200, 100, 50, 255});
        // Adobe's way, which libjpeg marks: the values are 255 - ink.
        expectColour(jpegOf(JCS_CMYK, {255, 128, 0, 255}, progressive), {255, 128, 0, 255});
        expectColour(jpegOf(JCS_CMYK, {255, 128, 0, 128}, progressive), {128, 64, 0, 255});
    }
}

TEST(JpegFiles, TruncatedOnesAreErrors) {
    const test::Bytes bytes = encodeImage(test::noiseImage(40, 40), "jpg");
    for (std::size_t n = 0; n + 2 < bytes.size(); ++n) { // the end marker alone may be missing
        EXPECT_THROW(decodeLdrImage({bytes.data(), n}, "cut.jpg"), FileError) << n << " of " << bytes.size();
    }
}

#ifdef RT_HAVE_OPENEXR
TEST(ExrFiles, HalfPrecisionWithAnOffsetWindow) {
    const test::TemporaryFolder folder;
    const std::string path = (folder / "half.exr").string();
    const Imath::Box2i display({0, 0}, {99, 99}), window({-3, 5}, {-2, 7}); // 2 x 3 pixels
    std::vector<Imf::Rgba> pixels(6);
    for (std::size_t i = 0; i < 6; ++i) pixels[i] = Imf::Rgba(static_cast<float>(i), 0.5F, 1000, 0.25F);
    {
        Imf::RgbaOutputFile file(path.c_str(), display, window, Imf::WRITE_RGBA);
        file.setFrameBuffer(pixels.data() + 3 - 5 * 2, 1, 2);
        file.writePixels(3);
    }
    const HdrImage image = readHdrImage(path);
    ASSERT_EQ(image.width, 2);
    ASSERT_EQ(image.height, 3);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_EQ(image.pixels[i], (Colour{static_cast<float>(i), 0.5F, 1000}));
}

test::Bytes exrWith(const char* channel, const test::TemporaryFolder& folder) {
    Imf::Header header(2, 1);
    header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    float values[] = {1.5F, 7};
    Imf::FrameBuffer frame;
    frame.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values), 4, 8));
    const std::string path = (folder / "one.exr").string();
    {
        Imf::OutputFile file(path.c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(1);
    }
    return test::loadBytes(path);
}

TEST(ExrFiles, GreyIsReadAndOtherChannelsAreNamed) {
    const test::TemporaryFolder folder;
    const HdrImage grey = decodeHdrImage(exrWith("Y", folder), "grey.exr");
    EXPECT_EQ(grey.pixels, (std::vector<Colour>{{1.5F, 1.5F, 1.5F}, {7, 7, 7}}));
    try {
        decodeHdrImage(exrWith("depth.Z", folder), "depth.exr");
        ADD_FAILURE() << "an image of depths is no image";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("depth.Z"), std::string::npos) << error.what();
    }
}
#endif

} // namespace
} // namespace rtcore

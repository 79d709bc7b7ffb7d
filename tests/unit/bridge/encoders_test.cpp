#include "bridge/stream/jpeg_strips.h"
#include "bridge/stream/motion_encoder.h"
#include "bridge/stream/shrink.h"
#include "bridge/stream/still_encoder.h"

#include <gtest/gtest.h>

#include <csetjmp>
#include <cstdio>
#include <jpeglib.h>
#include <png.h>
#include <random>

namespace {

using bridge::Pixels;

std::vector<std::byte> randomPixels(int width, int height) {
    std::mt19937 random(7);
    std::vector<std::byte> bytes(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
    return bytes;
}

std::vector<unsigned char> decodePng(const std::vector<std::uint8_t>& file, unsigned& width,
                                     unsigned& height) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, file.data(), file.size()) == 0) return {};
    EXPECT_EQ(image.format & PNG_FORMAT_FLAG_ALPHA, 0U);
    image.format = PNG_FORMAT_RGB;
    std::vector<unsigned char> out(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, out.data(), 0, nullptr) == 0) return {};
    width = image.width;
    height = image.height;
    return out;
}

std::vector<unsigned char> decodeJpeg(std::span<const std::uint8_t> file, unsigned& width, unsigned& height) {
    jpeg_error_mgr errors{};
    jpeg_decompress_struct jpeg{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, file.data(), file.size());
    jpeg_read_header(&jpeg, TRUE);
    jpeg.do_fancy_upsampling = FALSE; // rows know nothing of their neighbours
    jpeg_start_decompress(&jpeg);
    width = jpeg.image_width;
    height = jpeg.image_height;
    const std::size_t row = 3 * static_cast<std::size_t>(width);
    std::vector<unsigned char> out(row * height);
    while (jpeg.output_scanline < height) {
        unsigned char* to = out.data() + row * jpeg.output_scanline;
        jpeg_read_scanlines(&jpeg, &to, 1);
    }
    EXPECT_EQ(errors.num_warnings, 0);
    jpeg_finish_decompress(&jpeg);
    jpeg_destroy_decompress(&jpeg);
    return out;
}

void sizeOfJpeg(std::span<const std::uint8_t> file, unsigned& width, unsigned& height) {
    decodeJpeg(file, width, height);
}

TEST(StillEncoder, KeepsEveryPixel) {
    bridge::StillEncoder encoder;
    for (const auto& [width, height] :
         {std::pair(1, 1), std::pair(7, 3), std::pair(64, 48), std::pair(3, 200)}) {
        const std::vector<std::byte> bytes = randomPixels(width, height);
        const bridge::SharedFrame frame = encoder.encode({bytes, width, height}, {});
        EXPECT_TRUE(frame->exact);
        unsigned w = 0, h = 0;
        const std::vector<unsigned char> decoded = decodePng(frame->bytes, w, h);
        ASSERT_EQ(w, static_cast<unsigned>(width));
        ASSERT_EQ(h, static_cast<unsigned>(height));
        for (std::size_t i = 0; i < decoded.size(); ++i)
            ASSERT_EQ(decoded[i], static_cast<unsigned char>(bytes[i / 3 * 4 + i % 3])) << i;
    }
}

TEST(MotionEncoder, MakesJpegsOfEachRungsSize) {
    const std::vector<std::byte> bytes = randomPixels(61, 40);
    bridge::MotionEncoder encoder;
    for (const bridge::Rung& rung : bridge::kRungs) {
        const bridge::SharedFrame frame = encoder.encode({bytes, 61, 40}, rung, {});
        unsigned w = 0, h = 0;
        sizeOfJpeg(frame->bytes, w, h);
        EXPECT_EQ(w, static_cast<unsigned>(61 / rung.divide));
        EXPECT_EQ(h, static_cast<unsigned>(40 / rung.divide));
        EXPECT_EQ(frame->facts.width, w);
        EXPECT_FALSE(frame->exact);
    }
}

TEST(MotionEncoder, MakesFramesAsFineAsTheRungAsksForWhateverTheServerDraws) {
    const std::vector<std::byte> bytes = randomPixels(40, 20);
    bridge::FrameFacts facts;
    bridge::MotionEncoder encoder;
    const auto widthOf = [&](std::uint16_t shown, int divide) {
        facts.shownWidth = shown;
        facts.shownHeight = shown / 2;
        const bridge::SharedFrame frame = encoder.encode({bytes, 40, 20}, {divide, 60, 1}, facts);
        EXPECT_EQ(frame->facts.height, frame->facts.width / 2);
        return frame->facts.width;
    };
    EXPECT_EQ(widthOf(40, 2), 20);
    EXPECT_EQ(widthOf(80, 2), 40);
    EXPECT_EQ(widthOf(120, 3), 40);
    EXPECT_EQ(widthOf(60, 3), 20);
    EXPECT_EQ(widthOf(72, 2), 36);
    EXPECT_EQ(widthOf(200, 2), 40) << "no finer than it is drawn";
}

// A frame of several strips is one image, and is what its strips are.
TEST(MotionEncoder, JoinsStripsIntoOneJpeg) {
    constexpr int kWidth = 16000, kHeight = 300; // ten strips, so that restarts are counted beyond 8
    const int rows = bridge::stripHeight(kWidth);
    EXPECT_EQ(rows, 32);
    std::vector<std::byte> bytes(std::size_t(4) * kWidth * kHeight);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i / 8 + i % 4 * 90);
    bridge::MotionEncoder encoder;
    for (const bool fine : {false, true}) {
        const auto encoded = [&](int top, int height) {
            const std::size_t row = 4 * kWidth;
            const Pixels part{std::span(bytes).subspan(row * static_cast<std::size_t>(top),
                                                       row * static_cast<std::size_t>(height)),
                              kWidth, height};
            const bridge::SharedFrame frame =
                fine ? encoder.encodeFine(part, {}) : encoder.encode(part, bridge::kRungs[1], {});
            unsigned w = 0, h = 0;
            std::vector<unsigned char> pixels = decodeJpeg(frame->bytes, w, h);
            EXPECT_EQ(w, static_cast<unsigned>(kWidth));
            EXPECT_EQ(h, static_cast<unsigned>(height));
            return pixels;
        };
        const std::vector<unsigned char> whole = encoded(0, kHeight);
        std::vector<unsigned char> parts;
        for (int top = 0; top < kHeight; top += rows) {
            const std::vector<unsigned char> part = encoded(top, std::min(rows, kHeight - top));
            parts.insert(parts.end(), part.begin(), part.end());
        }
        EXPECT_TRUE(whole == parts) << fine;
    }
    EXPECT_EQ(bridge::stripHeight(1), 16 * (1 << 15));
    EXPECT_EQ(bridge::stripHeight(1 << 20), 16);
}

TEST(MotionEncoder, TakesFramesOfOnePixel) {
    const std::vector<std::byte> bytes = randomPixels(1, 1);
    bridge::MotionEncoder encoder;
    for (const bridge::Rung& rung : bridge::kRungs)
        EXPECT_EQ(encoder.encode({bytes, 1, 1}, rung, {})->facts.width, 1);
}

TEST(Shrink, IsTheMeanOfWhatIsCovered) {
    std::vector<std::byte> bytes(4 * 5 * 4, std::byte(0)), out;
    for (std::size_t i = 0; i < bytes.size(); i += 4) bytes[i] = static_cast<std::byte>(i / 4 * 10);
    const Pixels whole{bytes, 5, 4};
    const Pixels small = bridge::shrink(whole, 2, 2, out);
    ASSERT_EQ(small.width, 2);
    ASSERT_EQ(small.height, 2);
    EXPECT_EQ(static_cast<int>(small.bytes[0]), 33); // of 0, 10, half of 20, 50, 60, half of 70
    EXPECT_EQ(static_cast<int>(small.bytes[4]), 57);
    EXPECT_EQ(static_cast<int>(small.bytes[8]), 133);
    EXPECT_EQ(static_cast<int>(small.bytes[1]), 0);
    EXPECT_EQ(static_cast<int>(small.bytes[3]), 255);
    EXPECT_EQ(static_cast<int>(bridge::shrink(whole, 1, 1, out).bytes[0]), 95);
    const Pixels same = bridge::shrink(whole, 5, 4, out);
    for (std::size_t i = 0; i < bytes.size(); i += 4) EXPECT_EQ(same.bytes[i], bytes[i]);

    const std::vector<std::byte> white(4 * 7 * 9, std::byte(255));
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(3, 4), std::pair(6, 5), std::pair(7, 8)})
        for (const std::byte byte : bridge::shrink({white, 7, 9}, width, height, out).bytes)
            ASSERT_EQ(byte, std::byte(255));
}

} // namespace

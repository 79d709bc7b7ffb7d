/// Files as other programs write them, made by hand.
#include "test_images.h"

#include "rtcore/math/colour.h"

#include <gtest/gtest.h>

#include <bit>

namespace rtcore {
namespace {

using test::Bytes;
using test::FileMaker;
using test::PngMaker;
using test::tiffOf;
using Pixels = std::vector<Rgba8>;

Pixels pixelsOf(const Bytes& bytes) { return decodeLdrImage(bytes, "made.file").pixels; }

Rgba8 grey(unsigned v, unsigned a = 255) {
    const auto c = static_cast<std::uint8_t>(v);
    return {c, c, c, static_cast<std::uint8_t>(a)};
}

TEST(PngFiles, GreyOfEveryDepth) {
    EXPECT_EQ(pixelsOf(PngMaker(3, 1, 1, 0).finish(FileMaker().u8({0, 0b10100000}).bytes)),
              (Pixels{grey(255), grey(0), grey(255)}));
    EXPECT_EQ(pixelsOf(PngMaker(3, 1, 2, 0).finish(FileMaker().u8({0, 0b01101100}).bytes)),
              (Pixels{grey(85), grey(170), grey(255)}));
    EXPECT_EQ(pixelsOf(PngMaker(2, 1, 4, 0).finish(FileMaker().u8({0, 0x1f}).bytes)),
              (Pixels{grey(17), grey(255)}));
    EXPECT_EQ(pixelsOf(PngMaker(2, 1, 8, 0).finish(FileMaker().u8({0, 9, 200}).bytes)),
              (Pixels{grey(9), grey(200)}));
    EXPECT_EQ(pixelsOf(PngMaker(2, 1, 8, 4).finish(FileMaker().u8({0, 9, 1, 200, 2}).bytes)),
              (Pixels{grey(9, 1), grey(200, 2)}));
    EXPECT_EQ(pixelsOf(PngMaker(1, 1, 16, 4).finish(FileMaker().u8({0, 0x80, 0x80, 0xff, 0xff}).bytes)),
              (Pixels{grey(128)}));
}

TEST(PngFiles, SixteenBitsKeepTheirDepth) {
    const Bytes bytes =
        PngMaker(1, 1, 16, 2).finish(FileMaker().u8({0, 0x80, 0x01, 0x00, 0x01, 0xff, 0xff}).bytes);
    const Colour c = decodeHdrImage(bytes, "a.png").pixels[0];
    EXPECT_EQ(c.r, srgbDecode(32769.0F / 65535.0F));
    EXPECT_EQ(c.g, srgbDecode(1.0F / 65535.0F));
    EXPECT_EQ(c.b, 1.0F);
    EXPECT_EQ(pixelsOf(bytes)[0], (Rgba8{128, 0, 255, 255}));
}

TEST(PngFiles, PaletteWithTransparency) {
    PngMaker png(4, 1, 2, 3);
    png.chunk("PLTE", FileMaker().u8({255, 0, 0, 0, 255, 0, 0, 0, 255}).bytes)
        .chunk("tRNS", FileMaker().u8({255, 7}).bytes);
    EXPECT_EQ(pixelsOf(png.finish(FileMaker().u8({0, 0b00011000}).bytes)),
              (Pixels{{255, 0, 0, 255}, {0, 255, 0, 7}, {0, 0, 255, 255}, {255, 0, 0, 255}}));
}

TEST(PngFiles, EveryTruncationIsAnError) {
    const Bytes bytes = encodeImage(test::noiseImage(9, 9), "png");
    for (std::size_t n = 0; n + 1 < bytes.size(); ++n) {
        EXPECT_THROW(decodeLdrImage({bytes.data(), n}, "a.png"), FileError) << n;
    }
}

/// Header of 40 bytes, palette, rows.
Bytes bmpOf(int w, int h, unsigned bits, std::uint32_t compression, const Bytes& paletteOrMasks,
            std::uint32_t used, const Bytes& rows) {
    FileMaker file;
    const auto offset = static_cast<std::uint32_t>(54 + paletteOrMasks.size());
    file.text("BM").u32({offset + static_cast<std::uint32_t>(rows.size()), 0, offset, 40});
    file.u32({static_cast<std::uint32_t>(w), static_cast<std::uint32_t>(h)}).u16({1, bits});
    return file.u32({compression, 0, 0, 0, used, 0}).add(paletteOrMasks).add(rows).bytes;
}

const Rgba8 kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255}, kBlue{0, 0, 255, 255};
const Bytes kPalette = FileMaker().u8({0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0, 0}).bytes; // red, green, blue

TEST(BmpFiles, PalettesShorterThanFull) {
    const Bytes row8 = FileMaker().u8({0, 1, 2, 0}).bytes, row4 = FileMaker().u8({0x01, 0x20, 0, 0}).bytes;
    EXPECT_EQ(pixelsOf(bmpOf(3, 1, 8, 0, kPalette, 3, row8)), (Pixels{kRed, kGreen, kBlue}));
    EXPECT_EQ(pixelsOf(bmpOf(3, 1, 4, 0, kPalette, 3, row4)), (Pixels{kRed, kGreen, kBlue}));
    EXPECT_EQ(pixelsOf(bmpOf(3, 1, 1, 0, {kPalette.begin(), kPalette.begin() + 8}, 2,
                             FileMaker().u8({0b01000000, 0, 0, 0}).bytes)),
              (Pixels{kRed, kGreen, kRed}));
}

TEST(BmpFiles, SixteenBits) {
    const Bytes row = FileMaker().u16({0x7c00, 0x03e0, 0x001f, 0}).bytes;
    EXPECT_EQ(pixelsOf(bmpOf(3, 1, 16, 0, {}, 0, row)), (Pixels{kRed, kGreen, kBlue}));
    const Bytes masks = FileMaker().u32({0xf800, 0x07e0, 0x001f}).bytes;
    const Bytes row565 = FileMaker().u16({0xf800, 0x07e0, 0x001f, 0}).bytes;
    EXPECT_EQ(pixelsOf(bmpOf(3, 1, 16, 3, masks, 0, row565)), (Pixels{kRed, kGreen, kBlue}));
}

TEST(BmpFiles, ThirtyTwoBitsAndRowsFromTheTop) {
    const Bytes rows = FileMaker().u8({0, 0, 255, 0, 0, 255, 0, 0}).bytes;
    EXPECT_EQ(pixelsOf(bmpOf(1, -2, 32, 0, {}, 0, rows)), (Pixels{kRed, kGreen}));
    EXPECT_EQ(pixelsOf(bmpOf(1, 2, 32, 0, {}, 0, rows)), (Pixels{kGreen, kRed}));
    const Bytes masks = FileMaker().u32({0xff, 0xff00, 0xff0000, 0xff000000}).bytes;
    EXPECT_EQ(pixelsOf(bmpOf(1, 1, 32, 6, masks, 0, FileMaker().u8({1, 2, 3, 4}).bytes)),
              (Pixels{{1, 2, 3, 4}}));
}

TEST(BmpFiles, RunLengths) {
    // Two red, one of each as literals, end; then the row above: a jump over one, two green.
    const Bytes runs8 = FileMaker().u8({2, 0, 0, 3, 0, 1, 2, 0, 0, 0, 0, 2, 1, 0, 2, 1, 0, 1}).bytes;
    const Pixels expected{kRed, kGreen, kGreen, kRed, kRed, kRed, kRed, kRed, kGreen, kBlue};
    EXPECT_EQ(pixelsOf(bmpOf(5, 2, 8, 1, kPalette, 3, runs8)), expected);
    const Bytes runs4 = FileMaker().u8({2, 0x00, 0, 3, 0x01, 0x20, 0, 0, 0, 2, 1, 0, 2, 0x11, 0, 1}).bytes;
    EXPECT_EQ(pixelsOf(bmpOf(5, 2, 4, 2, kPalette, 3, runs4)), expected);
}

TEST(BmpFiles, OldHeader) {
    FileMaker file;
    file.text("BM").u32({0, 0, 26, 12}).u16({2, 1, 1, 24}).u8({0, 0, 255, 0, 255, 0, 0, 0});
    EXPECT_EQ(pixelsOf(file.bytes), (Pixels{kRed, kGreen}));
}

TEST(PnmFiles, EveryKind) {
    const auto text = [](const std::string& s) { return pixelsOf(FileMaker().text(s).bytes); };
    EXPECT_EQ(text("P1\n# a comment\n3 2\n101\n0 1 0\n"),
              (Pixels{grey(0), grey(255), grey(0), grey(255), grey(0), grey(255)}));
    EXPECT_EQ(text("P2 2 1 10 0 10"), (Pixels{grey(0), grey(255)}));
    EXPECT_EQ(text("P3\n1 1 # size\n255\n1 2 3\n"), (Pixels{{1, 2, 3, 255}}));
    EXPECT_EQ(text("P4 9 1\n\xaa\x80"), (Pixels{grey(0), grey(255), grey(0), grey(255), grey(0), grey(255),
                                                grey(0), grey(255), grey(0)}));
    EXPECT_EQ(text("P5 2 1 255\n\n#"), (Pixels{grey(10), grey(35)})); // blank and # as pixels
    EXPECT_EQ(text("P6 1 1 255 abc"), (Pixels{{97, 98, 99, 255}}));
    const Bytes deep = FileMaker().text("P5\n1 1\n65535\n").u8({0x12, 0x34}).bytes;
    EXPECT_EQ(decodeHdrImage(deep, "a.pgm").pixels[0].r, srgbDecode(0x1234 / 65535.0F));
    for (const char* bad :
         {"P6", "P6 1", "P6 0 1 255 a", "P6 1 1 0 abc", "P6 1 1 65536 abcdef", "P6 1 1 255 ab",
          "P3 1 1 9 10 1 1", "P1 1 1 2", "P2 1 1 255 -1", "P6 99999999999 1 255 a", "P6 1 1 255"}) {
        EXPECT_THROW(text(bad), FileError) << bad;
    }
}

Bytes tgaOf(unsigned type, int w, int h, unsigned bits, unsigned descriptor, const Bytes& rest,
            unsigned mapLength = 0) {
    FileMaker file;
    file.u8({0, mapLength > 0 ? 1U : 0U, type})
        .u16({0, mapLength})
        .u8({mapLength > 0 ? 24U : 0U})
        .u16({0, 0});
    return file.u16({static_cast<unsigned>(w), static_cast<unsigned>(h)})
        .u8({bits, descriptor})
        .add(rest)
        .bytes;
}

TEST(TgaFiles, EveryKind) {
    const Bytes map = FileMaker().u8({0, 0, 255, 0, 255, 0}).bytes;
    EXPECT_EQ(pixelsOf(tgaOf(1, 2, 1, 8, 0, FileMaker().add(map).u8({1, 0}).bytes, 2)),
              (Pixels{kGreen, kRed}));
    EXPECT_EQ(pixelsOf(tgaOf(3, 2, 1, 8, 0, FileMaker().u8({5, 6}).bytes)), (Pixels{grey(5), grey(6)}));
    EXPECT_EQ(pixelsOf(tgaOf(2, 1, 2, 24, 0, FileMaker().u8({1, 2, 3, 4, 5, 6}).bytes)),
              (Pixels{{6, 5, 4, 255}, {3, 2, 1, 255}}));
    EXPECT_EQ(pixelsOf(tgaOf(2, 2, 1, 24, 0x30, FileMaker().u8({1, 2, 3, 4, 5, 6}).bytes)),
              (Pixels{{6, 5, 4, 255}, {3, 2, 1, 255}}));
    EXPECT_EQ(pixelsOf(tgaOf(2, 2, 1, 16, 0x21, FileMaker().u16({0xfc00, 0x001f}).bytes)),
              (Pixels{kRed, {0, 0, 255, 0}}));
    EXPECT_EQ(pixelsOf(tgaOf(2, 1, 1, 32, 0x20, FileMaker().u8({3, 2, 1, 0}).bytes)),
              (Pixels{{1, 2, 3, 255}}));
    // A run of two, then three literals, across the end of a row.
    const Bytes runs = FileMaker().u8({0x81, 7, 0x02, 1, 2, 3, 0x80, 9}).bytes;
    EXPECT_EQ(pixelsOf(tgaOf(11, 3, 2, 8, 0x20, runs)),
              (Pixels{grey(7), grey(7), grey(1), grey(2), grey(3), grey(9)}));
    EXPECT_EQ(pixelsOf(tgaOf(10, 2, 1, 24, 0x20, FileMaker().u8({0x81, 0, 0, 255}).bytes)),
              (Pixels{kRed, kRed}));
    EXPECT_THROW(pixelsOf(tgaOf(1, 2, 1, 8, 0, FileMaker().add(map).u8({1, 2}).bytes, 2)), FileError);
}

TEST(TiffFiles, DepthsAndKinds) {
    const auto tiff = [](unsigned bits, unsigned samples, unsigned photometric, unsigned format,
                         const Bytes& pixels) {
        return tiffOf(1, 1, bits, samples, photometric, format, pixels);
    };
    EXPECT_EQ(pixelsOf(tiff(8, 1, 1, 1, FileMaker().u8({40}).bytes)), (Pixels{grey(40)}));
    EXPECT_EQ(pixelsOf(tiff(8, 1, 0, 1, FileMaker().u8({40}).bytes)), (Pixels{grey(215)})); // white is zero
    EXPECT_EQ(pixelsOf(tiff(8, 3, 2, 1, FileMaker().u8({1, 2, 3}).bytes)), (Pixels{{1, 2, 3, 255}}));
    const Bytes deep = tiff(16, 3, 2, 1, FileMaker().u16({0x1234, 0xffff, 0}).bytes);
    EXPECT_EQ(decodeHdrImage(deep, "a.tif").pixels[0], (Colour{srgbDecode(0x1234 / 65535.0F), 1, 0}));
    const auto bits = [](float v) { return std::bit_cast<std::uint32_t>(v); };
    const Bytes real = tiff(32, 3, 2, 3, FileMaker().u32({bits(1e6F), bits(1e-6F), bits(0.5F)}).bytes);
    EXPECT_EQ(decodeHdrImage(real, "a.tif").pixels[0], (Colour{1e6F, 1e-6F, 0.5F}));
    EXPECT_EQ(pixelsOf(tiff(1, 1, 1, 1, FileMaker().u8({0x80}).bytes)), (Pixels{grey(255)}));
    std::vector<unsigned> map(768);
    map[7] = 0xffff, map[256 + 7] = 0x8000, map[512 + 7] = 0;
    EXPECT_EQ(pixelsOf(tiffOf(1, 1, 8, 1, 3, 1, FileMaker().u8({7}).bytes, map)),
              (Pixels{{255, 128, 0, 255}}));
}

TEST(RadianceFiles, OldRunsFlatRowsAndSigns) {
    const auto head = [](const std::string& rest) {
        return FileMaker().text("#?RGBE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n" + rest);
    };
    const Colour one{1, 0.5F, 0.25F}, two{2, 2, 2};
    const auto put = [](FileMaker& file, bool first) -> FileMaker& {
        return first ? file.u8({128, 64, 32, 129}) : file.u8({128, 128, 128, 130});
    };
    FileMaker flat = head("\n-Y 1 +X 2\n");
    put(put(flat, true), false);
    EXPECT_EQ(decodeHdrImage(flat.bytes, "a.hdr").pixels, (std::vector<Colour>{one, two}));

    FileMaker runs = head("\n-Y 1 +X 300\n");
    put(runs, true).u8({1, 1, 1, 42, 1, 1, 1, 1});
    put(runs, false);
    const HdrImage long300 = decodeHdrImage(runs.bytes, "a.hdr");
    EXPECT_EQ(std::count(long300.pixels.begin(), long300.pixels.end(), one), 299);
    EXPECT_EQ(long300.pixels.back(), two);

    FileMaker turned = head("EXPOSURE=2\n\n+Y 2 -X 1\n");
    put(put(turned, true), false);
    EXPECT_EQ(decodeHdrImage(turned.bytes, "a.hdr").pixels, (std::vector<Colour>{two / 2.0F, one / 2.0F}));
    for (const char* bad : {"\n-Y 1\n", "\n-Y 0 +X 1\n", "\n+X 1 -Y 1\n",
                            "FORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n", "-Y 1 +X 1\n"}) {
        EXPECT_THROW(decodeHdrImage(head(bad).u8({1, 2, 3, 4}).bytes, "a.hdr"), FileError) << bad;
    }
}

TEST(PfmFiles, GreyAndBigEndian) {
    const Bytes bytes = FileMaker().text("Pf\n1 2\n1.0\n").big32(0x3f800000).big32(0x40000000).bytes;
    EXPECT_EQ(decodeHdrImage(bytes, "a.pfm").pixels, (std::vector<Colour>{{2, 2, 2}, {1, 1, 1}}));
}

TEST(Headers, ThatLieAboutTheSizeAreRefusedAtOnce) {
    const Bytes some(64);
    const std::uint32_t huge = 60000;
    std::vector<Bytes> files{
        PngMaker(huge, huge, 8, 2).finish(some),
        PngMaker(30000, 8000, 8, 2).finish(some),
        bmpOf(60000, 60000, 24, 0, {}, 0, some),
        bmpOf(32000, 8000, 24, 0, {}, 0, some),
        bmpOf(32000, 8000, 8, 1, kPalette, 3, some),
        bmpOf(INT32_MIN, INT32_MIN, 32, 0, {}, 0, some),
        bmpOf(0x40000000, 1, 32, 0, {}, 0, some),
        tgaOf(2, 60000, 60000, 24, 0, some),
        tgaOf(10, 32000, 8000, 24, 0, some),
        tiffOf(huge, huge, 8, 3, 2, 1, some),
        FileMaker().text("P6 60000 60000 255\n").add(some).bytes,
        FileMaker().text("P6 32000 8000 255\n").add(some).bytes,
        FileMaker().text("P4 32000 8000\n").add(some).bytes,
        FileMaker().text("PF\n60000 60000\n-1\n").add(some).bytes,
        FileMaker().text("PF\n32000 8000\n-1\n").add(some).bytes,
        FileMaker().text("#?RADIANCE\n\n-Y 60000 +X 60000\n").add(some).bytes,
        FileMaker().text("#?RADIANCE\n\n-Y 8000 +X 32000\n").add(some).bytes,
        FileMaker()
            .u8({0xff, 0xd8, 0xff, 0xc0, 0, 11, 8, 0xea, 0x60, 0xea, 0x60, 1, 1, 0x11, 0})
            .add(some)
            .bytes,
    };
    Bytes exr = [] {
        if (!isWritableFormat("a.exr")) return Bytes{};
        return encodeImage(test::noiseImage(4, 4), "exr");
    }();
    const Bytes window = FileMaker().text("dataWindow").u8({0}).text("box2i").u8({0}).u32({16, 0, 0}).bytes;
    const auto at = std::search(exr.begin(), exr.end(), window.begin(), window.end());
    if (at != exr.end()) {
        const Bytes corner = FileMaker().u32({59999, 59999}).bytes;
        std::copy(corner.begin(), corner.end(), at + static_cast<std::ptrdiff_t>(window.size()));
        files.push_back(exr);
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
        EXPECT_THROW(decodeLdrImage(files[i], "a.lie"), FileError) << i;
        EXPECT_THROW(decodeHdrImage(files[i], "a.lie"), FileError) << i;
    }
}

TEST(Reading, MissingAndForeignFilesAreErrors) {
    const auto kindOf = [](const std::filesystem::path& path) {
        try {
            readLdrImage(path);
        } catch (const FileError& error) {
            return error.kind;
        }
        return FailureKind::Stopped;
    };
    EXPECT_EQ(kindOf("/nowhere/a.png"), FailureKind::NoInput);
    EXPECT_EQ(kindOf("/"), FailureKind::NoInput);
    EXPECT_EQ(kindOf("/dev/null"), FailureKind::BadData);
    EXPECT_THROW(decodeLdrImage({}, "a.png"), FileError);
    EXPECT_THROW(decodeLdrImage(Bytes(1000), "zeros.png"), FileError);
}

} // namespace
} // namespace rtcore

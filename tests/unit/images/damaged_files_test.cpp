/// Whatever the bytes, reading ends with a sound image or with a FileError.
#include "test_images.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace rtcore {
namespace {

using test::Bytes;

struct Seed {
    const char* name;
    Bytes (*make)();
};

template <int w, int h>
Bytes encoded(const char* format) {
    return isWritableFormat(std::string("a.") + format) ? encodeImage(test::noiseImage(w, h, true), format)
                                                        : Bytes{};
}

Bytes runsHdr() { return encodeImage(test::smoothImage(64, 4), "hdr"); }

Bytes paletteBmp() {
    test::FileMaker file;
    file.text("BM").u32({0, 0, 70, 40, 6, 2}).u16({1, 8}).u32({1, 0, 0, 0, 4, 0});
    file.u8({1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 10, 11, 12, 0});
    return file.u8({2, 0, 0, 3, 0, 1, 2, 0, 0, 0, 0, 2, 1, 0, 2, 1, 0, 1}).bytes;
}

Bytes runsTga() {
    test::FileMaker file;
    file.u8({3, 1, 9}).u16({0, 4}).u8({32}).u16({0, 0, 5, 4}).u8({8, 0x20}).text("abc");
    file.u8({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16});
    return file.u8({0x84, 1, 0x04, 0, 1, 2, 3, 0, 0x89, 2}).bytes;
}

Bytes paletteTiff() { return test::tiffOf(4, 4, 8, 1, 3, 1, Bytes(16), std::vector<unsigned>(768, 0x7fff)); }

Bytes realTiff() { return test::tiffOf(2, 2, 32, 3, 2, 3, Bytes(48)); }

Bytes textPpm() {
    return test::FileMaker().text("P3\n# colours\n2 2\n255\n1 2 3 4 5 6 7 8 9 10 11 12\n").bytes;
}

Bytes palettePng() {
    test::PngMaker png(8, 2, 4, 3);
    png.chunk("PLTE", Bytes(48)).chunk("tRNS", Bytes(9));
    return png.finish(Bytes(10));
}

Bytes deepPng() { return test::PngMaker(3, 3, 16, 6).finish(Bytes(75)); }

const Seed kSeeds[] = {
    {"png", [] { return encoded<13, 9>("png"); }},
    {"palettePng", palettePng},
    {"deepPng", deepPng},
    {"jpg", [] { return encoded<21, 19>("jpg"); }},
    {"bmp", [] { return encoded<7, 5>("bmp"); }},
    {"paletteBmp", paletteBmp},
    {"ppm", [] { return encoded<7, 5>("ppm"); }},
    {"textPpm", textPpm},
    {"tga", [] { return encoded<7, 5>("tga"); }},
    {"runsTga", runsTga},
    {"tif", [] { return encoded<17, 13>("tif"); }},
    {"paletteTiff", paletteTiff},
    {"realTiff", realTiff},
    {"hdr", [] { return encoded<7, 5>("hdr"); }},
    {"runsHdr", runsHdr},
    {"exr", [] { return encoded<21, 18>("exr"); }},
    {"pfm", [] { return encoded<5, 4>("pfm"); }},
    {"gif", [] { return encoded<16, 9>("gif"); }},
    {"webp", [] { return encoded<16, 9>("webp"); }},
    {"psd", [] { return encoded<16, 9>("psd"); }},
    {"dds", [] { return encoded<16, 8>("dds"); }},
};

/// Refusals, and those of them in the words of a library.
struct Refusals {
    int all = 0, quoted = 0;
};

/// True when an image came out.
bool readSafely(const Bytes& bytes, Refusals& refusals) {
    try {
        const LdrImage image = decodeLdrImage(bytes, "damaged");
        EXPECT_EQ(image.pixels.size(),
                  static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
        EXPECT_GT(image.width, 0);
        return true;
    } catch (const FileError& error) {
        const std::string said = error.what();
        EXPECT_NE(said.find("damaged"), std::string::npos);
        ++refusals.all;
        if (said.find("a library says") != std::string::npos) ++refusals.quoted;
        EXPECT_TRUE(error.kind == FailureKind::BadData || error.kind == FailureKind::TryAgain);
        return false;
    }
}

class DamagedFile : public testing::TestWithParam<Seed> {
  protected:
    void SetUp() override {
        seed_ = GetParam().make();
        if (seed_.empty()) GTEST_SKIP() << "this build has no " << GetParam().name;
    }
    Bytes seed_;
    Refusals refusals_;
};

TEST_P(DamagedFile, CutAnywhere) {
    EXPECT_TRUE(readSafely(seed_, refusals_));
    const std::size_t step = seed_.size() / 2000 + 1;
    for (std::size_t n = 0; n < seed_.size(); n += step) {
        readSafely({seed_.begin(), seed_.begin() + static_cast<std::ptrdiff_t>(n)}, refusals_);
    }
}

TEST_P(DamagedFile, ChangedAnywhere) {
    const char* wanted = std::getenv("RT_MUTATIONS");
    const long count = wanted != nullptr ? std::atol(wanted) : 1000;
    std::mt19937 random(2010);
    const auto below = [&](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    const unsigned favourites[] = {0, 1, 2, 0x7f, 0x80, 0xff};
    for (long i = 0; i < count; ++i) {
        Bytes bytes = seed_;
        for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
            // Headers are what readers trust: half of the changes go there.
            const std::size_t at =
                below(below(2) == 0 ? std::min<std::size_t>(bytes.size(), 64) : bytes.size());
            switch (below(4)) {
            case 0:
                bytes[at] ^= static_cast<std::byte>(1U << below(8));
                break;
            case 1:
                bytes[at] = static_cast<std::byte>(favourites[below(6)]);
                break;
            case 2:
                bytes[at] = static_cast<std::byte>(below(256));
                break;
            default:
                bytes[at] = bytes[below(bytes.size())];
                break;
            }
        }
        if (below(8) == 0) bytes.resize(1 + below(bytes.size()));
        readSafely(bytes, refusals_);
    }
    // Rare faults alone.
    EXPECT_LE(refusals_.quoted * 20, refusals_.all);
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedFile, testing::ValuesIn(kSeeds),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace rtcore

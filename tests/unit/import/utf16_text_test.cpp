#include "rtcore/io/import/mesh/utf16_text.h"

#include "rtcore/io/import/assimp/assimp_import.h"
#include "rtcore/io/import/inspection/foreign_formats.h"
#include "rtcore/io/import/obj/obj_import.h"
#include "rtcore/platform/error.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

namespace rtcore {
namespace {

/// With its mark; of characters below 2^16.
std::string asUtf16(const std::u16string& text, bool highFirst) {
    std::string bytes;
    for (const char16_t c : u'\uFEFF' + text) {
        const char high = static_cast<char>(c >> 8), low = static_cast<char>(c & 0xFF);
        bytes += highFirst ? high : low;
        bytes += highFirst ? low : high;
    }
    return bytes;
}

std::span<const std::byte> bytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

TEST(Utf16Text, BecomesUtf8) {
    for (const bool highFirst : {false, true}) {
        EXPECT_EQ(utf8OfUtf16(bytesOf(asUtf16(u"Stra\u00DFe \u20AC", highFirst))), "Stra\xC3\x9F"
                                                                                   "e \xE2\x82\xAC");
        EXPECT_EQ(utf8OfUtf16(bytesOf(asUtf16(u"\U0001F3E0", highFirst))), "\xF0\x9F\x8F\xA0")
            << "two halves";
    }
    EXPECT_EQ(utf8OfUtf16(bytesOf(asUtf16(u"", false))), "");
}

TEST(Utf16Text, OthersAreNone) {
    EXPECT_EQ(utf8OfUtf16(bytesOf("OFF")), std::nullopt);
    EXPECT_EQ(utf8OfUtf16(bytesOf("\xFF")), std::nullopt);
    EXPECT_EQ(utf8OfUtf16(bytesOf(asUtf16(u"a", false) + "b")), std::nullopt) << "half a character";
    EXPECT_EQ(utf8OfUtf16(bytesOf(std::string("\xFF\xFE\x3C\xD8"
                                              "a\0",
                                              6))),
              std::nullopt)
        << "half a pair";
}

class Utf16Files : public testing::Test {
  protected:
    std::filesystem::path write(const std::string& name, const std::string& bytes) {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    test::TemporaryFolder folder_;
};

TEST_F(Utf16Files, ShowWhatTheyShowInUtf8) {
    const std::u16string model = u"OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n";
    const FileImport plain =
        importWithAssimp(write("plain.off", std::string(model.begin(), model.end())), {});
    ASSERT_EQ(plain.model.triangles.size(), 2U);
    for (const bool highFirst : {false, true}) {
        const FileImport other = importWithAssimp(write("other.off", asUtf16(model, highFirst)), {});
        EXPECT_EQ(other.model.triangles, plain.model.triangles);
        EXPECT_EQ(other.model.vertices.size(), plain.model.vertices.size());
    }
}

TEST_F(Utf16Files, ObjOfItIsRefusedWithTheRemedy) {
    const std::filesystem::path path = write("a.obj", asUtf16(u"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", true));
    try {
        importObj(path, {});
        FAIL();
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("UTF-16"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("UTF-8"), std::string::npos) << error.what();
    }
}

TEST_F(Utf16Files, ScenesOfIrrlichtAreNamed) {
    const std::u16string scene = u"<?xml version=\"1.0\"?>\n<irr_scene>\n</irr_scene>\n";
    for (const std::string& bytes : {asUtf16(scene, false), std::string(scene.begin(), scene.end())}) {
        const auto sentence = unreadFormat(write("a.irr", bytes));
        ASSERT_TRUE(sentence);
        EXPECT_NE(sentence->english().find("Irrlicht"), std::string::npos) << sentence->english();
    }
    EXPECT_EQ(unreadFormat(write("a.xml", asUtf16(u"<?xml version=\"1.0\"?>\n<other/>\n", false))),
              std::nullopt);
}

} // namespace
} // namespace rtcore

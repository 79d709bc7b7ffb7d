#include "rtcore/io/recording/camera_list.h"

#include "support/temporary_folder.h"
#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

namespace {

using rtcore::parseCameraList;
using Paths = std::vector<std::filesystem::path>;

TEST(CameraList, PathsStartAtTheFolderOfTheList) {
    EXPECT_EQ(parseCameraList("a.cam\nsub/b.cam\n/c.cam\n", "film/list.txt"),
              (Paths{"film/a.cam", "film/sub/b.cam", "/c.cam"}));
    EXPECT_EQ(parseCameraList("a.cam", "list.txt"), (Paths{"a.cam"}));
}

TEST(CameraList, CommentsAndBlankLinesAreSkipped) {
    EXPECT_EQ(parseCameraList("# one\n\n  \t\n   # two\na.cam # three\nb.cam\t#four\n#", "l"),
              (Paths{"a.cam", "b.cam"}));
    // Without white space before it, '#' is part of the name.
    EXPECT_EQ(parseCameraList("take#3.cam\n./#4.cam", "l"), (Paths{"take#3.cam", "./#4.cam"}));
}

TEST(CameraList, WhiteSpaceAndLineEndsDoNotMatter) {
    EXPECT_EQ(parseCameraList("\xEF\xBB\xBF  a b.cam \t\r\n\r\nc.cam\r", "l"), (Paths{"a b.cam", "c.cam"}));
    EXPECT_EQ(parseCameraList("", "l"), Paths{});
    EXPECT_EQ(parseCameraList("\n\n", "l"), Paths{});
}

TEST(CameraList, BytesThatAreNoTextAreRefusedWithTheirPlace) {
    EXPECT_EQ(test::badData([] { parseCameraList("a.cam\n\xC3\xA4\xFF.cam\n", "l.txt"); }),
              "l.txt:2:2: this byte is no text; save the list as UTF-8");
    EXPECT_EQ(test::badData([] { parseCameraList(std::string_view("a\0b", 3), "l.txt"); }),
              "l.txt:1:2: this byte is no text; save the list as UTF-8");
    for (const char* bad :
         {"\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF8", "\xC3", "\x80"})
        EXPECT_NE(test::badData([&] { parseCameraList(bad, "l"); }), "no error");
    for (const char* good :
         {"\xC2\x80", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xF4\x8F\xBF\xBF", "\xF0\x90\x80\x80"})
        EXPECT_EQ(test::badData([&] { parseCameraList(good, "l"); }), "no error");
}

TEST(CameraList, WrittenListsReadBack) {
    const test::TemporaryFolder folder;
    const Paths cameras{folder / "a.cam", folder / "sub/b c.cam", folder / "#1.cam",
                        folder / "t\u00fcr#2.cam", "/elsewhere/d.cam"};
    rtcore::writeCameraList(folder / "list.txt", cameras);
    EXPECT_EQ(test::fileContent(folder / "list.txt"),
              "a.cam\nsub/b c.cam\n./#1.cam\nt\u00fcr#2.cam\n/elsewhere/d.cam\n");
    Paths again = rtcore::readCameraList(folder / "list.txt");
    for (auto& path : again) path = path.lexically_normal();
    EXPECT_EQ(again, cameras);
}

TEST(CameraList, PathsThatNoListHoldsAreRefused) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a #1.cam", "a.cam ", "a\nb.cam", "\xFF.cam", "a\t#.cam"}) {
        EXPECT_THROW(rtcore::writeCameraList(folder / "l", Paths{folder / name}), rtcore::FileError) << name;
        EXPECT_FALSE(std::filesystem::exists(folder / "l"));
    }
    EXPECT_THROW(rtcore::writeCameraList(folder / "l", Paths{""}), rtcore::FileError);
}

} // namespace

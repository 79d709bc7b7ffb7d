// Images have the sizes that people name.
#include "common/settings/image_size.h"

#include <gtest/gtest.h>

namespace {

using app::ImageSize;
using app::imageSizeOf;

TEST(ImageSizes, HaveNames) {
    EXPECT_EQ(imageSizeOf("4k"), (ImageSize{3840, 2160}));
    EXPECT_EQ(imageSizeOf("FullHD"), (ImageSize{1920, 1080}));
    EXPECT_EQ(imageSizeOf("1200x800"), (ImageSize{1200, 800}));
    EXPECT_EQ(imageSizeOf("1X1"), (ImageSize{1, 1}));
}

TEST(ImageSizes, OfPaperAreInDotsPerInch) {
    EXPECT_EQ(imageSizeOf("A4"), (ImageSize{3508, 2480}));
    EXPECT_EQ(imageSizeOf("a4@300"), imageSizeOf("a4"));
    EXPECT_EQ(imageSizeOf("a3-upright@150"), (ImageSize{1754, 2480}));
    EXPECT_EQ(imageSizeOf("a0@1"), (ImageSize{47, 33}));
}

TEST(ImageSizes, ThatAreNoneAreNothing) {
    for (const char* text :
         {"", "x", "a9", "4k@300", "a4@", "a4@0", "a4@2401", "a4@1.5", "-upright", "a4-upright-upright",
          "0x10", "10x", "x10", "10x10x10", "-1x5", "99999999999x1", "1e3x5", " 4k", "a4 @300"})
        EXPECT_FALSE(imageSizeOf(text)) << text;
    for (const app::NamedSize& screen : app::kScreenSizes)
        EXPECT_NE(app::imageSizeNames().find(screen.name), std::string::npos);
}

} // namespace

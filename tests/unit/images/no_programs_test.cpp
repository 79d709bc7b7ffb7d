#include "test_images.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace rtcore {
namespace {

/// Makes a folder the current one and all of PATH, as long as it lives.
class InsideFolder {
  public:
    explicit InsideFolder(const std::filesystem::path& folder) : before_(std::filesystem::current_path()) {
        if (const char* searchPath = std::getenv("PATH")) searchPath_ = searchPath;
        std::filesystem::current_path(folder);
        ::setenv("PATH", folder.c_str(), 1);
    }
    ~InsideFolder() {
        std::error_code ignored;
        std::filesystem::current_path(before_, ignored);
        ::setenv("PATH", searchPath_.c_str(), 1);
    }
    InsideFolder(const InsideFolder&) = delete;
    InsideFolder& operator=(const InsideFolder&) = delete;

  private:
    std::filesystem::path before_;
    std::string searchPath_;
};

void plantPrograms(const test::TemporaryFolder& folder) {
    for (const char* name : {"convert", "magick", "gm", "which", "identify", "medcon", "dcraw", "ffmpeg",
                             "gunzip", "gzip", "gs", "dwebp", "cwebp", "curl", "wget", "xdg-open"}) {
        const std::string marker = (folder / "a program ran").string();
        test::saveBytes(folder / name,
                        test::FileMaker().text("#!/bin/sh\necho $0 >> '" + marker + "'\n").bytes);
        std::filesystem::permissions(folder / name, std::filesystem::perms::owner_all);
    }
}

void readQuietly(const std::string& path) {
    EXPECT_THROW(readLdrImage(path), FileError) << path;
    EXPECT_THROW(readHdrImage(path), FileError) << path;
}

/// Trap of CImg (and of ImageMagick's delegates): what they do not know they hand to ./convert or ./magick.
TEST(Programs, AreNeverStarted) {
    const test::TemporaryFolder folder;
    plantPrograms(folder);
    const InsideFolder inside(folder.path());
    const test::Bytes nonsense =
        test::FileMaker().text("this is no image at all, whatever its name says").bytes;
    for (const char* extension :
         {"png", "jpg", "bmp", "ppm", "tga", "tif", "hdr", "exr", "webp", "gif", "dcm",
          "cr2", "mp4", "avi", "svg", "mvg", "msl", "ps",  "pdf", "gz",   "xyz", "heic"}) {
        const std::string path = std::string("nonsense.") + extension;
        test::saveBytes(path, nonsense);
        readQuietly(path);
    }
    // Files that look like images at first, and a name that means a program to ImageMagick.
    const auto start = [](const char* text) {
        return test::FileMaker().text(text).add(test::Bytes(60)).bytes;
    };
    test::saveBytes("start.gif", start("GIF89a"));
    test::saveBytes("start.webp",
                    test::FileMaker().text("RIFF").u32({60}).text("WEBPVP8 ").add(test::Bytes(60)).bytes);
    test::saveBytes("start.psd", start("8BPS"));
    test::saveBytes("start.bmp", start("BM"));
    test::saveBytes("start.jpg", test::FileMaker().u8({0xff, 0xd8, 0xff}).add(test::Bytes(60)).bytes);
    test::saveBytes("mpeg:start.gif", start("GIF89a"));
    for (const char* path :
         {"start.gif", "start.webp", "start.psd", "start.bmp", "start.jpg", "mpeg:start.gif", "missing.png",
          "missing.cr2", "http://localhost/missing.png", "|convert"}) {
        readQuietly(path);
    }
    const LdrImage image = test::noiseImage(8, 8);
    for (const char* path : {"a.png", "a.jpg", "a.bmp", "a.ppm", "a.tga", "a.tif", "a.hdr", "a.pfm"}) {
        writeImage(path, image);
        EXPECT_EQ(readLdrImage(path).width, 8) << path;
    }
    for (const char* path : {"a.webp", "a.gif"}) {
        if (isWritableFormat(path)) writeImage(path, image);
    }
    for (const char* path : {"a.mp4", "a.pdf", "a.gz", "a.show", "|convert.png.x", "a.avi"}) {
        EXPECT_THROW(writeImage(path, image), FileError) << path;
    }
    EXPECT_FALSE(std::filesystem::exists("a program ran"));
}

} // namespace
} // namespace rtcore

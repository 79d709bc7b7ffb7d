// Broken photometric files: each is refused with its line, and damaged ones are read or refused, no more.
#include "rtcore/io/photometry/photometric_file.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "support/damaged_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace {

namespace fs = std::filesystem;

std::string refusalOf(const fs::path& file) {
    try {
        (void)rtcore::readPhotometricFile(file);
    } catch (const rtcore::FileError& error) {
        EXPECT_EQ(error.kind, rtcore::FailureKind::BadData);
        return error.what();
    }
    return "";
}

TEST(BrokenPhotometricFiles, AreRefusedWithTheirLine) {
    int count = 0;
    for (const fs::directory_entry& file : fs::directory_iterator(RT_PHOTOMETRIC_FILES "/broken")) {
        const std::string refusal = refusalOf(file.path());
        const std::string name = file.path().string() + ':';
        ASSERT_TRUE(refusal.starts_with(name)) << file.path() << " '" << refusal << "'";
        EXPECT_TRUE(std::isdigit(static_cast<unsigned char>(refusal[name.size()])) != 0 ||
                    file.path().filename() == "empty.ies")
            << refusal;
        ++count;
    }
    EXPECT_GE(count, 30);
}

TEST(BrokenPhotometricFiles, AreToldWhatToDo) {
    const auto refused = [](const std::string& name) {
        const std::string refusal = refusalOf(fs::path(RT_PHOTOMETRIC_FILES) / "broken" / name);
        return refusal.substr(std::min(refusal.find(name) + name.size(), refusal.size()));
    };
    EXPECT_EQ(refused("negative.ies"), ":11: an intensity is -4020, but is from 0 to 1e+09");
    EXPECT_EQ(refused("type_b.ies"), ":6: it is of the photometric type B; convert it to type C, in which "
                                     "luminaires for rooms and streets are measured");
    EXPECT_EQ(refused("cut_off.ies"),
              ":11: the file ends where an intensity should follow; it was cut off, so get it again");
    EXPECT_EQ(refused("descending.ies"),
              ":8: the angle 1 follows 2; angles ascend, by a thousandth of a degree or more");
    EXPECT_EQ(refused("odd_planes.ies"),
              ":22: its horizontal angles end at 80 degrees; they span 0, 90, 180 or 360");
    EXPECT_EQ(refused("dark.ies"),
              ":11: all intensities are zero; choose the file of a luminaire that gives off light");
    EXPECT_EQ(refused("words.ldt"),
              ":29: the lumens of the light sources should stand here, a number, and not 'two thousand'");
}

constexpr std::array<std::string_view, 12> kTokens{"nan", "-1",  "1e999", "0",  "360",    "\n",
                                                   "181", "1,5", " ",     "\r", "TILT=N", "99999999999"};

TEST(MutatedPhotometricFiles, AreReadOrRefused) {
    std::vector<std::string> examples;
    for (const char* name : {"narrow.ies", "batwing.ies", "asymmetric.ldt"})
        examples.push_back(rtcore::readTextFile(fs::path(RT_PHOTOMETRIC_FILES) / name));
    test::DamagedText damaged(examples, kTokens, 61);
    int readable = 0;
    for (long i = 0; i < test::damagedTexts(); ++i) {
        const std::string text = damaged.next();
        try {
            const rtcore::PhotometricWeb web = rtcore::parsePhotometricFile(text, "x").web;
            ASSERT_EQ(web.candela.size(), web.gammas.size() * web.planes.size());
            ASSERT_GE(web.gammas.size(), 2U);
            ASSERT_NEAR(web.planes.back() - web.planes.front(), 360, 1e-2);
            ASSERT_TRUE(std::ranges::is_sorted(web.gammas) && std::ranges::is_sorted(web.planes));
            for (const double each : web.candela) ASSERT_TRUE(each >= 0 && each <= 1e9);
            ASSERT_TRUE(rtcore::lumensOf(web) > 0);
            ++readable;
        } catch (const rtcore::FileError& error) {
            EXPECT_EQ(error.kind, rtcore::FailureKind::BadData);
            EXPECT_LT(std::string(error.what()).size(), 1000U);
        }
    }
    EXPECT_GT(readable, 0);
    EXPECT_LT(readable, test::damagedTexts());
}

} // namespace

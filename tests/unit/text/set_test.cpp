#include "rtcore/io/text/set.h"

#include "support/temporary_folder.h"
#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

namespace {

using rtcore::parseSettingsFile;
using rtcore::SettingAssignment;
using rtcore::SettingsFile;

std::string problem(const std::string& text) {
    return test::badData([&] { parseSettingsFile(text, "x.set"); });
}

TEST(Set, BothSpellingsOfNestedNamesAreRead) {
    const SettingsFile file =
        parseSettingsFile("version = 1\n[live]\nantialiasing = 1\n[still]\nantialiasing = 4\n"
                          "exposure.mode = \"fixed\"\nexposure.value = 2\n"
                          "[still.ambientOcclusion]\non = true\n",
                          "x.set");
    EXPECT_EQ(file.live, (std::vector<SettingAssignment>{{"antialiasing", 1}}));
    const std::vector<SettingAssignment> still{{"antialiasing", 4},
                                               {"exposure.mode", std::string("fixed")},
                                               {"exposure.value", 2.0F},
                                               {"ambientOcclusion.on", true}};
    EXPECT_EQ(file.still, still);
}

TEST(Set, AnEmptyOneChangesNothing) {
    EXPECT_EQ(parseSettingsFile("version = 1\n", "x.set"), SettingsFile{});
    EXPECT_EQ(parseSettingsFile("version = 1\n[live]\n[still.exposure]\n", "x.set"), SettingsFile{});
}

TEST(Set, ErrorsNameTheirPlace) {
    EXPECT_EQ(problem("version = 1\n[live]\nwidht = 3"),
              "x.set:3:1: unknown setting 'widht'; did you mean 'width'?");
    EXPECT_EQ(problem("version = 1\n[live]\nwidth = 0"),
              "x.set:3:9: width is 0, but takes a whole number, 1 to 32768 pixels");
    EXPECT_EQ(problem("version = 1\n[live]\nwidth = true"),
              "x.set:3:9: width is true, but takes a whole number, 1 to 32768 pixels");
    EXPECT_EQ(problem("version = 1\n[live]\nexposure.vaule = 1"),
              "x.set:3:10: unknown setting 'exposure.vaule'; did you mean 'exposure.value'?");
    EXPECT_EQ(problem("version = 1\n[live.ambientOcclusion]\nsamples = 5000"),
              "x.set:3:11: ambientOcclusion.samples is 5000, but takes a whole number, 1 to 4096 rays");
    EXPECT_EQ(problem("version = 1\n[live]\nexposure.mode = \"manual\""),
              "x.set:3:17: exposure.mode is 'manual', but takes automatic or fixed or incident");
    EXPECT_EQ(problem("version = 1\n[live]\nwidth = [3]"),
              "x.set:3:9: width is an array, but takes one value");
    EXPECT_EQ(problem("version = 1\n[live.width]\n"), "x.set:2:1: width is a table, but takes one value");
    EXPECT_EQ(problem("version = 1\n[lvie]\n"), "x.set:2:2: unknown key 'lvie'; did you mean 'live'?");
    EXPECT_EQ(problem("version = 1\nlive = 3"),
              "x.set:2:8: live is a whole number, but takes a table, [live]");
    EXPECT_EQ(problem("version = 1\n[[live]]"), "x.set:2:1: live is an array, but takes a table, [live]");
    EXPECT_EQ(problem("version = 1\nwidth = 3").substr(0, 11), "x.set:2:1: ");
    EXPECT_EQ(problem("[live]").substr(0, 23), "x.set:1:1: the version ");
}

TEST(Set, ASettingByBothOfItsNamesIsRefused) {
    EXPECT_EQ(
        problem("version = 1\n[live]\nlampSamples = 4\nareaLights.samples = 8"),
        "x.set:3:1: lampSamples is the former name of areaLights.samples, which stands here, too; remove "
        "lampSamples");
    EXPECT_EQ(problem("version = 1\n[still.bloom]\nkernel = \"airy\"\n[still]\nbloomKernel = \"airy\""),
              "x.set:5:1: bloomKernel is the former name of bloom.kernel, which stands here, too; remove "
              "bloomKernel");
    for (const char* both : {"bloom = 10\nbloom.radius = 10", "bloom = 10\n[live.bloom]\nradius = 10",
                             "denoise.passes = 1\ndenoise = 1"})
        EXPECT_EQ(problem("version = 1\n[live]\n" + std::string(both)).substr(0, 8), "x.set:4:") << both;
    // Different settings, or in different tables.
    const SettingsFile file = parseSettingsFile(
        "version = 1\n[live]\nbloom = 10\nbloomShare = 0.5\n[still]\nbloomShare = 0.5\nbloom.radius = 10",
        "x");
    const std::vector<SettingAssignment> live{{"bloom.radius", 10}, {"bloom.share", 0.5F}};
    const std::vector<SettingAssignment> still{{"bloom.share", 0.5F}, {"bloom.radius", 10}};
    EXPECT_EQ(file.live, live);
    EXPECT_EQ(file.still, still);
}

TEST(Set, PathsAreForStills) {
    EXPECT_EQ(
        problem("version = 1\n[live]\nintegrator = \"path\""),
        "x.set:3:14: integrator is path, which is for stills, not for the live view; put it into [still], "
        "or use 'Renderer --setting integrator=path'");
    const SettingsFile file = parseSettingsFile(
        "version = 1\n[live]\nintegrator = \"whitted\"\npath.samples = 4\n"
        "[still]\nintegrator = \"path\"\n[still.path]\nclampIndirect = \"off\"\nemitters = \"on\"\n",
        "x.set");
    const std::vector<SettingAssignment> live{{"integrator", std::string("whitted")}, {"path.samples", 4}};
    const std::vector<SettingAssignment> still{{"integrator", std::string("path")},
                                               {"path.clampIndirect", 0.0F},
                                               {"path.emitters", std::string("on")}};
    EXPECT_EQ(file.live, live);
    EXPECT_EQ(file.still, still);
}

TEST(Set, IsWrittenWithTheNamesOfToday) {
    EXPECT_EQ(rtcore::formatSettingsFile({{{"bloom", 3}}, {}}), "version = 1\n\n[live]\nbloom.radius = 3\n");
}

TEST(Set, NumbersBeyondAllRangesAreRefused) {
    for (const char* number :
         {"nan", "inf", "-inf", "1e300", "9223372036854775807", "-9223372036854775808"}) {
        for (const char* name : {"width", "ambientOcclusion.samples", "exposure.key"})
            EXPECT_EQ(problem("version = 1\n[live]\n" + std::string(name) + " = " + number).substr(0, 8),
                      "x.set:3:")
                << name << number;
    }
}

std::vector<SettingAssignment> randomAssignments(test::Random& random) {
    rtcore::RenderSettings s;
    s.width = 1 + static_cast<int>(random.below(32768));
    s.shadows = random.flag();
    s.minContribution = random.fraction();
    s.ambientOcclusion.distance = random.positive();
    s.exposure.value = random.positive();
    s.exposure.mode = random.flag() ? rtcore::ExposureMode::Fixed : rtcore::ExposureMode::Automatic;
    return rtcore::settingAssignments(s, random.flag());
}

TEST(Set, RandomSettingsSurviveTheRoundTripBitForBit) {
    test::Random random(21);
    for (int i = 0; i < 300; ++i) {
        const SettingsFile file{randomAssignments(random), randomAssignments(random)};
        EXPECT_EQ(parseSettingsFile(rtcore::formatSettingsFile(file), "x.set"), file);
    }
}

TEST(Set, FilesAreWrittenAndRead) {
    const test::TemporaryFolder folder;
    test::Random random(22);
    const SettingsFile file{randomAssignments(random), randomAssignments(random)};
    rtcore::writeSettingsFile(folder / "a.set", file);
    EXPECT_EQ(rtcore::readSettingsFile(folder / "a.set"), file);
}

TEST(Set, WhatCouldNotBeReadIsNotWritten) {
    const test::TemporaryFolder folder;
    for (const SettingAssignment& wrong :
         std::vector<SettingAssignment>{{"width", 0}, {"colour", 1}, {"a = 1\nb", 1}}) {
        EXPECT_THROW(rtcore::writeSettingsFile(folder / "a.set", {{wrong}, {}}), rtcore::FileError);
        EXPECT_FALSE(std::filesystem::exists(folder / "a.set"));
    }
}

} // namespace

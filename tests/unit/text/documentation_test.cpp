// docs/formats.md shows what the readers take, and all of it.
#include "rtcore/io/bsp/bsp_layout.h"
#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/io/text/set.h"
#include "rtcore/io/text/toml_guard.h"
#include "support/document_section.h"
#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

namespace {

const std::string& document() {
    static const std::string text = test::fileContent(RT_FORMATS_DOCUMENT);
    return text;
}

std::string code(std::string_view text) { return "`" + std::string(text) + "`"; }

TEST(FormatsDocument, SceneExamplesAreScenes) {
    const auto examples = test::documentedExamples("toml scn");
    ASSERT_GE(examples.size(), 4U);
    for (const std::string& example : examples)
        EXPECT_NO_THROW(rtcore::parseSceneFile(example, "x.scn")) << example;
}

TEST(FormatsDocument, ScenesShowEachKindOfLight) {
    const std::string& text = document();
    for (const rtcore::LightTraits& traits : rtcore::kLightTraits)
        EXPECT_NE(text.find("\nkind = \"" + std::string(traits.name) + '"'), std::string::npos)
            << traits.name;
}

TEST(FormatsDocument, CameraExamplesAreCameras) {
    const auto examples = test::documentedExamples("toml cam");
    ASSERT_GE(examples.size(), 2U);
    for (const std::string& example : examples)
        EXPECT_NO_THROW(rtcore::parseCameraFile(example, "x.cam")) << example;
}

TEST(FormatsDocument, SettingsExamplesAreSettings) {
    const auto examples = test::documentedExamples("toml set");
    ASSERT_GE(examples.size(), 1U);
    for (const std::string& example : examples)
        EXPECT_NO_THROW(rtcore::parseSettingsFile(example, "x.set")) << example;
}

TEST(FormatsDocument, ListExamplesAreLists) {
    const auto examples = test::documentedExamples("text list");
    ASSERT_GE(examples.size(), 1U);
    for (const std::string& example : examples)
        EXPECT_FALSE(rtcore::parseCameraList(example, "l").empty()) << example;
}

TEST(FormatsDocument, RecordingExamplesAreWholeRecordings) {
    const auto examples = test::documentedExamples("text recording");
    ASSERT_GE(examples.size(), 1U);
    for (const std::string& example : examples) {
        const rtcore::GrowingCameraList list = rtcore::parseGrowingCameraList(example, "l");
        EXPECT_TRUE(list.ended && !list.cameras.empty()) << example;
        EXPECT_TRUE(example.starts_with(rtcore::kRecordingMark)) << example;
    }
}

TEST(FormatsDocument, TheFormerNamesAreThoseThatAreRead) {
    std::string table = test::tableRow({"Name", "Former name"}) + "|---|---|\n";
    for (const rtcore::FormerName& each : rtcore::formerSettingNames())
        table += test::tableRow({code(each.name), code(each.former)});
    test::expectSection(RT_FORMATS_DOCUMENT, "former names", table);
}

std::string_view typeName(rtcore::SettingType type) {
    switch (type) {
    case rtcore::SettingType::Boolean:
        return "boolean";
    case rtcore::SettingType::Integer:
        return "integer";
    case rtcore::SettingType::Number:
        return "number";
    case rtcore::SettingType::Choice:
        break;
    }
    return "word";
}

TEST(FormatsDocument, TheTableOfSettingsIsTheOneOfTheProgram) {
    std::string table = test::tableRow({"Name", "Default", "Type", "Takes", "Unit", "Meaning"}) +
                        "|---|---|---|---|---|---|\n";
    for (const rtcore::Setting& setting : rtcore::settingsTable())
        table += test::tableRow({code(setting.name), code(rtcore::settingText(setting.defaultValue)),
                                 typeName(setting.type), rtcore::settingRange(setting), setting.unit,
                                 setting.help});
    test::expectSection(RT_FORMATS_DOCUMENT, "settings", table);
}

/// The keys that a reader knows: those that its message about an unknown key lists.
std::vector<std::string> knownKeys(const std::string& text) {
    const std::string message = test::badData([&] { rtcore::parseSceneFile(text, "f"); });
    std::vector<std::string> keys;
    const std::string mark = "known: ";
    std::size_t at = message.find(mark);
    if (at == std::string::npos) return keys;
    for (at += mark.size() - 1; at != std::string::npos; at = message.find(' ', at + 1))
        keys.push_back(message.substr(at + 1, message.find(' ', at + 1) - at - 1));
    return keys;
}

TEST(FormatsDocument, NamesEveryKeyOfAScene) {
    for (const char* section :
         {"", "[camera]\n", "[[light]]\n", "[[material]]\n", "[[environment]]\n", "[fog]\n", "[walk]\n"}) {
        std::string text = "version = 1\nmodel = 'a'\n";
        text.append(section).append("qqqqqqqqqqqqqqqq = 1\n");
        const auto keys = knownKeys(text);
        EXPECT_GE(keys.size(), 5U) << section;
        for (const std::string& key : keys) {
            const bool shown = document().find(key + " = ") != std::string::npos ||
                               document().find("[" + key + "]") != std::string::npos;
            EXPECT_TRUE(shown) << section << key;
        }
    }
}

TEST(FormatsDocument, NamesTheBoundsOfTheParser) {
    const auto says = [](const std::string& words) {
        EXPECT_NE(document().find(words), std::string::npos) << words;
    };
    says("of at most " + std::to_string(rtcore::kMaxTomlBytes >> 20U) + " MB");
    says("at most " + std::to_string(rtcore::kMaxTomlDepth) + " brackets within brackets,\n  " +
         std::to_string(rtcore::kMaxTomlDepth) + " parts in a dotted key, a million values");
    EXPECT_EQ(rtcore::kMaxTomlValues, 1'000'000U);
}

TEST(FormatsDocument, DescribesTheBspThatIsWritten) {
    const auto says = [](const std::string& words) {
        EXPECT_NE(document().find(words), std::string::npos) << words;
    };
    const std::string version = std::to_string(rtcore::kBspVersion);
    says("\nVersion " + version + ". All numbers");
    says("\n| 12 | 4 | version: " + version + " |\n");
    says("\n| 16 | 4 | size of this head: " + std::to_string(sizeof(rtcore::BspHead)) + " |\n");
    says("number of sections, at most " + std::to_string(rtcore::kMaxBspSections));
    says("Entry of the table, " + std::to_string(sizeof(rtcore::BspSectionEntry)) + " bytes");
    for (std::uint32_t older = 2; older < rtcore::kBspVersion; ++older)
        says("\n**Version " + std::to_string(older) + "** is still read.");
    for (const rtcore::BspSectionKind& kind : rtcore::kBspSectionKinds)
        says("\n| " + std::string(kind.name) + " | " + std::to_string(kind.elementSize) + " | ");
}

TEST(FormatsDocument, NamesTheModesOfBlocks) {
    for (std::size_t i = 0; i < rtcore::kBlockModes.size(); ++i) {
        const rtcore::BlockMode& mode = rtcore::kBlockModes[i];
        std::string row = "| " + std::to_string(i) + " |";
        for (const std::uint8_t bits : mode.bits) row += " " + std::to_string(bits);
        row += mode.lumaChroma ? " | YCoCg |" : " | RGB |";
        EXPECT_NE(document().find(row), std::string::npos) << row;
    }
}

TEST(FormatsDocument, NamesTheRangesOfMaterials) {
    const auto taken = [](const std::string& key, const std::string& value) {
        const std::string text = "version = 2\nmodel = 'a'\n[[material]]\nname = 'b'\n" + key + " = " + value;
        return test::badData([&] { rtcore::parseSceneFile(text, "f"); }) == "no error";
    };
    struct Range {
        const char *key, *lowest, *highest, *below, *above, *words;
    };
    for (const Range& range :
         {Range{"opacity", "0.0", "1.0", "-0.01", "1.01",
                "`opacity`,\n`reflectivity`, `coat`, `coatRoughness` 0 to 1"},
          Range{"reflectivity", "0.0", "1.0", "-0.01", "1.01",
                "`reflectivity`, `coat`, `coatRoughness` 0 to 1"},
          Range{"shininess", "0.0", "100000.0", "-0.01", "100001.0", "`shininess` 0 to 100000"},
          Range{"indexOfRefraction", "1.0", "5.0", "0.99", "5.01", "`indexOfRefraction` 1 to 5"},
          Range{"priority", "0.0", "100.0", "-1.0", "101.0", "`priority` whole and 0 to 100"}}) {
        EXPECT_TRUE(taken(range.key, range.lowest) && taken(range.key, range.highest)) << range.key;
        EXPECT_FALSE(taken(range.key, range.below) || taken(range.key, range.above)) << range.key;
        EXPECT_NE(document().find(range.words), std::string::npos) << range.words;
    }
}

TEST(FormatsDocument, NamesTheDefaultsOfCamerasAndLights) {
    const auto says = [](const std::string& words) {
        EXPECT_NE(document().find(words), std::string::npos) << words;
    };
    const rtcore::CameraFile camera =
        rtcore::parseCameraFile("version = 1\neye = [0, 0, 0]\nforward = [0, 0, -1]\n", "x.cam");
    EXPECT_EQ(camera.camera.horizontalFov, 60);
    EXPECT_EQ(camera.camera.up, (rtcore::Vec3{0, 1, 0}));
    says("above 0, below 180; default 60");
    says("`up` is +y and `fov` 60 when absent");
    const rtcore::SceneFile scene = rtcore::parseSceneFile(
        "version = 1\nmodel = 'a'\n[[light]]\nkind = 'point'\nposition = [0, 0, 0]\n", "x.scn");
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.lights[0].light.intensity, (rtcore::Colour{1, 1, 1}));
    says("# W/sr; default 1 1 1");
    EXPECT_EQ(scene.background, rtcore::Colour{});
    EXPECT_EQ(scene.ambient, rtcore::Colour{});
    says("where there is no environment; default black");
    says("unshadowed; default black");
}

} // namespace

#include "common/cli/help_text.h"

#include <gtest/gtest.h>

#include <sstream>

namespace {

app::ProgramSpec sampleSpec() {
    app::ProgramSpec spec;
    spec.name = "Sample";
    spec.purpose = "Does a thing.";
    spec.positionals = {{"SCENE", "what to read"}};
    spec.groups = {
        {"Output",
         {{.name = "output",
           .letter = 'o',
           .value = app::ValueKind::Text,
           .argument = "FILE",
           .help =
               "write the image there, with a help text that is long enough to need a second line or more"},
          {.name = "ambient-occlusion", .thesis = {"-ao"}, .help = "switch it on"}}}};
    return spec;
}

TEST(HelpText, HasTheLayoutThatHelp2manReads) {
    const std::string text = app::helpText(app::withStandardOptions(sampleSpec()));
    EXPECT_EQ(text.rfind("Usage: Sample SCENE [OPTION]...\nDoes a thing.\n", 0), 0U);
    EXPECT_NE(text.find("\nOutput:\n  -o, --output=FILE"), std::string::npos);
    EXPECT_NE(text.find("  -ao, --ambient-occlusion"), std::string::npos);
    EXPECT_NE(text.find("  -h, -help, --help"), std::string::npos);
    EXPECT_NE(text.find("      --version"), std::string::npos);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 79U) << line;
}

TEST(HelpText, LeavesTheLetterHToWhoTakesIt) {
    app::ProgramSpec spec = sampleSpec();
    spec.groups[0].options.push_back({.name = "height", .letter = 'h', .help = "pixels"});
    spec = app::withStandardOptions(std::move(spec));
    EXPECT_EQ(app::spellings(*spec.find("help")), "-help, --help");
    EXPECT_EQ(app::spellings(*spec.find("height")), "-h, --height");
}

TEST(HelpText, BriefTextNamesTheHelp) {
    const std::string text = app::briefText(sampleSpec());
    EXPECT_NE(text.find("Usage: Sample SCENE"), std::string::npos);
    EXPECT_NE(text.find("Try 'Sample --help'"), std::string::npos);
}

TEST(HelpText, MarksPositionalsThatRepeat) {
    app::ProgramSpec spec = sampleSpec();
    spec.positionals.back().repeats = true;
    EXPECT_EQ(app::briefText(spec).rfind("Usage: Sample SCENE... [OPTION]...\n", 0), 0U);
}

TEST(HelpText, MarksPositionalsThatMayBeMissing) {
    app::ProgramSpec spec = sampleSpec();
    spec.positionals.back().optional = true;
    EXPECT_EQ(app::helpText(spec).rfind("Usage: Sample [SCENE] [OPTION]...\n", 0), 0U);
}

TEST(HelpText, VersionListsTheOptionalParts) {
    const std::string text = app::versionText(sampleSpec());
    EXPECT_EQ(text.rfind("Sample (rtsuite) ", 0), 0U);
    for (const char* part : {"OpenMP: ", "ImageMagick: ", "OpenEXR: "}) {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
}

} // namespace

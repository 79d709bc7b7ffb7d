#include "common/cli/command_line.h"

#include <gtest/gtest.h>

namespace {

using app::Arguments;
using app::UsageError;
using app::ValueKind;

app::ProgramSpec sampleSpec() {
    app::ProgramSpec spec;
    spec.name = "Sample";
    spec.positionals = {{"SCENE", "what to read"}};
    spec.groups = {
        {"All",
         {{.name = "width", .letter = 'w', .value = ValueKind::Integer, .argument = "N", .minimum = 1},
          {.name = "height", .letter = 'h', .value = ValueKind::Integer, .argument = "N"},
          {.name = "antialiasing", .letter = 'a', .value = ValueKind::Integer, .argument = "N"},
          {.name = "ambient-occlusion", .thesis = {"-ao"}},
          {.name = "ao-samples", .thesis = {"-aon"}, .value = ValueKind::Integer, .argument = "N"},
          {.name = "key", .value = ValueKind::Number, .argument = "X", .minimum = 0, .maximum = 1},
          {.name = "style", .value = ValueKind::Choice, .argument = "S", .choices = {"bar", "none"}},
          {.name = "output",
           .letter = 'o',
           .formerly = {"write", "store"},
           .value = ValueKind::Text,
           .argument = "FILE"},
          {.name = "list-all", .answers = true}}}};
    return app::withStandardOptions(std::move(spec));
}

Arguments parse(const std::vector<std::string>& words) { return app::parseCommandLine(sampleSpec(), words); }

std::string errorOf(const std::vector<std::string>& words) {
    try {
        parse(words);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "no error";
}

TEST(CommandLine, TakesEverySpelling) {
    for (const auto& words : std::vector<std::vector<std::string>>{{"s", "-w", "640"},
                                                                   {"s", "-w640"},
                                                                   {"s", "--width", "640"},
                                                                   {"s", "--width=640"},
                                                                   {"-w", "640", "s"}}) {
        const Arguments arguments = parse(words);
        EXPECT_EQ(arguments.integer("width"), 640);
        EXPECT_EQ(arguments.positionals(), std::vector<std::string>{"s"});
    }
}

TEST(CommandLine, TakesNamesThatOptionsHadBefore) {
    EXPECT_EQ(parse({"s", "--write", "a"}).text("output"), "a");
    EXPECT_EQ(parse({"s", "--store=a=b"}).text("output"), "a=b");
    EXPECT_EQ(parse({"s", "--output=--write"}).text("output"), "--write");
    EXPECT_EQ(errorOf({"s", "--writ=a"}), "unknown option '--writ=a'")
        << "what is proposed has the present name";
}

TEST(CommandLine, TellsThesisSpellingsFromShortOnes) {
    const Arguments arguments = parse({"s", "-a", "3", "-ao", "-aon", "16", "-h", "480"});
    EXPECT_EQ(arguments.integer("antialiasing"), 3);
    EXPECT_TRUE(arguments.has("ambient-occlusion"));
    EXPECT_EQ(arguments.integer("ao-samples"), 16);
    EXPECT_EQ(arguments.integer("height"), 480);
    EXPECT_FALSE(arguments.has("help"));
    EXPECT_TRUE(parse({"-help"}).has("help"));
}

TEST(CommandLine, KeepsTheOrderAndTheLastValueWins) {
    const Arguments arguments = parse({"s", "-w", "1", "--output=a", "-w", "2", "-o", "b"});
    EXPECT_EQ(arguments.integer("width"), 2);
    EXPECT_EQ(arguments.all("output"), (std::vector<std::string>{"a", "b"}));
    ASSERT_EQ(arguments.options().size(), 4U);
    EXPECT_EQ(arguments.options()[2].name, "width");
    EXPECT_EQ(arguments.options()[2].value, "2");
}

TEST(CommandLine, NothingIsAnOptionBehindTwoDashes) {
    EXPECT_EQ(parse({"-w", "1", "--", "-ao"}).positionals(), std::vector<std::string>{"-ao"});
    EXPECT_EQ(parse({"-o", "-", "s"}).text("output"), "-");
}

TEST(CommandLine, NeverGuessesNames) {
    EXPECT_EQ(errorOf({"s", "--widt", "3"}), "unknown option '--widt'; did you mean '--width'?");
    EXPECT_NE(errorOf({"s", "-x"}).find("unknown option '-x'"), std::string::npos);
}

TEST(CommandLine, RefusesWrongValues) {
    EXPECT_EQ(errorOf({"s", "-w", "0"}), "option '--width': '0' is not a whole number of at least 1");
    EXPECT_NE(errorOf({"s", "-w", "12x"}).find("whole number"), std::string::npos);
    EXPECT_NE(errorOf({"s", "-w", "1.5"}).find("whole number"), std::string::npos);
    EXPECT_NE(errorOf({"s", "-w", "99999999999999999999"}).find("whole number"), std::string::npos);
    EXPECT_EQ(errorOf({"s", "--key=nan"}), "option '--key': 'nan' is not a number from 0 to 1");
    EXPECT_EQ(errorOf({"s", "--key=1.01"}), "option '--key': '1.01' is not a number from 0 to 1");
    EXPECT_EQ(errorOf({"s", "--style=x"}), "option '--style': 'x' is not one of bar, none");
}

TEST(CommandLine, RefusesMissingAndNeedlessValues) {
    EXPECT_EQ(errorOf({"s", "--width"}), "option '--width' needs a value");
    EXPECT_EQ(errorOf({"s", "-o", "--width=3"}), "option '--output' needs a value");
    EXPECT_EQ(errorOf({"s", "-o", "-w", "3"}), "option '--output' needs a value");
    EXPECT_EQ(errorOf({"s", "-o", "-ao"}), "option '--output' needs a value");
    EXPECT_EQ(parse({"s", "--output=--width"}).text("output"), "--width");
    EXPECT_EQ(errorOf({"s", "--output="}), "option '--output' needs a value");
    EXPECT_EQ(errorOf({"s", "-o", ""}), "option '--output' needs a value");
    EXPECT_EQ(errorOf({"s", "--ambient-occlusion=1"}), "option '--ambient-occlusion' takes no value");
}

TEST(CommandLine, CountsPositionals) {
    EXPECT_EQ(errorOf({"-w", "1"}), "missing SCENE");
    EXPECT_EQ(errorOf({"s", "t"}), "unexpected argument 't'");
    EXPECT_TRUE(parse({"--list-all"}).has("list-all"));
    EXPECT_TRUE(parse({"--version"}).has("version"));
}

TEST(CommandLine, TheLastPositionalMayRepeat) {
    app::ProgramSpec spec = sampleSpec();
    spec.positionals.back().repeats = true;
    const std::vector<std::string> words{"s", "-w", "1", "t", "u"};
    EXPECT_EQ(app::parseCommandLine(spec, words).positionals(), (std::vector<std::string>{"s", "t", "u"}));
    EXPECT_THROW(app::parseCommandLine(spec, std::vector<std::string>{"-w", "1"}), UsageError);
}

TEST(CommandLine, TheLastPositionalMayBeOptional) {
    app::ProgramSpec spec = sampleSpec();
    spec.positionals.push_back({.name = "PICTURE", .help = "what to write", .optional = true});
    EXPECT_EQ(spec.requiredPositionals(), 1U);
    const std::vector<std::string> one{"a.scn"}, three{"a", "b", "c"};
    EXPECT_EQ(app::parseCommandLine(spec, one).positionals(), one);
    EXPECT_THROW(app::parseCommandLine(spec, {}), UsageError);
    EXPECT_THROW(app::parseCommandLine(spec, three), UsageError);
}

TEST(CommandLine, NumbersAreWholeWordsInEveryLocale) {
    EXPECT_EQ(app::parseNumber("0.5"), 0.5);
    EXPECT_EQ(app::parseNumber("-2e3"), -2000);
    for (const char* text : {"", " 1", "1 ", "0,5", "inf", "1e999", "0x10"}) {
        EXPECT_EQ(app::parseNumber(text), std::nullopt) << text;
        EXPECT_EQ(app::parseInteger(text), std::nullopt) << text;
    }
}

} // namespace

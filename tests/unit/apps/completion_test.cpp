/// The programs' answers to Tab, and the tables that they are made of.
#include "common/cli/command_names.h"
#include "common/cli/completion.h"
#include "cui/cui_operands.h"
#include "cui/cui_spec.h"

#include "rtcore/motion/action.h"
#include "rtcore/motion/key_codes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using Words = std::vector<std::string>;

app::ProgramSpec sample() {
    const auto keys = [](std::span<const std::string> words) {
        return Words{"up", "down", words.front() + "?"};
    };
    return {.name = "Sample",
            .purpose = "",
            .positionals = {{.name = "COMMAND", .help = "", .repeats = true}},
            .groups = {{"Commands",
                        {},
                        {{"load scene FILE|-", ""},
                         {"load set FILE", ""},
                         {"key KEY on|off [MORE...]", ""},
                         {"run FILE [-- OPTION...]", ""}}},
                       {"Options",
                        {{.name = "mode",
                          .letter = 'm',
                          .value = app::ValueKind::Choice,
                          .argument = "WORD",
                          .choices = {"fast", "fine"}},
                         {.name = "input",
                          .thesis = {"-in"},
                          .value = app::ValueKind::Text,
                          .argument = "FILE",
                          .files = {"scn"}},
                         {.name = "quiet"}}}},
            .examples = {},
            .operands = {{.command = "load set", .name = "FILE", .files = {"set"}},
                         {.command = "", .name = "KEY", .suggest = keys},
                         {.command = "run", .name = "OPTION", .program = "Other"}}};
}

app::Completion complete(const Words& words) { return app::completeWords(sample(), words); }

TEST(CompleteWords, OptionsInEachSpelling) {
    Words all = complete({"-"}).words;
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all,
              (Words{"--help", "--input=", "--mode=", "--quiet", "--version", "-h", "-help", "-in", "-m"}));
    EXPECT_EQ(complete({"--q"}).words, Words{"--quiet"});
    EXPECT_EQ(complete({"--"}).words, (Words{"--mode=", "--input=", "--quiet", "--help", "--version"}));
    EXPECT_TRUE(complete({}).words.empty());
}

TEST(CompleteWords, ValuesOfOptions) {
    for (const Words& words : {Words{"--mode", "f"}, {"-m", "f"}, {"load", "-m", ""}})
        EXPECT_EQ(complete(words).words, (Words{"fast", "fine"}));
    EXPECT_EQ(complete({"--mode=fi"}).words, Words{"--mode=fine"});
    const app::Completion file = complete({"-in", "a"});
    EXPECT_TRUE(file.files);
    EXPECT_EQ(file.prefix, 0U);
    EXPECT_EQ(file.extensions, Words{"scn"});
    EXPECT_EQ(complete({"--input=a"}).prefix, 8U);
    EXPECT_EQ(app::completionText(complete({"--input=a"})), "files 8 scn\n");
    EXPECT_EQ(complete({"--quiet", "l"}).words, Words{"load"}) << "a switch takes no value";
}

TEST(CompleteWords, CommandsAndTheirPlaces) {
    EXPECT_EQ(complete({""}).words, (Words{"key", "load", "run"}));
    EXPECT_EQ(complete({"load", "s"}).words, (Words{"scene", "set"}));
    EXPECT_TRUE(complete({"load", "scene", ""}).files);
    EXPECT_EQ(complete({"load", "scene", "-"}).words.front(), "-") << "and the options";
    EXPECT_EQ(complete({"--quiet", "load", "scene", "--", "-"}).words, Words{"-"}) << "no options behind --";
    EXPECT_EQ(complete({"load", "set", ""}).extensions, Words{"set"});
    EXPECT_EQ(complete({"key", ""}).words, (Words{"down", "key?", "up"}));
    EXPECT_EQ(complete({"key", "up", ""}).words, (Words{"off", "on"}));
    EXPECT_FALSE(complete({"key", "up", "on", ""}).files);
    EXPECT_TRUE(complete({"nonsense", ""}).words.empty());
}

TEST(CompleteWords, BehindTwoDashesAnotherProgramIsAsked) {
    EXPECT_EQ(complete({"run", "a", ""}).words, Words{"--"});
    EXPECT_EQ(complete({"run", "a", ""}).program, "");
    for (const Words& words : {Words{"run", "a", "--", ""}, {"run", "a", "--", "-x", "y", "-"}}) {
        EXPECT_EQ(complete(words).program, "Other");
        EXPECT_EQ(complete(words).first, 3U);
    }
}

TEST(CommandLabel, IsTakenApart) {
    const app::CommandLabel label = app::parseCommandLabel("export video start|stop FILE [WIDTH MORE...]");
    EXPECT_EQ(label.command(), "export video");
    EXPECT_EQ(label.places, (std::vector<Words>{{"start", "stop"}, {"FILE"}, {"WIDTH"}, {"MORE"}}));
    EXPECT_TRUE(label.repeats);
    EXPECT_EQ(app::parseCommandLabel("camera look-at EX").names, (Words{"camera", "look-at"}));
}

TEST(CuiOperands, AreWhatTheServerKnows) {
    for (const std::string& key : cui::suggestKeys({})) EXPECT_TRUE(rtcore::keyNamed(key)) << key;
    for (const std::string& action : cui::suggestActions({}))
        EXPECT_TRUE(rtcore::actionNamed(action)) << action;
    EXPECT_EQ(cui::suggestActions({}).size(), rtcore::kActions);
}

} // namespace

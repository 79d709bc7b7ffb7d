/// The manual pages: complete, and what groff takes without a warning.
#include "process/packaging/program_specs.h"
#include "process/sample_scene.h"

#include "common/cli/help_text.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace {

class ManPage : public testing::TestWithParam<const app::ProgramSpec*> {
  protected:
    static std::string page() {
        const test::ProgramResult result =
            test::runProgram(test::programPath(GetParam()->name), {"--man-page"});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        return result.output;
    }
    // Also a line at its left margin: blanks differ.
    static std::string roff(std::string text) {
        for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos; at += 2)
            text.insert(at, "\\");
        return text;
    }
};

TEST_P(ManPage, HasEachOptionCommandAndExitCode) {
    const std::string text = page();
    for (const char* section : {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "EXAMPLES",
                                "FILES", "ENVIRONMENT", "SEE ALSO"}) {
        EXPECT_NE(text.find(".SH " + std::string(section) + "\n"), std::string::npos) << section;
    }
    const app::ProgramSpec spec = app::withStandardOptions(*GetParam());
    for (const app::OptionGroup& group : spec.groups) {
        for (const app::Option& option : group.options) {
            EXPECT_NE(text.find("\\fB" + roff("--" + option.name) + "\\fR"), std::string::npos)
                << option.name;
            EXPECT_NE(text.find("\n" + roff(option.help.substr(0, option.help.find('\''))), 0),
                      std::string::npos)
                << option.help;
        }
        for (const app::HelpWord& word : group.words)
            EXPECT_NE(text.find(roff(word.help.substr(0, word.help.find('\'')))), std::string::npos)
                << word.label;
    }
    for (const app::HelpWord& code : app::exitCodeNotes())
        EXPECT_NE(text.find("\\fB" + code.label + "\\fR\n"), std::string::npos) << code.label;
}

TEST_P(ManPage, IsFormattedWithoutAWarning) {
    const std::filesystem::path groff = "/usr/bin/groff";
    if (!std::filesystem::exists(groff)) GTEST_SKIP() << "there is no " << groff;
    const test::TemporaryFolder folder;
    test::writeText(folder / "page.1", page());
    const test::ProgramResult warnings =
        test::runProgram(groff, {"-man", "-ww", "-z", "-Tutf8", (folder / "page.1").string()});
    EXPECT_EQ(warnings.exitCode, 0);
    EXPECT_EQ(warnings.error, "");
    const test::ProgramResult text =
        test::runProgram(groff, {"-man", "-P-cbou", "-Tascii", "-rLL=78n", (folder / "page.1").string()});
    EXPECT_EQ(text.exitCode, 0);
    EXPECT_NE(text.output.find(GetParam()->name + "(1)"), std::string::npos);
    EXPECT_NE(text.output.find("--help"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, ManPage, testing::ValuesIn(test::packagedPrograms()),
                         [](const auto& program) { return program.param->name; });

} // namespace

/// Help, version and the errors of the command line, for each program.
#include "process/sample_scene.h"

#include "bspbuilder/builder_options.h"
#include "cui/cui_spec.h"
#include "renderer/renderer_options.h"
#include "rtserver/server_options.h"

#ifdef RT_HAS_BRIDGE
#include "bridge/bridge_options.h"
#endif

#include <gtest/gtest.h>

#include <regex>

namespace {

class Program : public testing::TestWithParam<const app::ProgramSpec*> {
  protected:
    std::string name() const { return GetParam()->name; }
    test::ProgramResult run(const std::vector<std::string>& arguments) const {
        return test::runProgram(test::programPath(name()), arguments);
    }
    std::string hint() const { return "Try '" + name() + " --help'.\n"; }
};

TEST_P(Program, WithoutArgumentsExplainsItselfBriefly) {
    if (GetParam()->positionals.empty()) GTEST_SKIP() << "it begins at once";
    const test::ProgramResult result = run({});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(result.error.rfind("Usage: " + name(), 0), 0U) << result.error;
    EXPECT_LT(std::count(result.error.begin(), result.error.end(), '\n'), 12);
}

TEST_P(Program, HelpGoesToStandardOutput) {
    for (const char* spelling : {"--help", "-help"}) {
        const test::ProgramResult result = run({spelling});
        EXPECT_EQ(result.exitCode, 0);
        EXPECT_EQ(result.error, "");
        for (const app::OptionGroup& group : GetParam()->groups) {
            for (const app::Option& option : group.options) {
                EXPECT_NE(result.output.find("--" + option.name), std::string::npos) << option.name;
            }
        }
    }
}

TEST_P(Program, VersionNamesTheParts) {
    const test::ProgramResult result = run({"--version"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_TRUE(
        std::regex_search(result.output, std::regex("^" + name() + R"( \(rtsuite\) \d+\.\d+\.\d+\n)")))
        << result.output;
    EXPECT_NE(result.output.find("OpenMP"), std::string::npos);
}

TEST_P(Program, AFullDiskIsAnError) {
    test::ProgramSettings settings;
    settings.outputFile = "/dev/full";
    const test::ProgramResult result = test::runProgram(test::programPath(name()), {"--help"}, settings);
    EXPECT_EQ(result.exitCode, 73);
    EXPECT_NE(result.error.find(name() + ": standard output: "), std::string::npos) << result.error;
}

TEST_P(Program, UsageErrorsNameTheHelp) {
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"--nonsense"}, {"--progress=loud", "a", "b"}, {"--threads=-1", "a"}, {"a", "b", "c", "d"}}) {
        const test::ProgramResult result = run(arguments);
        EXPECT_EQ(result.exitCode, 2) << testing::PrintToString(arguments);
        EXPECT_EQ(result.output, "");
        EXPECT_EQ(result.error.rfind(name() + ": ", 0), 0U) << result.error;
        EXPECT_NE(result.error.find(hint()), std::string::npos) << result.error;
    }
}

TEST_P(Program, TheManualHasEachOption) {
    std::string manual;
    for (const char* page : {"manual.md", "bridge.md"})
        manual += test::readBytes(std::filesystem::path(RT_SOURCE_FOLDER) / "docs" / page);
    ASSERT_FALSE(manual.empty());
    const std::string help = run({"--help"}).output;
    const std::regex option("--[a-z][a-z-]*");
    for (std::sregex_iterator found(help.begin(), help.end(), option), end; found != end; ++found) {
        EXPECT_TRUE(std::regex_search(manual, std::regex(found->str() + "(?![a-z-])"))) << found->str();
    }
}

#ifdef RT_HAS_BRIDGE
INSTANTIATE_TEST_SUITE_P(Bridge, Program, testing::Values(&bridge::bridgeSpec()),
                         [](const auto& program) { return program.param->name; });
#endif

INSTANTIATE_TEST_SUITE_P(All, Program,
                         testing::Values(&renderer::rendererSpec(), &bspbuilder::builderSpec(),
                                         &rtserver::serverSpec(), &cui::cuiSpec()),
                         [](const auto& program) { return program.param->name; });

TEST(RendererHelp, MinusHIsTheHeight) {
    const test::ProgramResult result = test::runProgram(test::programPath("Renderer"), {"-h"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.error.find("'--height' needs a value"), std::string::npos) << result.error;
}

TEST(RendererHelp, ListsTheSettings) {
    const test::ProgramResult result = test::runProgram(test::programPath("Renderer"), {"--settings"});
    EXPECT_EQ(result.exitCode, 0);
    for (const char* name : {"width = 640", "ambientOcclusion.samples = ", "exposure.mode = automatic"}) {
        EXPECT_NE(result.output.find(name), std::string::npos) << result.output;
    }
}

} // namespace

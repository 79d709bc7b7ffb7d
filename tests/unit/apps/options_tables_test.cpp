/// The tables of options of all programs: no spelling stands for two things.
#include "bench/rtbench/bench_options.h"
#include "bspbuilder/builder_options.h"
#include "cui/cui_spec.h"
#include "gui/gui_spec.h"
#include "renderer/renderer_options.h"
#include "renderer/unused_settings.h"
#include "rtserver/server_options.h"

#ifdef RT_HAS_BRIDGE
#include "bridge/bridge_options.h"
#endif

#include <gtest/gtest.h>

#include <set>

namespace {

class OptionsTable : public testing::TestWithParam<const app::ProgramSpec*> {};

TEST_P(OptionsTable, EachSpellingStandsOnce) {
    const app::ProgramSpec spec = app::withStandardOptions(*GetParam());
    std::set<std::string> seen;
    const auto claim = [&](const std::string& spelling) {
        EXPECT_TRUE(seen.insert(spelling).second) << spelling << " stands twice";
    };
    for (const app::OptionGroup& group : spec.groups) {
        for (const app::Option& option : group.options) {
            claim("--" + option.name);
            if (option.letter != 0) claim(std::string("-") + option.letter);
            for (const std::string& spelling : option.thesis) claim(spelling);
            for (const std::string& name : option.formerly) claim("--" + name);
        }
    }
}

TEST_P(OptionsTable, EachOptionSaysWhatItIs) {
    for (const app::OptionGroup& group : GetParam()->groups) {
        for (const app::Option& option : group.options) {
            EXPECT_FALSE(option.help.empty()) << option.name;
            EXPECT_NE(option.help.back(), '.') << option.name;
            EXPECT_EQ(option.argument.empty(), option.value == app::ValueKind::None) << option.name;
            EXPECT_EQ(option.choices.empty(), option.value != app::ValueKind::Choice) << option.name;
            for (const std::string& spelling : option.thesis) EXPECT_EQ(spelling.front(), '-') << spelling;
        }
    }
}

#ifdef RT_HAS_BRIDGE
INSTANTIATE_TEST_SUITE_P(Bridge, OptionsTable, testing::Values(&bridge::bridgeSpec()),
                         [](const auto& program) { return program.param->name; });
#endif

INSTANTIATE_TEST_SUITE_P(Programs, OptionsTable,
                         testing::Values(&renderer::rendererSpec(), &bspbuilder::builderSpec(),
                                         &rtbench::benchSpec(), &rtserver::serverSpec(), &cui::cuiSpec(),
                                         &gui::guiSpec()),
                         [](const auto& program) { return program.param->name; });

app::Arguments parse(const app::ProgramSpec& spec, const std::vector<std::string>& words) {
    return app::parseCommandLine(app::withStandardOptions(spec), words);
}

TEST(RendererOptions, TakesTheThesisCommandLine) {
    const renderer::RendererOptions options = renderer::readRendererOptions(parse(
        renderer::rendererSpec(), {"a.scn", "-o", "a.png", "-a", "3", "-b", "2", "-w", "320", "-h", "240",
                                   "-nao", "-aon", "16", "-aok", "0.5", "-dbg", "d.obj", "--progress=none"}));
    EXPECT_EQ(options.scene, "a.scn");
    EXPECT_EQ(options.outputs, std::vector<std::filesystem::path>{"a.png"});
    EXPECT_TRUE(options.debugScene);
    rtcore::RenderSettings settings;
    rtcore::applySettings(settings, options.settings);
    EXPECT_EQ(settings.antialiasing, 3);
    EXPECT_EQ(settings.bloom.radius, 2);
    EXPECT_EQ(settings.width, 320);
    EXPECT_EQ(settings.height, 240);
    EXPECT_TRUE(settings.ambientOcclusion.on);
    EXPECT_EQ(settings.ambientOcclusion.samples, 16);
    EXPECT_EQ(settings.ambientOcclusion.distance, 0.5F);
}

TEST(RendererOptions, TakesFormerNamesOfSettings) {
    const renderer::RendererOptions options = renderer::readRendererOptions(
        parse(renderer::rendererSpec(), {"a.scn", "--setting", "denoise=2", "--setting", "bloomKernel=airy",
                                         "--setting", "lampSamples=9"}));
    const std::vector<rtcore::SettingAssignment> expected{
        {"denoise.passes", 2}, {"bloom.kernel", std::string("airy")}, {"areaLights.samples", 9}};
    EXPECT_EQ(options.settings, expected);
}

TEST(Options, AreTakenByTheNamesOfEarlierVersions) {
    EXPECT_TRUE(
        renderer::readRendererOptions(parse(renderer::rendererSpec(), {"a.scn", "-o", "a.exr", "--layers"}))
            .aovs);
    EXPECT_EQ(parse(rtserver::serverSpec(), {"a.scn", "--built-model=a.bsp"}).text("cached-model"), "a.bsp");
}

TEST(RendererOptions, TheLastOneWinsAcrossSpellings) {
    const renderer::RendererOptions options = renderer::readRendererOptions(
        parse(renderer::rendererSpec(), {"a.scn", "-ao", "-nao", "-w", "10", "--setting", "width=20"}));
    rtcore::RenderSettings settings;
    rtcore::applySettings(settings, options.settings);
    EXPECT_FALSE(settings.ambientOcclusion.on);
    EXPECT_EQ(settings.width, 20);
}

TEST(RendererOptions, RendersByPaths) {
    const renderer::RendererOptions options = renderer::readRendererOptions(
        parse(renderer::rendererSpec(), {"a.scn", "--integrator=path", "--samples=64"}));
    rtcore::RenderSettings settings;
    rtcore::applySettings(settings, options.settings);
    EXPECT_EQ(settings.integrator, rtcore::Integrator::Path);
    EXPECT_EQ(settings.path.samples, 64);
}

TEST(RendererOptions, WarnsOfSettingsThatAreNotUsed) {
    const std::vector<rtcore::SettingAssignment> file{{"adaptive", 0.1F}},
        line{{"antialiasing", 3}, {"path.bounces", 4}};
    rtcore::RenderSettings settings;
    EXPECT_EQ(renderer::unusedSettingsWarning(settings, file, line).english(),
              "integrator whitted does not use path.bounces");
    settings.integrator = rtcore::Integrator::Path;
    EXPECT_EQ(renderer::unusedSettingsWarning(settings, file, line).english(),
              "integrator path does not use antialiasing, adaptive");
    EXPECT_TRUE(renderer::unusedSettingsWarning(settings, {}, {}).empty());
}

TEST(ServerOptions, RefuseSettingsForStills) {
    const auto words = parse(rtserver::serverSpec(), {"a.scn", "--setting=integrator=path"});
    EXPECT_THROW(rtserver::readOptions(words), app::UsageError);
}

TEST(RendererOptions, RefusesWhatMakesNoSense) {
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{"a.scn", "-w", "0"},
                                               {"a.scn", "-a", "x"},
                                               {"a.scn", "--samples", "0"},
                                               {"a.scn", "--setting", "width"},
                                               {"a.scn", "--setting", "widht=3"},
                                               {"a.scn", "--setting", "shadows=maybe"},
                                               {"a.scn", "--list", "l", "--camera", "c"},
                                               {"a.scn", "--frames", "1-2"},
                                               {"a.scn", "--format", "ppm"},
                                               {"a.scn", "-o", "a.nonsense"}}) {
        EXPECT_THROW(renderer::readRendererOptions(parse(renderer::rendererSpec(), words)), app::UsageError)
            << testing::PrintToString(words);
    }
}

TEST(BuilderOptions, TakesTheThesisCommandLine) {
    const bspbuilder::BuilderOptions options = bspbuilder::readBuilderOptions(
        parse(bspbuilder::builderSpec(), {"a.obj", "a.bsp", "-f", "-m", "7", "-v", "-vv", "-hist", "20"}));
    EXPECT_EQ(options.input, "a.obj");
    EXPECT_EQ(options.output, "a.bsp");
    EXPECT_EQ(options.build.method, rtcore::BuildMethod::Fast);
    EXPECT_EQ(options.build.fastQuality, 7);
    EXPECT_EQ(options.verbosity, bspbuilder::Verbosity::VeryVerbose);
    EXPECT_EQ(options.histogramBands, 20);
}

TEST(BuilderOptions, HashTellsTreesApartButNotThreads) {
    bspbuilder::BuilderOptions exact, threaded, fast, faster;
    threaded.build.threads = 3;
    fast.build.method = faster.build.method = rtcore::BuildMethod::Fast;
    faster.build.fastQuality = 1;
    EXPECT_EQ(bspbuilder::buildOptionsHash(exact), bspbuilder::buildOptionsHash(threaded));
    EXPECT_NE(bspbuilder::buildOptionsHash(exact), bspbuilder::buildOptionsHash(fast));
    EXPECT_NE(bspbuilder::buildOptionsHash(fast), bspbuilder::buildOptionsHash(faster));
    EXPECT_NE(bspbuilder::buildOptionsHash(exact), 0U);
}

} // namespace

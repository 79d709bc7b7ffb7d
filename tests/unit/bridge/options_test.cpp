// The command line of RTBridge, as far as it needs no server.
#include "bridge/bridge_options.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

bridge::BridgeOptions optionsOf(std::vector<std::string> words) {
    words.push_back("--instance=hall");
    return bridge::readBridgeOptions(app::parseCommandLine(bridge::bridgeSpec(), words));
}

std::vector<std::string> lockedBy(const std::string& list) {
    return optionsOf({"--lock=" + list}).limits.locked;
}

TEST(LockOption, NamesSettingsEachOnce) {
    EXPECT_EQ(lockedBy("maxDepth,bloom.radius,,maxDepth"),
              (std::vector<std::string>{"maxDepth", "bloom.radius"}));
    EXPECT_EQ(lockedBy("edits"), std::vector<std::string>{"edits"});
    EXPECT_TRUE(optionsOf({}).limits.locked.empty());
}

TEST(LockOption, NamesAllSettingsOfAGroup) {
    const std::vector<std::string> locked = lockedBy("ambientOcclusion.*,maxDepth,ambientOcclusion.samples");
    std::size_t expected = 1;
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        const bool inGroup = setting.name.starts_with("ambientOcclusion.");
        expected += inGroup ? 1 : 0;
        EXPECT_EQ(std::ranges::count(locked, setting.name), inGroup || setting.name == "maxDepth" ? 1 : 0)
            << setting.name;
    }
    EXPECT_EQ(locked.size(), expected);
    EXPECT_GT(lockedBy("path.*").size(), 3U);
}

TEST(LockOption, RefusesWhatIsNoSetting) {
    for (const char* wrong : {"nothing", "nothing.*", ".*", "*", "max*", "bloom.", "bloom.*x"})
        EXPECT_THROW(lockedBy(wrong), app::UsageError) << wrong;
}

TEST(QualityOption, IsAutomaticOrANumber) {
    EXPECT_FALSE(optionsOf({}).stream.quality);
    EXPECT_FALSE(optionsOf({"--quality=auto"}).stream.quality);
    EXPECT_EQ(optionsOf({"--quality=50"}).stream.quality, 50);
    EXPECT_EQ(optionsOf({"--quality=95"}).stream.quality, 95);
    for (const char* wrong : {"49", "96", "", "best", "75.5", "-75"})
        EXPECT_THROW(optionsOf({std::string("--quality=") + wrong}), app::UsageError) << wrong;
}

TEST(QualityOption, IsThatOfThePreferredRung) {
    for (const int quality : {50, 75, 95}) {
        const bridge::StreamOptions stream{.quality = quality};
        const bridge::RungTable rungs = stream.rungs();
        ASSERT_TRUE(stream.fixedRung());
        const bridge::Rung& fixed = rungs[static_cast<std::size_t>(*stream.fixedRung())];
        EXPECT_EQ(fixed.quality, quality);
        EXPECT_EQ(fixed.divide, 1);
        for (std::size_t i = 1; i < rungs.size(); ++i) {
            EXPECT_GE(rungs[i].divide, rungs[i - 1].divide);
            if (rungs[i].divide > 1) continue;
            EXPECT_LE(rungs[i].quality, rungs[i - 1].quality) << "finest first";
        }
    }
    EXPECT_FALSE(bridge::StreamOptions().fixedRung());
}

TEST(WatchOption, IsOffUnlessAskedFor) {
    EXPECT_TRUE(optionsOf({}).byPaths);
    EXPECT_FALSE(optionsOf({"--rest=live"}).byPaths);
    EXPECT_FALSE(optionsOf({}).watch);
    EXPECT_TRUE(optionsOf({"--watch"}).watch);
}

TEST(VisitorNotesOption, IsOffUnlessAskedFor) {
    EXPECT_FALSE(optionsOf({}).limits.visitorNotes);
    EXPECT_TRUE(optionsOf({"--visitor-notes"}).limits.visitorNotes);
}

} // namespace

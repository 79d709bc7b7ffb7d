// The list of effects, and that all who apply effects walk it.
#include "rtcore/post/effects.h"

#include "rtcore/post/background.h"
#include "rtcore/post/bloom.h"
#include "rtcore/post/denoise.h"
#include "rtcore/post/develop.h"
#include "rtcore/post/net_denoise.h"
#include "support/every_effect.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace rtcore {
namespace {

RenderSettings everything() { return test::everyEffect(64, 48); }

/// The same by paths, where a net stands in place of the filter.
RenderSettings everythingByNet() {
    RenderSettings settings = everything();
    settings.integrator = Integrator::Path;
    settings.denoise.net = DenoiseNet::Small;
    return settings;
}

/// Two shades, so that there is something to spread and to expose by itself.
Frame twoShades() {
    Frame frame;
    frame.radiance = HdrImage(64, 48);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) frame.radiance.at(x, y) = kWhite * (x < 32 ? 0.1F : 5.0F);
    }
    frame.covered.assign(frame.radiance.pixels.size(), 255);
    return frame;
}

// The light of a lens is spread when its noise is gone, and an eye adapts to what the lens lets through.
TEST(Effects, StandInTheirOrder) {
    std::vector<std::string_view> names;
    for (const EffectRow* row : effects()) names.push_back(row->name);
    EXPECT_EQ(names, (std::vector<std::string_view>{"denoise by a net", "denoise", "background", "bloom",
                                                    "local exposure"}));
    EXPECT_TRUE(std::ranges::is_sorted(effects(), {}, &EffectRow::stage));
}

TEST(Effects, AreWantedByTheirSettings) {
    const RenderSettings all = everything(), byNet = everythingByNet();
    for (const EffectRow* row : effects()) {
        EXPECT_FALSE(row->wanted(RenderSettings{})) << row->name;
        const bool ofPaths = row == &kNetDenoiseEffect || row == &kBackgroundEffect;
        EXPECT_EQ(row->wanted(all), !ofPaths) << row->name;
        EXPECT_EQ(row->wanted(byNet), row != &kDenoiseEffect) << row->name;
    }
    RenderSettings nothingSpread = all;
    nothingSpread.bloom.share = 0;
    EXPECT_FALSE(kBloomEffect.wanted(nothingSpread));
}

TEST(Effects, TakeTheMemoryOfThoseThatAreWanted) {
    EXPECT_EQ(effectBytesPerPixel({}), 0U);
    std::size_t sum = 0;
    for (const EffectRow* row : effects()) sum += row->bytesPerPixel;
    EXPECT_EQ(effectBytesPerPixel(everything()), Aovs::bytesPerPixel() + sum -
                                                     kNetDenoiseEffect.bytesPerPixel -
                                                     kBackgroundEffect.bytesPerPixel);
    RenderSettings byNet = everythingByNet();
    byNet.denoise.mix = false;
    const std::size_t ofNet = Guides::bytesPerPixel() + sum - kDenoiseEffect.bytesPerPixel;
    EXPECT_EQ(effectBytesPerPixel(byNet), ofNet);
    byNet.denoise.mix = true;
    byNet.path.samples = kEstimatedSamples;
    EXPECT_EQ(effectBytesPerPixel(byNet), ofNet + 2 * sizeof(Colour) + 28 + sizeof(float))
        << "halves, their sums, errors";
    RenderSettings bloom;
    bloom.bloom.radius = 3;
    EXPECT_EQ(effectBytesPerPixel(bloom), sizeof(Colour)) << "an image of its own";
}

TEST(Effects, NeedAovsOrGuidesWhereOneOfThemReadsThem) {
    RenderSettings settings = everything();
    EXPECT_TRUE(effectsNeedAovs(settings));
    EXPECT_FALSE(effectsNeedGuides(settings));
    EXPECT_FALSE(effectsNeedAovs(everythingByNet()));
    EXPECT_TRUE(effectsNeedGuides(everythingByNet()));
    settings.denoise.passes = 0;
    EXPECT_FALSE(effectsNeedAovs(settings));
}

TEST(Effects, ThatAreNotWantedChangeNothing) {
    const Frame frame = twoShades();
    const RenderSettings none;
    EffectChain chain;
    EXPECT_EQ(&chain.apply(frame, {none}), &frame.radiance);
    chain.beginRows(EffectStage::Radiance, frame.radiance, 1, {none});
    EXPECT_FALSE(chain.changesRows());
}

// Once they are not wanted any more, what they knew of an image before does not count.
TEST(Effects, OfRowsAreThoseOfTheLastBegin) {
    const Frame frame = twoShades();
    const RenderSettings all = everything(), none;
    EffectChain chain;
    chain.beginRows(EffectStage::Radiance, frame.radiance, 1, {all});
    EXPECT_TRUE(chain.changesRows());
    chain.beginRows(EffectStage::Radiance, frame.radiance, 1, {none});
    EXPECT_FALSE(chain.changesRows());
}

TEST(Effects, OfDisplaysAloneLeaveTheLightWhereItWas) {
    const Frame frame = twoShades();
    RenderSettings bloom = everything();
    bloom.exposure.local = 0;
    EffectChain chain;
    chain.beginRows(EffectStage::Display, frame.radiance, 1, {bloom});
    EXPECT_FALSE(chain.changesRows()) << "bloom is in the image already";
    EXPECT_NE(&chain.apply(frame, {bloom}), &frame.radiance);
    RenderSettings local = everything();
    local.bloom.radius = 0;
    EXPECT_EQ(&chain.apply(frame, {local}), &frame.radiance);
    chain.beginRows(EffectStage::Display, frame.radiance, 1, {local});
    EXPECT_TRUE(chain.changesRows());
}

TEST(Effects, AreLeftWhenStopped) {
    const Frame frame = twoShades();
    const RenderSettings all = everything();
    const std::atomic<bool> stop{true};
    EXPECT_EQ(&EffectChain().apply(frame, {.settings = all, .stop = &stop}), &frame.radiance);
}

} // namespace
} // namespace rtcore

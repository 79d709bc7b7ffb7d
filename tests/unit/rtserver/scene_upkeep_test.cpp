#include "rtserver/frames/scene_upkeep.h"

#include "shown_room.h"

#include "rtcore/io/bsp/bsp_file.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace rtserver {
namespace {

using namespace std::chrono_literals;
using rtcore::Change;
using rtcore::Changes;

class SceneUpkeepTest : public test::ShownRoom {
  protected:
    SceneUpkeepTest() {
        const rtcore::LoadedScene room = test::makeRoom();
        rtcore::writeBsp(folder / "room.bsp", room.scene.model, &room.tree, {});
    }
    std::optional<SceneUpkeep::Loaded> finishLoad() {
        for (int i = 0; i < 10000; ++i) {
            if (auto loaded = upkeep.takeLoaded()) return loaded;
            std::this_thread::sleep_for(1ms);
        }
        return std::nullopt;
    }
    /// Goes on at that pace until nothing is under way.
    void advance(const SceneUpkeep::Pace& pace) {
        upkeep.advance(pace);
        for (int i = 0; i < 10000 && upkeep.works(); ++i) {
            std::this_thread::sleep_for(1ms);
            upkeep.advance(pace);
        }
    }
    void makeMaps() {
        advance(
            {.current = true, .complete = true, .idle = true, .seconds = 1, .coarsest = 0, .wanted = 0.01});
    }

    test::TemporaryFolder folder;
    SceneUpkeep upkeep{options, document, messages};
};

TEST_F(SceneUpkeepTest, ShowsAnotherSceneWhenItIsLoaded) {
    EXPECT_FALSE(upkeep.loads());
    EXPECT_FALSE(upkeep.takeLoaded());
    EXPECT_EQ(upkeep.progress(), 1);
    messages.tell("of the last scene");
    upkeep.load(folder / "room.bsp", std::nullopt);
    EXPECT_TRUE(upkeep.loads() && upkeep.works());
    EXPECT_THROW(upkeep.load(folder / "room.bsp", std::nullopt), std::runtime_error);
    const auto loaded = finishLoad();
    ASSERT_TRUE(loaded);
    EXPECT_FALSE(loaded->failure);
    EXPECT_EQ(document.title(), "room.bsp");
    EXPECT_EQ(changes(), Changes::all());
    EXPECT_EQ(messages.since(0), "");
    EXPECT_FALSE(upkeep.loads());
}

TEST_F(SceneUpkeepTest, FillLightsAreNamedOnceIndirectLightIsSwitchedOn) {
    rtcore::Scene lit = *document.scene();
    ASSERT_FALSE(lit.lights.empty());
    lit.lights[0].name = "fill by the door";
    document.publish(lit);
    upkeep.advance({});
    EXPECT_EQ(messages.since(0), "");
    document.assign({{"indirect.mode", "live"}});
    upkeep.advance({});
    const std::string told = messages.since(0);
    EXPECT_NE(told.find(" offer "), std::string::npos) << told;
    EXPECT_NE(told.find("'fill by the door'"), std::string::npos) << told;
    EXPECT_NE(told.find("light 1 off"), std::string::npos) << told;
    document.assign({{"exposure.key", 0.3F}});
    upkeep.advance({});
    EXPECT_EQ(messages.since(0), told) << "once";
}

TEST_F(SceneUpkeepTest, ASceneThatCannotBeLoadedLeavesTheLast) {
    const auto last = document.scene();
    upkeep.load(folder / "none.bsp", std::nullopt);
    const auto loaded = finishLoad();
    ASSERT_TRUE(loaded && loaded->failure);
    EXPECT_EQ(loaded->failure->code, 66);
    EXPECT_NE(messages.since(0).find("none.bsp"), std::string::npos);
    EXPECT_EQ(document.scene(), last);
}

TEST_F(SceneUpkeepTest, TheFirstSceneMustLoad) {
    Document fresh(
        options, [](const rtcore::RenderSettings&) {}, messages);
    SceneUpkeep first(options, fresh, messages);
    first.load(folder / "none.bsp", std::nullopt);
    const auto takeAll = [&] {
        for (int i = 0; i < 10000 && !first.takeLoaded(); ++i) std::this_thread::sleep_for(1ms);
    };
    EXPECT_THROW(takeAll(), rtcore::FileError);
}

TEST_F(SceneUpkeepTest, AFastTreeIsFollowedByTheExactOne) {
    rtcore::LoadedScene room = test::makeRoom();
    room.fastTree = true;
    document.show(test::worldOf(std::move(room)));
    changes();
    const auto tracer = document.world().tracer;
    upkeep.advance({});
    EXPECT_FALSE(upkeep.works()) << "the first frame comes first";
    advance({.current = true, .complete = true, .idle = false, .seconds = 0, .coarsest = 0});
    EXPECT_NE(document.world().tracer, tracer);
    EXPECT_FALSE(document.world().loaded.fastTree);
    EXPECT_EQ(changes(), Changes{}) << "the frames are the same";
}

rtcore::HiddenParts boxHidden() { return std::make_shared<const std::vector<std::uint8_t>>(1, 1); }

TEST_F(SceneUpkeepTest, ATreeOfWhatIsVisibleFollowsThePrunedOne) {
    hideParts(document, boxHidden());
    changes();
    EXPECT_TRUE(document.visible().pruned());
    const auto pruned = document.tracer();
    upkeep.advance({});
    EXPECT_FALSE(upkeep.works()) << "a first frame comes first";
    test::FakeHost host;
    test::draw(host.maker, state);
    const auto before = host.maker.image().pixels;
    advance({.current = true, .complete = false, .idle = false, .seconds = 0, .coarsest = 0});
    EXPECT_FALSE(document.visible().pruned());
    EXPECT_NE(document.tracer(), pruned);
    EXPECT_NE(document.tracer(), document.world().tracer);
    EXPECT_EQ(document.tracer()->bounds(), document.world().tracer->bounds());
    const auto* const byTree = dynamic_cast<const rtcore::KdRayTracer*>(document.tracer().get());
    ASSERT_NE(byTree, nullptr);
    EXPECT_LT(byTree->memory(), document.world().tracer->memory());
    EXPECT_EQ(changes(), Changes{}) << "the frames are the same";
    test::draw(host.maker, state);
    EXPECT_EQ(host.maker.image().pixels, before);
    hideParts(document, nullptr);
    EXPECT_EQ(document.tracer(), document.world().tracer);
}

TEST_F(SceneUpkeepTest, ATreeOfWhatWasVisibleIsNotUsed) {
    const SceneUpkeep::Pace pace{
        .current = true, .complete = false, .idle = false, .seconds = 0, .coarsest = 0};
    hideParts(document, boxHidden());
    upkeep.advance(pace);
    EXPECT_TRUE(upkeep.works() || !document.visible().pruned()) << "it is being built, or is there already";
    hideParts(document, nullptr);
    advance(pace);
    EXPECT_EQ(document.tracer(), document.world().tracer);
    EXPECT_FALSE(upkeep.works());
    const rtcore::KdTree tree = document.world().loaded.tree;
    document.useVisibleTree(tree, nullptr, boxHidden());
    EXPECT_EQ(document.tracer(), document.world().tracer);
}

TEST_F(SceneUpkeepTest, TheExactTreeLeavesThatOfWhatIsVisible) {
    rtcore::LoadedScene room = test::makeRoom();
    room.fastTree = true;
    document.show(test::worldOf(std::move(room)));
    hideParts(document, boxHidden());
    advance({.current = true, .complete = false, .idle = false, .seconds = 0, .coarsest = 0});
    EXPECT_FALSE(document.visible().pruned());
    const auto visible = document.tracer();
    advance({.current = true, .complete = true, .idle = false, .seconds = 0, .coarsest = 0});
    EXPECT_FALSE(document.world().loaded.fastTree);
    EXPECT_EQ(document.tracer(), visible);
}

TEST_F(SceneUpkeepTest, ShadowMapsAreMadeWhereFramesTakeLong) {
    advance({.current = true, .complete = true, .idle = true, .seconds = 1, .coarsest = 1});
    EXPECT_EQ(upkeep.shadowMaps(), nullptr) << "they may take any time";
    SceneUpkeep::Pace pace{
        .current = true, .complete = true, .idle = true, .seconds = 0.005, .coarsest = 0.002, .wanted = 0.01};
    advance(pace);
    EXPECT_EQ(upkeep.shadowMaps(), nullptr) << "they are quick";
    pace.seconds = 1;
    pace.idle = false;
    advance(pace);
    EXPECT_EQ(upkeep.shadowMaps(), nullptr) << "something else is to be done";
    pace.idle = true;
    advance(pace);
    EXPECT_NE(upkeep.shadowMaps(), nullptr);
}

TEST_F(SceneUpkeepTest, ShadowMapsAreMadeAtOnceWhereEvenTheCoarsestFramesTakeLong) {
    advance(
        {.current = false, .complete = false, .idle = false, .seconds = 1, .coarsest = 0.02, .wanted = 0.01});
    EXPECT_NE(upkeep.shadowMaps(), nullptr);
}

TEST_F(SceneUpkeepTest, ShadowMapsOutliveWhatLeavesShadowsWhereTheyAre) {
    makeMaps();
    const rtcore::ShadowMaps* const maps = upkeep.shadowMaps();
    ASSERT_NE(maps, nullptr);
    switchLight(document, 1, false);
    setEnvironment(document, 1);
    walk.turn(10, 0);
    document.assign({{"antialiasing", 2}});
    EXPECT_EQ(upkeep.shadowMaps(), maps);
}

TEST_F(SceneUpkeepTest, ShadowMapsDieWithTheirScene) {
    makeMaps();
    ASSERT_NE(upkeep.shadowMaps(), nullptr);
    document.show(test::worldOf(test::makeRoom()));
    EXPECT_EQ(upkeep.shadowMaps(), nullptr);
    makeMaps();
    EXPECT_NE(upkeep.shadowMaps(), nullptr);
}

TEST(ShadowMapping, HoldsForLightsThatStandAlike) {
    using Lights = std::vector<rtcore::SceneLight>;
    const rtcore::Light light = test::pointLight({1, 2, 3}, 4);
    rtcore::Light off = light, red = light, moved = light, wide = light;
    off.on = 0;
    red.intensity = {9, 0, 0};
    moved.position.x = 2;
    wide.radius = 1;
    const Lights before{light, light};
    EXPECT_TRUE(castAlike(before, Lights{off, red}));
    EXPECT_FALSE(castAlike(before, Lights{light, moved}));
    EXPECT_FALSE(castAlike(before, Lights{light, wide}));
    EXPECT_FALSE(castAlike(before, Lights{light}));
}

} // namespace
} // namespace rtserver

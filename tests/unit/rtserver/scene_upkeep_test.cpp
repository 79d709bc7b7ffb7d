#include "rtserver/frames/scene_upkeep.h"

#include "shown_room.h"

#include "rtcore/io/bsp/bsp_file.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <thread>
#include <vector>

namespace rtserver {
namespace {

using namespace std::chrono_literals;
using rtcore::Change;
using rtcore::Changes;
using rtcore::SectionPlanes;

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

SectionPlanes levelAt(float height) {
    SectionPlanes sections;
    sections.planes = {{{0, height, 0}, {0, 1, 0}}};
    return sections;
}

std::vector<rtcore::HalfSpace> halvesOf(const Document& document) {
    const std::span<const rtcore::HalfSpace> halves = document.visible().halves();
    return {halves.begin(), halves.end()};
}

SceneUpkeep::Pace paceAt(double seconds) {
    SceneUpkeep::Pace pace;
    pace.current = true;
    pace.now = seconds;
    return pace;
}

TEST_F(SceneUpkeepTest, ATreeOfWhatSectionsLeaveFollowsTheReducedOneOnceTheyRest) {
    const rtcore::Box3 bounds = document.tracer()->bounds();
    cutOpen(document, levelAt(bounds.centre().y));
    EXPECT_TRUE(document.visible().reduced());
    upkeep.advance(paceAt(10));
    upkeep.advance(paceAt(10.1));
    EXPECT_FALSE(upkeep.works()) << "it may be moved on";
    cutOpen(document, levelAt(bounds.centre().y + 0.01F));
    upkeep.advance(paceAt(20));
    EXPECT_FALSE(upkeep.works()) << "it was";
    const auto reduced = document.tracer();
    test::FakeHost host;
    test::draw(host.maker, state);
    const auto before = host.maker.image().pixels;
    changes();
    advance(paceAt(30));
    EXPECT_FALSE(document.visible().reduced());
    EXPECT_NE(document.tracer(), reduced);
    EXPECT_EQ(document.tracer()->bounds(), bounds);
    EXPECT_EQ(changes(), Changes{}) << "the frames are the same";
    test::draw(host.maker, state);
    EXPECT_EQ(host.maker.image().pixels, before);
    SectionPlanes same = document.scene()->sections;
    same.light = rtcore::SectionLight::Cut;
    cutOpen(document, same);
    EXPECT_FALSE(document.visible().reduced()) << "the same planes leave the same";
    cutOpen(document, levelAt(bounds.centre().y));
    EXPECT_TRUE(document.visible().reduced()) << "at once";
    cutOpen(document, {});
    EXPECT_FALSE(document.visible().reduced());
    EXPECT_EQ(document.tracer(), document.world().tracer);
}

TEST_F(SceneUpkeepTest, ATreeOfWhatSectionsLeftIsNotUsed) {
    const float middle = document.tracer()->bounds().centre().y;
    cutOpen(document, levelAt(middle));
    upkeep.advance(paceAt(0));
    upkeep.advance(paceAt(1));
    EXPECT_TRUE(upkeep.works() || !document.visible().reduced()) << "it is being built, or is there already";
    const std::vector<rtcore::HalfSpace> before = halvesOf(document);
    cutOpen(document, levelAt(middle - 0.1F));
    upkeep.advance(paceAt(1));
    EXPECT_FALSE(upkeep.works());
    const rtcore::KdRayTracer& built = *document.world().tracer;
    document.useTreeWithin(built, nullptr, before);
    EXPECT_TRUE(document.visible().reduced()) << "other planes";
    document.useTreeWithin(built, boxHidden(), halvesOf(document));
    EXPECT_TRUE(document.visible().reduced()) << "other parts";
    document.useTreeWithin(built, nullptr, halvesOf(document));
    EXPECT_FALSE(document.visible().reduced());
}

TEST_F(SceneUpkeepTest, ATreeOfWhatSectionsLeaveLacksHiddenParts) {
    cutOpen(document, levelAt(document.tracer()->bounds().centre().y));
    hideParts(document, boxHidden());
    test::FakeHost host;
    test::draw(host.maker, state);
    const auto before = host.maker.image().pixels;
    upkeep.advance(paceAt(0));
    advance(paceAt(1));
    advance(paceAt(2));
    EXPECT_FALSE(document.visible().pruned() || document.visible().reduced());
    test::draw(host.maker, state);
    EXPECT_EQ(host.maker.image().pixels, before);
    hideParts(document, nullptr);
    EXPECT_TRUE(document.visible().reduced());
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

#include "bridge/control/page_sentence.h"
#include "bridge/control/scene_facts.h"

#include <gtest/gtest.h>

namespace {

using nlohmann::json;

app::StateReport sample() {
    app::StateReport state;
    state.scene = "/home/anna/secret/nave.scn";
    rtcore::LightDescription spot;
    spot.id = 4;
    spot.light.kind = rtcore::LightKind::Spot;
    spot.light.intensity = {2, 1, 0};
    spot.light.cosInner = 1;
    spot.light.cosOuter = 0.5F;
    state.lights = {{4, true, "pendant", spot}};
    state.environments = {{false, "sunset"}};
    state.settings = rtcore::settingAssignments({}, true);
    state.bookmarks = {"altar"};
    state.undo = "load camera /home/anna/secret/altar.cam";
    return state;
}

bool readState(bridge::SceneFacts& facts, const app::StateReport& state) {
    return facts.read(app::formatStateReport(state, 65520));
}

TEST(SceneFacts, HoldNoFolders) {
    bridge::SceneFacts facts;
    ASSERT_TRUE(readState(facts, sample()));
    EXPECT_EQ(facts.all()["scene"], "nave.scn");
    EXPECT_EQ(facts.all()["undo"], (json{{"label", "camera"}, {"of", "altar.cam"}}));
    EXPECT_EQ(facts.all()["redo"], nullptr);
    EXPECT_EQ(facts.all().dump().find("anna"), std::string::npos);
    EXPECT_EQ(facts.all().dump().find("secret"), std::string::npos);
}

TEST(SceneFacts, DescribeLights) {
    bridge::SceneFacts facts;
    ASSERT_TRUE(readState(facts, sample()));
    const json light = facts.all()["lights"][0];
    EXPECT_EQ(light["id"], 4);
    EXPECT_EQ(light["kind"], "spot");
    EXPECT_EQ(light["colour"], json({1.0, 0.5, 0.0}));
    EXPECT_EQ(light["outer"], 60);
    const auto power = light["power"].get<double>(), unit = facts.all()["metresPerUnit"].get<double>();
    EXPECT_GT(power, 0);
    EXPECT_NEAR(light["lumens"].get<double>() / (683 * power * unit * unit), 1, 1e-6);
    EXPECT_EQ(light["angle"], 0);
}

// In the coordinates of the model's file, which no float holds.
TEST(SceneFacts, DescribeSections) {
    bridge::SceneFacts facts;
    app::StateReport state = sample();
    state.origin.at = {1e7, 0, 0};
    state.bounds = {{-1, 0, -2}, {1, 3, 2}};
    state.sections = {{{{0.5F, 1, 0}, {0, 1, 0}}}, rtcore::SectionLight::Cut, {}};
    ASSERT_TRUE(readState(facts, state));
    const json sections = facts.all()["sections"];
    EXPECT_EQ(sections["planes"], json::parse(R"([{"point": [10000000.5, 1, 0], "normal": [0, 1, 0]}])"));
    EXPECT_EQ(sections["bounds"]["hi"], json({10000001.0, 3.0, 2.0}));
    EXPECT_EQ(sections["light"], "cut");
    EXPECT_EQ(sections["caps"], "own");
    EXPECT_EQ(sections["max"], 6);
}

TEST(SceneFacts, TellMeasuresAsTheirLabelsDo) {
    app::StateReport state = sample();
    state.origin.at = {100, 0, 0};
    state.bounds = {{-1, -1, -1}, {1, 3, 1}};
    state.sections.planes = {{{0, 1, 0}, {0, 1, 0}}};
    state.measures = {
        .all = {{.points = {{0, 0, 0}, {3, 4, 0}}, .name = "door"},
                {.kind = rtcore::MeasureKind::Chain, .points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}},
        .unit = rtcore::LengthUnit::Centimetre,
        .decimals = 1};
    state.measureCount = 2;
    bridge::SceneFacts facts;
    ASSERT_TRUE(readState(facts, state));
    const json measures = facts.all()["measures"];
    EXPECT_EQ(measures["unit"], "cm");
    EXPECT_EQ(measures["count"], 2);
    const json& distance = measures["all"][0];
    EXPECT_EQ(distance["value"], 500);
    EXPECT_EQ(distance["decimals"], 1);
    EXPECT_EQ(distance["points"], json({{100, 0, 0}, {103, 4, 0}}));
    EXPECT_EQ(distance["name"], "door");
    EXPECT_EQ(distance["cut"], true);
    EXPECT_EQ(measures["all"][1]["cut"], false) << "in the plane";
    EXPECT_EQ(measures["all"][1]["legs"][1]["value"], 100);
}

TEST(SceneFacts, TellNotesAsTheyAre) {
    app::StateReport state = sample();
    state.origin.at = {100, 0, 0};
    state.bounds = {{-1, -1, -1}, {1, 3, 1}};
    state.sections.planes = {{{0, 1, 0}, {0, 1, 0}}};
    state.notes = {{.point = {1, 0.5, 0},
                    .text = "see /etc/x\n<script>",
                    .author = "=1+2",
                    .view = {},
                    .written = "2026-11-30T18:40:00Z"},
                   {.point = {0, 2, 0}, .text = "b", .view = {}}};
    state.noteCount = 7;
    bridge::SceneFacts facts;
    ASSERT_TRUE(readState(facts, state));
    const json notes = facts.all()["notes"];
    EXPECT_EQ(notes["count"], 7);
    EXPECT_EQ(facts.notes(), 7U);
    EXPECT_EQ(notes["shortened"], false);
    EXPECT_EQ(notes["all"][0], (json{{"point", {101, 0.5, 0}},
                                     {"text", "see /etc/x\n<script>"},
                                     {"author", "=1+2"},
                                     {"written", "2026-11-30T18:40:00Z"},
                                     {"cut", false}}));
    EXPECT_EQ(notes["all"][1]["cut"], true);
}

TEST(SceneFacts, TellOnlyWhatChanged) {
    bridge::SceneFacts facts;
    app::StateReport state = sample();
    ASSERT_TRUE(readState(facts, state));
    EXPECT_EQ(facts.changes(), facts.all());
    ASSERT_TRUE(readState(facts, state));
    EXPECT_TRUE(facts.changes().empty());
    for (rtcore::SettingAssignment& each : state.settings)
        if (each.name == "maxDepth") each.value = 9;
    state.edits = 1;
    ASSERT_TRUE(readState(facts, state));
    EXPECT_EQ(facts.changes(), (json{{"values", {{"maxDepth", 9}}}, {"edits", 1}}));
    EXPECT_EQ(facts.settingText("maxDepth"), "9");
}

TEST(SceneFacts, RefuseWhatIsNoState) {
    bridge::SceneFacts facts;
    for (const char* text : {"", "pong", "version = 99", "scene = 1"}) EXPECT_FALSE(facts.read(text)) << text;
    EXPECT_FALSE(facts.known());
}

TEST(Messages, AreTakenApartAndCutFromFolders) {
    const std::vector<json> events =
        bridge::messageEvents("3 warning /home/anna/room.obj: the texture textures/wall.png is "
                              "missing\nrubbish\n4 event light 2 off");
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[0]["text"], "room.obj: the texture wall.png is missing");
    EXPECT_EQ(events[0]["kind"], "warning");
    EXPECT_EQ(events[1]["number"], 4);
    EXPECT_EQ(events[1]["text"], "light 2 off");
}

TEST(Texts, LoseFoldersWithBlanksToo) {
    EXPECT_EQ(bridge::withoutFolders("/home/John Smith/my dir/wall.png: is missing"), "wall.png: is missing");
    EXPECT_EQ(bridge::withoutFolders("load \"/home/John Smith/a b.cam\" (/mnt/x y/z)"),
              "load \"a b.cam\" (z)");
    EXPECT_EQ(bridge::withoutFolders("/"), "");
    EXPECT_EQ(bridge::withoutFolders("light 2 off"), "light 2 off");
    EXPECT_EQ(bridge::withoutFolders("luminance 7 cd/m2, in abcd/m2"), "luminance 7 cd/m2, in m2");
}

TEST(PageSentences, AreThoseOfTheServerWithoutFolders) {
    const auto sentence = [](std::string_view detail) {
        json event;
        bridge::addSentence(event, "in /home/anna/a.scn", detail);
        EXPECT_EQ(event["text"], "in a.scn");
        return event.value("sentence", json());
    };
    EXPECT_EQ(sentence(R"(["{0}: {1}","/home/anna/a.scn",["no light {0}","'/home/anna/x'"]])").dump(),
              R"(["{0}: {1}","a.scn",["no light {0}","'x'"]])");
    const std::string deep = std::string(1000, '[') + "\"a\"" + std::string(1000, ']');
    for (const std::string& wrong :
         {std::string(), std::string("\"a\""), std::string("[]"), std::string("[1]"),
          std::string("[\"a\",7]"), std::string("[\"a\",{}]"), std::string("[\"a\""), std::string("\xFF"),
          deep, "[\"a\",\"" + std::string(20'000, 'b') + "\"]"})
        EXPECT_TRUE(sentence(wrong).is_null()) << wrong.substr(0, 50);
}

TEST(PageSentences, OfTheBridgeHaveTheirForm) {
    json event;
    bridge::addSentence(event, rtcore::say("{0} is locked", std::string("maxDepth")));
    EXPECT_EQ(event["text"], "maxDepth is locked");
    EXPECT_EQ(event["sentence"].dump(), R"(["{0} is locked","maxDepth"])");
    bridge::addSentence(event = json(), rtcore::Sentence());
    EXPECT_EQ(event["text"], "");
    EXPECT_FALSE(event.contains("sentence"));
}

} // namespace

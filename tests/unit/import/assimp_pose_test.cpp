/// Skins, morph targets, animations and hidden parts of formats that Assimp reads, by the real program.
#include "rtcore/io/import/assimp/collada_morphs.h"
#include "rtcore/io/import/assimp/fbx_notes.h"
#include "rtcore/platform/error.h"
#include "unit/import/import_support.h"
#include "unit/import/pose_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using rtcore::ImportedModel;
using rtcore::readPose;
using rtcore::Vec3;
using test::near;

ImportedModel importAt(const std::string& name, const std::string& text, const std::string& pose = "rest") {
    rtcore::ImportOptions options;
    options.pose = readPose(pose);
    return test::importText(name, text, options);
}

/// Whether some vertex stands there.
bool has(const ImportedModel& read, Vec3 position, float tolerance = 1e-4F) {
    return std::ranges::any_of(read.model.mesh.vertices, [&](const rtcore::Vertex& v) {
        return near(v.position(), position, tolerance);
    });
}

std::string warningsOf(const ImportedModel& read) {
    std::string text;
    for (const rtcore::Sentence& warning : read.report.warnings) text += warning.english() + "\n";
    return text;
}

std::string listOf(const ImportedModel& read) {
    std::string text;
    for (const rtcore::Vertex& v : read.model.mesh.vertices) {
        const Vec3 p = v.position();
        text += "(" + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + ") ";
    }
    return text + warningsOf(read);
}

/// The four corners of the bar with its upper end turned by a quarter.
void expectBent(const ImportedModel& read, float right = 0) {
    EXPECT_EQ(read.model.mesh.vertices.size(), 4U);
    EXPECT_TRUE(has(read, {right, 0, 0})) << listOf(read);
    EXPECT_TRUE(has(read, {right + 1, 0, 0})) << listOf(read);
    EXPECT_TRUE(has(read, {-1, 1 + right, 0})) << listOf(read);
    EXPECT_TRUE(has(read, {-1, 2 + right, 0})) << listOf(read);
}

TEST(Skins, OfXFilesFollowTheirJointsAndNotTheirFrame) { expectBent(importAt("bar.x", test::barX())); }
TEST(Skins, OfColladaFollowTheirJointsAndNotTheirNode) { expectBent(importAt("bar.dae", test::barDae())); }
TEST(Skins, OfFbxFollowTheirJointsAfterTheOffsetOfTheGeometry) {
    expectBent(importAt("bar.fbx", test::barFbx()), 1);
}

TEST(Skins, AnimationsMoveTheJoints) {
    for (const auto& [name, text] :
         {std::pair{"bar.x", test::barX()}, std::pair{"bar.dae", test::barDae()}}) {
        const ImportedModel first = importAt(name, text, "first");
        EXPECT_TRUE(has(first, {0, 2, 0}) && has(first, {1, 2, 0})) << name << listOf(first);
        const ImportedModel half = importAt(name, text, "1@0.5");
        constexpr float kRoot = 0.70710678F;
        EXPECT_TRUE(has(half, {-kRoot, 1 + kRoot, 0})) << name << listOf(half);
        expectBent(importAt(name, text, "1@7"));
        EXPECT_THROW(importAt(name, text, "Fly@0"), rtcore::FileError);
    }
    expectBent(importAt("bar.x", test::barX(), "Walk@1"));
    EXPECT_THROW(importAt("cube.obj", test::kCubeObj, "Walk@1"), rtcore::FileError);
    EXPECT_NE(warningsOf(importAt("cube.obj", test::kCubeObj, "first")).find("no animation"),
              std::string::npos);
}

TEST(Skins, OfMd5AreAnimatedByTheFileBesideThem) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "bar.md5mesh", test::kBarMd5Mesh);
    test::writeText(folder / "bar.md5anim", test::kBarMd5Anim);
    const auto read = [&](const char* pose) {
        rtcore::ImportOptions options;
        options.pose = readPose(pose);
        return test::importFile(folder / "bar.md5mesh", options);
    };
    for (const char* const straight : {"rest", "first"}) {
        const ImportedModel model = read(straight);
        EXPECT_TRUE(has(model, {0, 0, -2}) && has(model, {1, 0, -2})) << straight << listOf(model);
    }
    const ImportedModel bent = read("1@0.5"), half = read("1@0.25");
    EXPECT_TRUE(has(bent, {1, 0, -1})) << "(0 2 0), at two frames a second" << listOf(bent);
    EXPECT_TRUE(has(half, {0.70710678F, 0, -1.70710678F})) << listOf(half);
}

TEST(Skins, DamageCostsItselfAlone) {
    const ImportedModel back =
        importAt("bar.x",
                 test::barX("2; "
                            "4800;16;1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,1.0,0.0,1.0;;,0;16;"
                            "1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,1.0,0.0,1.0;;;"),
                 "Walk@0.5");
    expectBent(back);
    EXPECT_NE(warningsOf(back).find("damaged and passed over: 1"), std::string::npos);
    const ImportedModel weightless = importAt(
        "bar.x",
        test::barX("1; 0;16;1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,1.0,0.0,1.0;;;", "0.0,0.0"));
    EXPECT_TRUE(has(weightless, {101, 2, 0}))
        << "what has no joint goes with the mesh's own frame" << listOf(weightless);
    std::string lost = test::barX();
    lost.replace(lost.find("Frame B1"), 8, "Frame BX");
    const ImportedModel without = importAt("bar.x", lost);
    EXPECT_NE(warningsOf(without).find("skins that are missing: 1;"), std::string::npos);
}

TEST(Morphs, OfColladaCountAsFarAsTheFileSays) {
    for (const char* const method : {"NORMALIZED", "RELATIVE"}) {
        EXPECT_TRUE(has(importAt("m.dae", test::morphDae("0 0", method)), {1, 2, 0})) << method;
        EXPECT_TRUE(has(importAt("m.dae", test::morphDae("0.5 0", method)), {1, 2, 0.5F})) << method;
        const ImportedModel both = importAt("m.dae", test::morphDae("1 0.25", method));
        EXPECT_TRUE(has(both, {1.25F, 2, 1})) << method << listOf(both);
    }
}

TEST(Morphs, OfColladaMoveWithTheAnimationOfTheirWeights) {
    // Assimp takes what moves "Bar-W(1)" for what moves the node "Bar".
    const auto moved = [](const std::string& target, const std::string& pose) {
        std::string text = test::morphDae("0.5 0", "NORMALIZED", test::growingDae(target, "0.25 1"));
        for (std::size_t at = 0; (at = text.find("\"W\"", at)) != std::string::npos; ++at)
            text.replace(at, 3, "\"Bar-W\"");
        text.replace(text.find("\"#W\""), 4, "\"#Bar-W\"");
        return importAt("m.dae", text, pose);
    };
    for (const std::string target : {"Bar-W(1)", "C/Bar-W(1)"}) {
        EXPECT_TRUE(has(moved(target, "rest"), {1, 2, 0.5F})) << target;
        const ImportedModel first = moved(target, "first");
        EXPECT_TRUE(has(first, {1.25F, 2, 0.5F})) << target << listOf(first);
        const ImportedModel later = moved(target, "Grow@0.5");
        EXPECT_TRUE(has(later, {1.625F, 2, 0.5F})) << target << listOf(later);
    }
    for (const std::string target : {"Bar-W(7)", "Bar-W(-1)", "Bar-W(", "Bar-W()"}) {
        const ImportedModel whole = moved(target, "first");
        EXPECT_TRUE(has(whole, {1, 2, 0.5F})) << target << listOf(whole);
    }
}

TEST(Morphs, OfManyScenesAndWeightsTakeNoMoreThanTheFile) {
    std::string text = test::morphDae("0.5 0", "NORMALIZED", test::growingDae("W(1)", "0.25 1"));
    const std::string weights = ">0.5 0<";
    std::string many = ">0.5 0", scenes;
    for (int i = 0; i < 20'000; ++i) many += " 0";
    for (int i = 0; i < 5'000; ++i)
        scenes += "<visual_scene id=\"V" + std::to_string(i) + "\"></visual_scene>";
    text.replace(text.find(weights), weights.size(), many + "<");
    text.insert(text.find("<visual_scene id="), scenes);
    const test::TemporaryFolder folder;
    test::writeText(folder / "m.dae", text);
    const auto edited = rtcore::colladaWithoutMorphs(folder / "m.dae");
    ASSERT_TRUE(edited);
    EXPECT_LT(edited->size(), text.size() + 1000);
    EXPECT_NE(edited->find("rtsuite-weight-0-1\" name"), std::string::npos);
}

TEST(Morphs, ChannelsOfColladaThatNameNoTransformMoveNothing) {
    for (const std::string target : {"Bar", "S", "Bar-W(1)", "Bar(0)(0)", "Bar(3)", "(", "", "none/none"}) {
        std::string text = test::morphDae("0.5 0", "NORMALIZED", test::growingDae(target, "0.25 1"));
        const ImportedModel model = importAt("m.dae", text, "first");
        EXPECT_TRUE(has(model, {1, 2, 0.5F})) << target << listOf(model);
        const std::string head = "<channel ";
        text.insert(text.find(head) + head.size(), "name=\"a > b\" id='\">' ");
        EXPECT_TRUE(has(importAt("m.dae", text, "first"), {1, 2, 0.5F})) << target;
    }
}

TEST(Morphs, OfFbxCountAsFarAsTheirChannelSays) {
    for (const bool asProperty : {false, true}) {
        EXPECT_TRUE(has(importAt("m.fbx", test::morphFbx("0", asProperty)), {1, 2, 0}));
        const ImportedModel part = importAt("m.fbx", test::morphFbx("40", asProperty));
        EXPECT_TRUE(has(part, {1, 2, 0.4F})) << listOf(part);
    }
}

TEST(Morphs, ChannelsOfSeveralShapesPassFromOneToTheNext) {
    const rtcore::FbxMorphChannel channel{0, {0.25, 1}, {"a", "b"}};
    EXPECT_EQ(channel.weightsAt(0.125), (std::vector<double>{0.5, 0}));
    EXPECT_EQ(channel.weightsAt(0.25), (std::vector<double>{1, 0}));
    EXPECT_EQ(channel.weightsAt(0.625), (std::vector<double>{0.5, 0.5}));
    EXPECT_EQ(channel.weightsAt(1), (std::vector<double>{0, 1}));
    EXPECT_EQ(channel.weightsAt(2), (std::vector<double>{0, 2}));
}

/// Bars at x = 0, 10, 20 ... under the nodes that `models` name.
std::string scene(const std::string& models, const std::string& links, std::initializer_list<int> shown) {
    std::string objects = models, connections = links;
    for (const int id : shown) {
        objects += test::geometryFbx(1000 + id);
        connections += test::linkFbx(1000 + id, id);
    }
    return test::fbx(objects, connections);
}

std::string at(int x) { return test::vectorFbx("Lcl Translation", std::to_string(x) + ",0,0"); }
const char* const kHidden = "   P: \"Visibility\", \"Visibility\", \"\", \"A\",0\n";
const char* const kNotShown = "   P: \"Show\", \"bool\", \"\", \"\",0\n";
const char* const kAlone = "   P: \"Visibility Inheritance\", \"Visibility Inheritance\", \"\", \"\",0\n";

TEST(FbxVisibility, HiddenNodesAreLeftOutWithWhatIsBelow) {
    const std::string models =
        test::modelFbx(2, "A", "Mesh", at(0)) + test::modelFbx(3, "B", "Mesh", at(10) + kHidden) +
        test::modelFbx(4, "C", "Mesh", at(10)) + test::modelFbx(5, "D", "Mesh", at(20) + kAlone) +
        test::modelFbx(6, "E", "Mesh", at(40) + kNotShown) + test::modelFbx(7, "F", "Mesh", at(10));
    const std::string links = test::linkFbx(2, 0) + test::linkFbx(3, 0) + test::linkFbx(4, 3) +
                              test::linkFbx(5, 3) + test::linkFbx(6, 0) + test::linkFbx(7, 6);
    const ImportedModel read = importAt("v.fbx", scene(models, links, {2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(read.model.mesh.vertices.size(), 12U) << listOf(read);
    EXPECT_TRUE(has(read, {0, 0, 0}) && has(read, {30, 0, 0}) && has(read, {50, 0, 0})) << listOf(read);
}

TEST(FbxVisibility, NodesOfOneNameAreToldApart) {
    const std::string models = test::modelFbx(2, "A", "Mesh", at(0)) +
                               test::modelFbx(3, "A", "Mesh", at(10) + kHidden) +
                               test::modelFbx(4, "A", "Mesh", at(20));
    const std::string links = test::linkFbx(2, 0) + test::linkFbx(3, 0) + test::linkFbx(4, 0);
    const ImportedModel read = importAt("v.fbx", scene(models, links, {2, 3, 4}));
    EXPECT_TRUE(has(read, {0, 0, 0}) && has(read, {20, 0, 0}) && !has(read, {10, 0, 0})) << listOf(read);
}

TEST(FbxVisibility, OfLevelsOfDetailTheFirstIsShown) {
    const std::string models = test::modelFbx(2, "G", "LodGroup") + test::modelFbx(3, "L0", "Mesh", at(0)) +
                               test::modelFbx(4, "L1", "Mesh", at(10)) +
                               test::modelFbx(5, "L2", "Null", at(20)) + test::modelFbx(6, "Part", "Mesh");
    const std::string links = test::linkFbx(2, 0) + test::linkFbx(3, 2) + test::linkFbx(4, 2) +
                              test::linkFbx(5, 2) + test::linkFbx(6, 5);
    const ImportedModel read = importAt("v.fbx", scene(models, links, {3, 4, 6}));
    EXPECT_EQ(read.model.mesh.vertices.size(), 4U) << listOf(read);
    EXPECT_TRUE(has(read, {0, 0, 0}));
}

TEST(FbxVisibility, AModelThatHidesAllIsRefusedAsThat) {
    const std::string text = scene(test::modelFbx(2, "A", "Mesh", kHidden), test::linkFbx(2, 0), {2});
    try {
        importAt("v.fbx", text);
        FAIL();
    } catch (const rtcore::FileError& error) {
        EXPECT_NE(std::string(error.what()).find("hidden"), std::string::npos) << error.what();
    }
}

TEST(FbxNotes, DamagedTextDoesNoHarm) {
    const std::string whole = test::morphFbx("40", true);
    const test::TemporaryFolder folder;
    for (std::size_t length = 0; length < whole.size(); length += 7) {
        test::writeText(folder / "m.fbx", whole.substr(0, length));
        rtcore::fbxNotesOf(rtcore::readFbxElements(folder / "m.fbx"));
    }
    test::writeText(folder / "m.fbx", "Objects: {" + std::string(100'000, '{') + ": \"");
    rtcore::fbxNotesOf(rtcore::readFbxElements(folder / "m.fbx"));
}

} // namespace

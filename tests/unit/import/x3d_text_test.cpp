// X3D: what Assimp alone would lose, misplace or turn over.
#include "rtcore/io/import/assimp/x3d_text.h"

#include "import_support.h"
#include "support/damaged_text.h"

#include "rtcore/io/import/assimp/assimp_import.h"
#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace rtcore;
using test::TemporaryFolder;
using test::writeText;

std::string x3dScene(const std::string& content) {
    return "<?xml version='1.0' encoding='UTF-8'?>\n<!DOCTYPE X3D PUBLIC 'a' 'b'>\n"
           "<X3D profile='Immersive' version='3.0'><Scene>" +
           content + "</Scene></X3D>\n";
}

std::string x3dShape(const std::string& geometry, const std::string& attributes = "") {
    return "<Shape" + attributes + "><Appearance><Material diffuseColor='0.8 0.2 0.1'/></Appearance>" +
           geometry + "</Shape>";
}

const char* const kX3dSquare = "<IndexedFaceSet coordIndex='0 1 2 3 -1'>"
                               "<Coordinate point='0 0 0 1 0 0 1 1 0 0 1 0'/></IndexedFaceSet>";

std::string x3dSquare(const std::string& attributes = "") { return x3dShape(kX3dSquare, attributes); }

std::string x3dMoved(int x, const std::string& content) {
    return "<Transform translation='" + std::to_string(x) + " 0 0'>" + content + "</Transform>";
}

FileImport x3dImport(const std::string& content) {
    const TemporaryFolder folder;
    writeText(folder / "m.x3d", x3dScene(content));
    return importWithAssimp(folder / "m.x3d", {});
}

/// The least x of the parts, in order.
std::vector<int> x3dPlaces(const FileImport& import) {
    std::vector<int> places;
    for (const ModelPart& part : import.model.parts) {
        float x = INFINITY;
        for (std::uint32_t t = 0; t < part.triangleCount; ++t)
            for (const std::uint32_t v : import.model.triangles[part.firstTriangle + t].v)
                x = std::min(x, import.model.vertices[v].position().x);
        places.push_back(static_cast<int>(std::lround(x)));
    }
    return places;
}

std::vector<int> sortedX3dPlaces(const std::string& content) {
    std::vector<int> places = x3dPlaces(x3dImport(content));
    std::ranges::sort(places);
    return places;
}

std::string x3dRefusal(const std::string& content) {
    try {
        x3dImport(content);
    } catch (const FileError& error) {
        EXPECT_EQ(error.kind, FailureKind::BadData);
        return error.what();
    }
    return "";
}

TEST(X3dText, GroupsThatAreUsedAgainCloseAsManyLevelsAsTheyOpen) {
    for (const std::string group : {"Transform", "Group", "Switch whichChoice='0'", "StaticGroup"}) {
        const std::string name = group.substr(0, group.find(' '));
        const std::string defined = "<" + group + " DEF='T'>" + x3dSquare() + "</" + name + ">";
        const std::string used = x3dMoved(2, "<" + name + "\n USE='T'/>");
        EXPECT_EQ(sortedX3dPlaces(defined + x3dMoved(5, used + x3dMoved(1, x3dSquare())) +
                                  x3dMoved(9, x3dSquare())),
                  (std::vector{0, 6, 7, 9}))
            << group;
    }
}

TEST(X3dText, GroupsWithoutContentCloseOneLevel) {
    EXPECT_EQ(sortedX3dPlaces(x3dMoved(5, "<Transform/><Group> <!-- none --> </Group>" + x3dSquare()) +
                              x3dMoved(9, x3dSquare())),
              (std::vector{5, 9}));
}

TEST(X3dText, CopiesHoldCopies) {
    const std::string two = "<Group DEF='A'>" + x3dSquare() + "</Group><Group DEF='B'>" +
                            x3dMoved(1, "<Group USE='A'/>") + x3dMoved(2, "<Group USE='A'/>") + "</Group>";
    EXPECT_EQ(sortedX3dPlaces(two + x3dMoved(10, "<Group USE='B'/>")), (std::vector{0, 1, 2, 11, 12}));
}

TEST(X3dText, AllKindsOfGroupsShowWhatTheyHold) {
    for (const std::string name : {"Anchor", "Billboard", "Collision"})
        EXPECT_EQ(
            sortedX3dPlaces(x3dSquare() + "<" + name + ">" + x3dMoved(3, x3dSquare()) + "</" + name + ">"),
            (std::vector{0, 3}))
            << name;
    const std::string proxy = "<Transform containerField='proxy'>" + x3dSquare() + "</Transform>";
    EXPECT_EQ(sortedX3dPlaces("<Collision>" + proxy + x3dMoved(3, x3dSquare()) + "</Collision>"),
              (std::vector{3}));
}

TEST(X3dText, TheFirstLevelOfDetailIsShownAndTheOthersAreTold) {
    const FileImport import =
        x3dImport("<LOD range='5'>" + x3dMoved(3, x3dSquare()) + x3dMoved(4, x3dSquare()) + "</LOD>");
    EXPECT_EQ(x3dPlaces(import), (std::vector{3}));
    ASSERT_EQ(import.report.warnings.size(), 1U);
    EXPECT_NE(import.report.warnings[0].english().find("LOD"), std::string::npos);
    EXPECT_TRUE(x3dImport("<LOD>" + x3dSquare() + "</LOD>").report.warnings.empty());
}

TEST(X3dText, ASwitchCountsWhatAssimpDoesNotKnow) {
    const auto choice = [](int number) {
        return sortedX3dPlaces(x3dMoved(9, x3dSquare()) + "<Switch whichChoice='" + std::to_string(number) +
                               "'><MetadataString name='n' value='\"v\"'/>" + x3dMoved(1, x3dSquare()) +
                               "<Viewpoint/><Anchor>" + x3dMoved(2, x3dSquare()) + "</Anchor>" +
                               x3dMoved(3, x3dSquare()) + "</Switch>");
    };
    EXPECT_EQ(choice(0), (std::vector{1, 9}));
    EXPECT_EQ(choice(1), (std::vector{9}));
    EXPECT_EQ(choice(2), (std::vector{2, 9}));
    EXPECT_EQ(choice(3), (std::vector{3, 9}));
    EXPECT_EQ(choice(-1), (std::vector{9}));
}

/// The height of the vertex on the axis of a cone without a base.
float coneTip(const FileImport& import) {
    float tip = 0;
    for (const Vertex& v : import.model.vertices)
        if (std::hypot(v.position().x, v.position().z) < 1e-3F && std::abs(v.position().y) > 1)
            tip = v.position().y;
    return tip;
}

TEST(X3dText, ConesStandUpright) {
    const std::string open = "<Cone bottomRadius='0.5' height='3' bottom='false'/>";
    EXPECT_FLOAT_EQ(coneTip(x3dImport(x3dShape(open))), 1.5F);
    EXPECT_FLOAT_EQ(coneTip(x3dImport("<Switch whichChoice='-1'>" + x3dShape(open, " DEF='S'") +
                                      "</Switch><Shape USE='S'/>")),
                    1.5F);
    EXPECT_FLOAT_EQ(coneTip(x3dImport("<Switch whichChoice='-1'>" +
                                      x3dShape("<Cone DEF='C' height='3' bottom='false'/>") + "</Switch>" +
                                      x3dShape("<Cone USE='C'/>"))),
                    1.5F);
    const FileImport base = x3dImport(x3dShape("<Cone height='3' side='false'/>"));
    for (const Vertex& v : base.model.vertices) EXPECT_FLOAT_EQ(v.position().y, -1.5F);
    const ImportedModel closed = test::importText("m.x3d", x3dScene(x3dShape("<Cone height='3'/>")));
    EXPECT_NEAR(test::volumeOf(closed.model.mesh), 3.14, 0.1) << "faces outwards";
}

/// Others are left out with a sentence, and cost nothing else.
TEST(X3dText, FilesThatItNamesAreReadInItsFolderAlone) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "model");
    writeText(folder / "out.x3d", x3dScene(x3dMoved(7, x3dSquare())));
    writeText(folder / "model/part.x3d", x3dScene(x3dMoved(5, x3dSquare())));
    std::filesystem::create_symlink(folder / "out.x3d", folder / "model/link.x3d");
    const auto read = [&](const std::string& content) {
        writeText(folder / "model/m.x3d", x3dScene(x3dSquare() + content));
        return importWithAssimp(folder / "model/m.x3d", {});
    };
    const FileImport whole = read("<Inline url='\"http://x/y.x3d\" \"part.x3d\"'/>");
    EXPECT_EQ(x3dPlaces(whole), (std::vector{0, 5}));
    EXPECT_TRUE(whole.report.warnings.empty());
    for (const std::string name : {"gone.x3d", "../out.x3d", "link.x3d", "http://x/y.x3d"}) {
        const FileImport import = read("<Switch whichChoice='1'><Inline DEF='I' url='\"" + name + "\"'/>" +
                                       x3dMoved(3, x3dSquare()) + "</Switch><Inline USE='I'/>");
        EXPECT_EQ(x3dPlaces(import), (std::vector{0, 3})) << name;
        ASSERT_EQ(import.report.warnings.size(), 1U) << name;
        EXPECT_NE(import.report.warnings[0].english().find("'" + name + "'"), std::string::npos);
        EXPECT_EQ(import.report.files.size(), 1U) << name;
    }
    writeText(folder / "model/part.x3d", x3dScene("<Inline url='../out.x3d'/>"));
    try {
        read("<Inline url='part.x3d'/>");
        FAIL() << "of a file that it names";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("outside of its folder"), std::string::npos) << error.what();
    }
}

TEST(X3dText, OfSeveralAddressesTheFirstThatIsThereCounts) {
    const TemporaryFolder folder;
    const auto missingOf = [&](const std::string& list) {
        writeText(folder / "m.x3d", x3dScene("<Shape><Appearance><ImageTexture url='" + list +
                                             "'/></Appearance>" + kX3dSquare + "</Shape>"));
        const FileImport import = importWithAssimp(folder / "m.x3d", {});
        return import.report.warnings.empty() ? std::string() : import.report.warnings[0].english();
    };
    writeText(folder / "a &b.png", "no image");
    writeText(folder / "c.png", "no image");
    EXPECT_NE(missingOf(R"("x.png" "http://a.b/a.png")").find("'x.png' is missing"), std::string::npos);
    EXPECT_NE(missingOf(R"("x.png")").find("'x.png' is missing"), std::string::npos);
    EXPECT_NE(missingOf(R"("x.png" "c.png")").find("c.png"), std::string::npos);
    EXPECT_NE(missingOf("&quot;x.png&quot;, &quot;a &amp;b.png&quot; &quot;c.png&quot;").find("a &b.png"),
              std::string::npos);
}

TEST(X3dText, WhatIsNotReadIsTold) {
    const FileImport import =
        x3dImport(x3dSquare() + "<Shape><Text string='\"Hello\"'/></Shape><ProtoInstance name='p'/>");
    ASSERT_EQ(import.report.warnings.size(), 1U);
    EXPECT_NE(import.report.warnings[0].english().find("Text, ProtoInstance"), std::string::npos);
}

TEST(X3dText, WhatHasNoEndIsRefused) {
    EXPECT_NE(x3dRefusal("<Group DEF='A'>" + x3dSquare() + "<Group DEF='B'><Group USE='A'/></Group></Group>")
                  .find("'A' uses itself"),
              std::string::npos);
    std::string deep = x3dSquare();
    for (int i = 0; i < 600; ++i) deep = "<Group>" + deep + "</Group>";
    EXPECT_NE(x3dRefusal(deep).find("nested more than"), std::string::npos);
    std::string large = "<Group DEF='G0'>" + x3dSquare() + "</Group>";
    for (int i = 1; i < 12; ++i) {
        large += "<Group DEF='G" + std::to_string(i) + "'>";
        for (int k = 0; k < 10; ++k) large += "<Group USE='G" + std::to_string(i - 1) + "'/>";
        large += "</Group>";
    }
    EXPECT_NE(x3dRefusal(large).find("64 MB"), std::string::npos);
}

TEST(X3dText, WhatAssimpUnderstandsStays) {
    const TemporaryFolder folder;
    writeText(folder / "m.x3d", x3dScene(x3dMoved(1, x3dSquare(" DEF='S'")) + "<Shape USE='S'/>"));
    EXPECT_EQ(x3dForAssimp(folder / "m.x3d"), std::nullopt);
    writeText(folder / "m.xml", x3dScene("<Anchor>" + x3dSquare() + "</Anchor>"));
    EXPECT_EQ(x3dForAssimp(folder / "m.xml"), std::nullopt);
    writeText(folder / "m.X3D", x3dScene("<Anchor>" + x3dSquare() + "</Anchor>"));
    EXPECT_NE(x3dForAssimp(folder / "m.X3D"), std::nullopt);
}

constexpr std::array<std::string_view, 16> kX3dTokens{
    "<",       ">",       "/>",    "</",           "\"",   "'",   "<Group>",          "</Group>",
    "USE='A'", "DEF='A'", "<LOD>", "</Transform>", "<!--", "]]>", "<Group USE='A'/>", "\xFF"};

/// Whatever the bytes: a text or a FileError. More of them: RT_MUTATIONS.
TEST(X3dText, DamagedFilesAreRewrittenOrRefused) {
    const TemporaryFolder folder;
    const std::string text = x3dScene(
        "<Group DEF='A'>" + x3dSquare(" DEF='S'") +
        "</Group><Transform DEF='B' scale='1 2 1'><Group USE='A'/>" +
        "</Transform><LOD><Transform USE='B'/><Shape USE='S'/></LOD><Switch whichChoice='1'><Anchor/>" +
        x3dShape("<Cone DEF='C'/>") + "</Switch><!-- end --><Collision><Shape containerField='proxy'/>" +
        "<ImageTexture url='\"a.png\" \"b.png\"'/></Collision>");
    test::DamagedText damaged({text}, kX3dTokens, 21);
    long rewritten = 0;
    for (long i = 0; i < test::damagedTexts(); ++i) {
        writeText(folder / "m.x3d", damaged.next());
        try {
            rewritten += x3dForAssimp(folder / "m.x3d") ? 1 : 0;
        } catch (const FileError& error) {
            EXPECT_EQ(error.kind, FailureKind::BadData) << error.what();
        }
    }
    EXPECT_GT(rewritten, 0);
}

/// The same, read by the program; some of them, as Assimp starts anew for each.
TEST(X3dText, DamagedFilesAreSoundOrRefused) {
    const TemporaryFolder folder;
    const std::string text = x3dScene(
        "<Group DEF='A'>" + x3dSquare(" DEF='S'") +
        "</Group><Transform DEF='B' scale='1 2 1'><Group USE='A'/>" +
        "</Transform><LOD><Transform USE='B'/><Shape USE='S'/></LOD><Switch whichChoice='1'><Anchor/>" +
        x3dShape("<Cone DEF='C'/>") + "</Switch>" + x3dMoved(2, x3dSquare()));
    test::DamagedText damaged({text}, kX3dTokens, 22);
    for (int i = 0; i < 40; ++i) {
        writeText(folder / "m.x3d", damaged.next());
        try {
            const ImportedModel read = test::importFile(folder / "m.x3d");
            const Mesh& mesh = read.model.mesh;
            for (const ShadingTriangle& t : mesh.shading) ASSERT_LT(t.material, read.model.materials.size());
        } catch (const FileError& error) {
            EXPECT_EQ(error.kind, FailureKind::BadData) << error.what();
        }
    }
}

} // namespace

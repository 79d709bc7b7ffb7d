// Colours of materials are linear or as displays show them, by the habit of the program that wrote the file.
#include "rtcore/io/import/materials/exporter_colours.h"

#include "import_support.h"

#include "rtcore/math/colour.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <set>

namespace {

using namespace rtcore;

constexpr Colour kStated{0.5F, 0.25F, 0.75F};

std::string wordsOf(Colour c) { return fmt::format("{} {} {}", c.r, c.g, c.b); }

/// An OBJ file and its library, whose heads say `obj` and `mtl`.
Material ofObj(const std::string& obj, const std::string& mtl, const std::string& more = "") {
    const test::TemporaryFolder folder;
    test::writeText(folder / "m.mtl",
                    mtl + "newmtl m\nKd " + wordsOf(kStated) + "\nKe " + wordsOf(kStated) + "\n" + more);
    test::writeText(folder / "m.obj", obj + "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
    return test::materialNamed(test::importFile(folder / "m.obj").model, "m");
}

Material ofCollada(const std::string& tool) {
    const std::string text =
        R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)"
        "<contributor><authoring_tool>" +
        tool +
        R"(</authoring_tool></contributor><up_axis>Y_UP</up_axis></asset><library_effects><effect id="e">)"
        R"(<profile_COMMON><technique sid="c"><lambert><emission><color>)" +
        wordsOf(kStated) + R"( 1</color></emission><diffuse><color>)" + wordsOf(kStated) +
        R"( 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>)"
        R"(<library_materials><material id="m" name="m"><instance_effect url="#e"/></material></library_materials>)"
        R"(<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0)"
        R"(</float_array><technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/>)"
        R"(<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>)"
        R"(<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1" material="s">)"
        R"(<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>)"
        R"(</library_geometries><library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g">)"
        R"(<bind_material><technique_common><instance_material symbol="s" target="#m"/></technique_common>)"
        R"(</bind_material></instance_geometry></node></visual_scene></library_visual_scenes>)"
        R"(<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
    return test::importText("m.dae", text).model.materials[0];
}

/// `application`: "" for none.
Material ofFbx(const std::string& creator, const std::string& application) {
    const std::string info =
        application.empty() ? ""
                            : "SceneInfo: \"SceneInfo::GlobalInfo\", \"UserData\" {\nProperties70:  {\nP: "
                              "\"Original\", \"Compound\", "
                              "\"\", \"\"\nP: \"Original|ApplicationName\", \"KString\", \"\", \"\", \"" +
                                  application + "\"\n}\n}\n";
    const std::string colour = fmt::format("{},{},{}", kStated.r, kStated.g, kStated.b);
    const std::string text =
        "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\nFBXHeaderVersion: 1003\nFBXVersion: "
        "7400\nCreator: \"" +
        creator + "\"\n" + info +
        "}\nObjects:  {\nGeometry: 1, \"Geometry::g\", \"Mesh\" {\nVertices: *9 {\na: 0,0,0,1,0,0,0,1,0\n}\n"
        "PolygonVertexIndex: *3 {\na: 0,1,-3\n}\nGeometryVersion: 124\nLayerElementMaterial: 0 {\nVersion: "
        "101\n"
        "MappingInformationType: \"AllSame\"\nReferenceInformationType: \"IndexToDirect\"\nMaterials: *1 "
        "{\na: 0\n}\n}\nLayer: 0 {\nVersion: 100\nLayerElement:  {\nType: \"LayerElementMaterial\"\n"
        "TypedIndex: 0\n}\n}\n"
        "}\nModel: 2, \"Model::n\", \"Mesh\" {\nVersion: 232\n}\nMaterial: 3, \"Material::m\", \"\" "
        "{\nVersion: 102\n"
        "ShadingModel: \"lambert\"\nProperties70:  {\nP: \"DiffuseColor\", \"Color\", \"\", \"A\"," +
        colour +
        "\nP: \"EmissiveFactor\", \"Number\", \"\", \"A\",1\nP: \"EmissiveColor\", \"Color\", \"\", \"A\"," +
        colour + "\n}\n}\n}\nConnections:  {\nC: \"OO\",2,0\nC: \"OO\",1,2\nC: \"OO\",3,2\n}\n";
    return test::importText("m.fbx", text).model.materials[0];
}

Colour decoded(Colour c) { return {srgbDecode(c.r), srgbDecode(c.g), srgbDecode(c.b)}; }

void expectEncoding(const Material& m, ColourEncoding encoding, const std::string& of) {
    const Colour wanted = encoding == ColourEncoding::Display ? decoded(kStated) : kStated;
    EXPECT_TRUE(test::near(m.diffuse, wanted)) << of << ": diffuse " << wordsOf(m.diffuse);
    EXPECT_TRUE(test::near(m.emission, wanted)) << of << ": emission " << wordsOf(m.emission);
}

/// Heads as these programs write them, and the row of the table that they belong to.
struct Example {
    const char* row;
    const char* head;
};
constexpr std::array kObjHeads{
    Example{"blender", "# Blender MTL File: 'house.blend'\n# Material Count: 1\n"},
    Example{"blender", "# Blender 3.4.1 MTL File: 'sketchup.blend'\n"},
    Example{"sketchup", "# Alias OBJ Model File\n# Exported from SketchUp, (c) 2000-2012\n"},
    Example{"rhino", "# Rhino\n\n"},
    Example{"freecad", "# FreeCAD v0.20 build29177 Arch module\n# https://www.freecad.org\n"}};
constexpr std::array kColladaTools{
    Example{"blender", "Blender 2.79.0 commit date:2018-03-22, hash:f4dc9f9d68b"},
    Example{"maya", "Maya 2018 | ColladaMaya v3.05B"}, Example{"sketchup", "Google SketchUp 8.0.4811"},
    Example{"three.js", "THREE.js Collada Exporter"}};
struct FbxExample {
    const char* row;
    const char* creator;
    const char* application;
};
constexpr std::array kFbxWriters{
    FbxExample{"blender", "Blender (stable FBX IO) - 2.79 (sub 0) - 3.7.13", "Blender (stable FBX IO)"},
    FbxExample{"maya", "FBX SDK/FBX Plugins version 2018.1.1", "Maya"},
    FbxExample{"rhino", "FBX SDK/FBX Plugins version 2019.0", "Rhinoceros"},
    FbxExample{"sketchup", "FBX SDK/FBX Plugins version 2017.1", "SketchUp Pro"}};

ColourEncoding encodingOf(std::string_view row) {
    for (const ExporterColours& each : kExporterColours)
        if (each.words == row) return each.encoding;
    ADD_FAILURE() << "no row " << row;
    return ColourEncoding::Linear;
}

TEST(ExporterColours, EachRowHoldsForFilesOfItsProgram) {
    std::set<std::string_view> rows;
    for (const auto& [row, head] : kObjHeads) {
        expectEncoding(ofObj(head, ""), encodingOf(row), head);
        expectEncoding(ofObj("", head), encodingOf(row), head);
        rows.insert(row);
    }
    for (const auto& [row, tool] : kColladaTools) {
        expectEncoding(ofCollada(tool), encodingOf(row), tool);
        rows.insert(row);
    }
    for (const auto& [row, creator, application] : kFbxWriters) {
        expectEncoding(ofFbx(creator, application), encodingOf(row), application);
        rows.insert(row);
    }
    for (const ExporterColours& row : kExporterColours) EXPECT_TRUE(rows.contains(row.words)) << row.words;
}

TEST(ExporterColours, WhatIsUnknownIsLinear) {
    for (const char* const head :
         {"", "# made by hand\n", "# a black rhino\n", "# 3ds Max Wavefront OBJ Exporter v0.97b\n"})
        expectEncoding(ofObj(head, ""), ColourEncoding::Linear, head);
    expectEncoding(ofCollada("FBX COLLADA exporter"), ColourEncoding::Linear, "Collada");
    expectEncoding(ofFbx("FBX SDK/FBX Plugins version 2018.1.1", ""), ColourEncoding::Linear, "FBX");
}

TEST(ExporterColours, ALibraryThatNamesItsProgramIsTakenAsThat) {
    expectEncoding(ofObj("# Rhino\n", "# Blender MTL File: 'None'\n"), ColourEncoding::Linear,
                   "Blender's library");
    expectEncoding(ofObj("# Blender v2.79 (sub 0) OBJ File: ''\n", "# Exported from SketchUp\n"),
                   ColourEncoding::Display, "SketchUp's library");
    expectEncoding(ofObj("# Rhino\n", "# colours of the house\n"), ColourEncoding::Display, "Rhino's model");
}

TEST(ExporterColours, LightStaysAndImagesTakeThePlaceOfGrey) {
    EXPECT_EQ(ofObj("# Rhino\n", "", "Ke 20 1 0\n").emission, (Colour{20, 1, 0}));
    SourceMaterial m;
    m.diffuse = kUnsetDiffuse;
    m.diffuseMap.name = "a.png";
    decodeColours(m);
    EXPECT_EQ(m.diffuse, kUnsetDiffuse) << "which stands for none beside an image";
    m.diffuseMap.name = "";
    decodeColours(m);
    EXPECT_EQ(m.diffuse, decoded(kUnsetDiffuse));
    EXPECT_EQ(m.transmission, kWhite);
}

} // namespace

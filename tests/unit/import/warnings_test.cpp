// Warnings for users about models that could be read, but not as they were meant.
#include "gltf_text.h"
#include "import_support.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace rtcore;
using test::GltfScene;
using test::importFile;
using test::importText;

std::string all(const ImportReport& report) {
    std::string text;
    for (const Sentence& warning : report.warnings) text += warning.english() + "\n";
    return text;
}

void expectWarning(const ImportReport& report, const std::string& words) {
    EXPECT_NE(all(report).find(words), std::string::npos) << "expected: " << words << "\n" << all(report);
}

/// The message with which this file is refused; "accepted" when it gives a model.
std::string refusalOf(const std::string& name, const std::string& text) {
    try {
        importText(name, text);
    } catch (const FileError& error) {
        EXPECT_EQ(error.kind, FailureKind::BadData);
        return error.what();
    }
    return "accepted";
}

/// Assimp quotes all of a text from a number on that it cannot read.
TEST(ImportWarnings, OfALongReasonTheBeginningIsSaid) {
    std::string text = "AC3Db\nMATERIAL \"m\" rgb 1 1 1  amb 1 1 1  emis 0 0 0  spec 0 0 0  shi 0  trans 0\n"
                       "OBJECT world\nkids 1\nOBJECT poly\nnumvert 9000\n0 y.0 0\n";
    for (int i = 1; i < 9000; ++i) text += "0 0 1\n";
    const std::string refusal = refusalOf("m.ac", text);
    EXPECT_NE(refusal.find("Cannot parse string"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find(" ...; open it in"), std::string::npos) << refusal;
    EXPECT_LT(refusal.size(), 600U);
}

TEST(ImportWarnings, ASoundModelHasNone) {
    EXPECT_EQ(all(importText("cube.obj", test::kCubeObj).report), "");
    EXPECT_EQ(all(importText("t.gltf", GltfScene{}.text()).report), "");
}

TEST(ImportWarnings, DamagedTrianglesAreCounted) {
    const ImportedModel m = importText("m.obj", std::string(test::kCubeObj) +
                                                    "v nan 0 0\nv 2e12 0 0\nf 1 2 9\nf 1 2 10\nf 1 2 2\n");
    EXPECT_EQ(m.model.mesh.triangles.size(), 12U);
    expectWarning(m.report,
                  "3 of 15 triangles were damaged and left out: 2 with coordinates that are no numbers "
                  "or beyond 1e12, 1 without area");
}

TEST(ImportWarnings, SomeTrianglesWithoutAreaAreNormal) {
    EXPECT_EQ(all(importText("m.obj", std::string(test::kCubeObj) + "f 1 2 2\n").report), "");
    std::string many = test::kCubeObj;
    for (int i = 0; i < 20; ++i) many += "f 1 2 2\n";
    expectWarning(importText("m.obj", many).report,
                  "20 of 32 triangles were damaged and left out: 20 without");
}

// Assimp drops these by itself.
TEST(ImportWarnings, CornersThatDoNotExistAreCounted) {
    std::string text = GltfScene{}.text();
    const auto replace = [&](const std::string& from, const std::string& to) {
        ASSERT_NE(text.find(from), std::string::npos) << from;
        text.replace(text.find(from), from.size(), to);
    };
    const std::vector<std::uint16_t> indices{0, 1, 2, 0, 1, 7};
    const std::string data = test::base64(std::as_bytes(std::span(indices)));
    replace(R"(},"material":0})", R"(},"indices":3,"material":0})");
    replace(R"("buffers":[)",
            R"("buffers":[{"byteLength":12,"uri":"data:application/octet-stream;base64,)" + data + R"("},)");
    for (int i = 0; i < 3; ++i) replace(R"({"buffer":0)", R"({"buffer":1)");
    replace(R"("byteOffset":60,"byteLength":36}])",
            R"("byteOffset":60,"byteLength":36},{"buffer":0,"byteLength":12}])");
    replace(R"("count":3,"type":"VEC3"}])",
            R"("count":3,"type":"VEC3"},{"bufferView":3,"componentType":5123,"count":6,"type":"SCALAR"}])");
    const ImportedModel m = importText("t.gltf", text);
    EXPECT_EQ(m.model.mesh.triangles.size(), 1U);
    EXPECT_EQ(m.report.unconnectedTriangles, 1U);
    expectWarning(m.report, "1 of 2 triangles was damaged and left out: 1 with corners that do not exist");
}

TEST(ImportWarnings, MissingMaterialLibrariesAreNamed) {
    const std::string cube = test::kCubeObj;
    expectWarning(importText("m.obj", "# mtllib no.mtl\nmtllib  lost one.mtl \r\nusemtl red\n" + cube).report,
                  "material library 'lost one.mtl' is missing");
    expectWarning(importText("m.OBJ", "mtllib a.mtl\n" + cube + "mtllib b.mtl\nmtllib a.mtl\n").report,
                  "material library 'a.mtl' and 'b.mtl' are missing");
    EXPECT_EQ(all(importText("m.obj", "# mtllib no.mtl\no mtllib\n" + cube).report), "");

    const test::TemporaryFolder folder;
    test::writeText(folder / "there.mtl", "newmtl red\nKd 1 0 0\n");
    test::writeText(folder / "m.obj", "mtllib there.mtl\nusemtl red\n" + cube);
    EXPECT_EQ(all(importFile(folder / "m.obj").report), "");
    // Assimp takes the one of the model's name instead.
    test::writeText(folder / "there.obj", "mtllib lost.mtl\nusemtl red\n" + cube);
    const ImportedModel m = importFile(folder / "there.obj");
    EXPECT_EQ(all(m.report), "");
    EXPECT_EQ(test::materialNamed(m.model, "red").diffuse, (Colour{1, 0, 0}));
}

TEST(ImportWarnings, ManyMissingTexturesAreOneLine) {
    const test::TemporaryFolder folder;
    std::string materials, faces;
    for (char name = 'a'; name <= 'h'; ++name) {
        materials += std::string("newmtl ") + name + "\nmap_Kd " + name + ".png\n";
        faces += std::string("usemtl ") + name + "\nf 1 2 3\n";
    }
    test::writeText(folder / "m.mtl", materials);
    test::writeText(folder / "m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" + faces);
    const ImportedModel m = importFile(folder / "m.obj");
    EXPECT_EQ(all(m.report),
              "8 textures are missing, so their materials are plain: 'a.png', 'b.png', 'c.png' and 5 "
              "more\n");
}

TEST(ImportWarnings, TexturesThatLieInDifferentWaysAreNamed) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl sign\nf 1 2 3\n");
    test::writeText(folder / "m.mtl", "newmtl sign\nmap_Kd no.png\nmap_Ke -s 2 2 1 no.png\n");
    expectWarning(importFile(folder / "m.obj").report,
                  "the textures of material 'sign' lie on it in different");
    test::writeText(folder / "m.mtl", "newmtl sign\nmap_Kd no.png\nmap_Ke no.png\n");
    EXPECT_EQ(importFile(folder / "m.obj").report.warnings.size(), 1U) << "only the missing image";
}

TEST(ImportWarnings, ExtensionsThatMatterAreNamed) {
    GltfScene scene;
    scene.more =
        R"(,"extensionsUsed":["KHR_materials_iridescence","KHR_materials_ior","KHR_xmp","KHR_materials_sheen"])";
    expectWarning(importText("t.gltf", scene.text()).report,
                  "ignored, since not supported: 'KHR_materials_iridescence' and 'KHR_materials_sheen'");
}

TEST(ImportWarnings, CoatsThatVaryAreSaidToBeEven) {
    GltfScene scene;
    scene.material = R"({"name":"car","extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":0.75,
"clearcoatRoughnessFactor":0.25}}})";
    const auto varnished = importText("t.gltf", scene.text());
    EXPECT_EQ(all(varnished.report), "");
    EXPECT_EQ(varnished.model.materials[0].coat, 0.75F);
    EXPECT_EQ(varnished.model.materials[0].coatRoughness, 0.25F);
    scene.material.insert(scene.material.find("\"clearcoatF"), R"("clearcoatNormalTexture":{"index":0},)");
    scene.more = R"(,"textures":[{"source":0}],"images":[{"uri":"no.png"}])";
    expectWarning(importText("t.gltf", scene.text()).report, "the coat of varnish of material 'car' is even");
}

TEST(ImportWarnings, AModelThatCannotBeSeenIsSaidToBe) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "m.mtl", "newmtl clear\nd 0\nNi 1.5\nillum 4\n");
    test::writeText(folder / "m.obj", std::string("mtllib m.mtl\nusemtl clear\n") + test::kCubeObj);
    EXPECT_EQ(all(importFile(folder / "m.obj").report), "") << "glass is seen";
    const std::string mesh =
        R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset><library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert>
<transparency><float>0</float></transparency></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">-1 0 -1 1 0 -1 0 0 1</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1" material="s"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="a"><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
    expectWarning(importText("m.dae", mesh).report, "every material is fully transparent");
}

TEST(ImportWarnings, AFileOfLightsAloneHoldsNoTriangles) {
    const std::string dae =
        R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset><library_lights><light id="l"><technique_common><point><color>1 1 1</color></point></technique_common></light></library_lights>
<library_visual_scenes><visual_scene id="s"><node id="n"><translate>0 3 0</translate><instance_light url="#l"/></node>
<node id="o"><translate>0 3 5</translate></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
    EXPECT_NE(refusalOf("m.dae", dae).find("it holds no triangles"), std::string::npos)
        << refusalOf("m.dae", dae);
}

TEST(ImportWarnings, WhatAssimpPassesOverInColladaIsNamed) {
    const auto dae = [](const std::string& wrap, const std::string& camera) {
        return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset><library_cameras><camera id="c"><optics><technique_common>)" +
               camera + R"(</technique_common></optics></camera></library_cameras>
<library_effects><effect id="e"><profile_COMMON><newparam sid="t"><sampler2D><source>s</source>)" +
               wrap +
               R"(</sampler2D></newparam><technique sid="t"><lambert/></technique></profile_COMMON></effect></library_effects>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">-1 0 -1 1 0 -1 0 0 1</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="a"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
    };
    const std::string usual = "<perspective><xfov>49</xfov><znear>0.1</znear><zfar>9</zfar></perspective>";
    EXPECT_EQ(all(importText("m.dae", dae("<wrap_s>WRAP</wrap_s>", usual)).report), "");
    expectWarning(importText("m.dae", dae("<wrap_t>MIRROR</wrap_t>", usual)).report, "repeat instead");
    expectWarning(
        importText("m.DAE",
                   dae("", "<orthographic><xmag>2</xmag><znear>0.1</znear><zfar>9</zfar></orthographic>"))
            .report,
        "orthographic cameras of this Collada file");
}

TEST(ImportWarnings, AMissingBufferIsAskedFor) {
    std::string text = GltfScene{}.text();
    const std::size_t begin = text.find("data:"), end = text.find('"', begin);
    text.replace(begin, end - begin, "shapes/box0.bin");
    const std::string said = refusalOf("box.gltf", text);
    EXPECT_NE(
        said.find("its geometry is in 'shapes/box0.bin', which is missing; put it beside the model's file"),
        std::string::npos)
        << said;
    EXPECT_EQ(said.find("damaged"), std::string::npos) << said;
}

TEST(ImportSizes, ModelsTooSmallToBeTracedAreRefused) {
    const auto cube = [](const std::string& size) {
        const std::string text = test::kCubeObj;
        const std::size_t faces = text.find('f');
        std::string scaled;
        for (const char c : text.substr(0, faces)) scaled += c == '1' ? size : std::string(1, c);
        return scaled + text.substr(faces);
    };
    for (const char* size : {"1e-38", "1e-41", "1e-30", "1e-20", "1e-13"}) {
        const std::string said = refusalOf("cube.obj", cube(size));
        EXPECT_NE(said.find("units large, too small to be traced"), std::string::npos)
            << size << ": " << said;
    }
    const ImportedModel small = importText("cube.obj", cube("1e-12"));
    EXPECT_EQ(small.model.mesh.triangles.size(), 12U);
    EXPECT_EQ(all(small.report), "");
}

TEST(ImportSizes, TracesOfCoordinatesAreZero) {
    const Model m = importText("t.obj", "v 1e-39 -3e-31 0\nv 1 0 1e-42\nv 0 1 2e-30\nf 1 2 3\n").model;
    EXPECT_EQ(m.mesh.position(0, 0), (Vec3{0, 0, 0}));
    EXPECT_EQ(m.mesh.position(0, 1), (Vec3{1, 0, 0}));
    EXPECT_EQ(m.mesh.position(0, 2), (Vec3{0, 1, 2e-30F}));
}

TEST(ImportSizes, VerticesOfNoTriangleDoNotCount) {
    const ImportedModel m = importText("m.obj", std::string(test::kCubeObj) + "v 1e12 0 0\nv 0 nan 0\n");
    EXPECT_EQ(m.model.mesh.vertices.size(), 8U);
    EXPECT_EQ(m.model.mesh.bounds(), (Box3{{-1, -1, -1}, {1, 1, 1}}));
    EXPECT_EQ(all(m.report), "");
}

TEST(ImportSizes, AVertexFarBeyondAllOthersIsSaidToBe) {
    std::string grid;
    for (int i = 0; i < 30; ++i) grid += "v " + std::to_string(i % 6) + " " + std::to_string(i / 6) + " 0\n";
    for (int i = 1; i < 24; ++i)
        grid += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 6) + "\n";
    EXPECT_EQ(all(importText("m.obj", grid).report), "");
    expectWarning(importText("m.obj", grid + "v 1e12 0 0\nf 1 8 31\n").report,
                  "too small to be seen beside them");
}

} // namespace

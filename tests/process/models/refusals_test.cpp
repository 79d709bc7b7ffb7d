/// Files that are not read: what they are, and what to do; and no word of damage where there is none.
#include "process/models/quads_file.h"

#include <cstdlib>

namespace {

using test::metallicRoughness;
using test::QuadsFile;
using namespace std::string_literals;

class Refusals : public test::SeenFiles {
  protected:
    std::string refusal(const std::string& name, const std::string& bytes) {
        test::writeText(folder / name, bytes);
        return refusalOf(folder / name);
    }
    std::string refusalOf(const std::filesystem::path& model) {
        const test::ProgramResult result =
            test::renderer({model.string(), "-w", "8", "-h", "8", "-o", (folder / "x.png").string()});
        EXPECT_EQ(result.exitCode, 65) << model << ": " << result.error;
        EXPECT_FALSE(std::filesystem::exists(folder / "x.png"));
        return result.error;
    }
    void expectSays(const std::string& said, const std::string& what, const std::string& remedy) {
        EXPECT_NE(said.find(what), std::string::npos) << said << "\nshould say: " << what;
        EXPECT_NE(said.find(remedy), std::string::npos) << said << "\nshould say: " << remedy;
        EXPECT_EQ(said.find("damaged"), std::string::npos) << said;
    }
};

std::string step(const std::string& schema) {
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('a'),'2;1');\nFILE_NAME('a','',(''),(''),'','','');\n"
           "FILE_SCHEMA(('" +
           schema + "'));\nENDSEC;\nDATA;\n#1=X();\nENDSEC;\nEND-ISO-10303-21;\n";
}

std::string fbxHead(unsigned version) {
    std::string head = "Kaydara FBX Binary  \0\x1A\0"s;
    for (unsigned shift = 0; shift < 32; shift += 8) head += static_cast<char>(version >> shift & 0xFFU);
    return head + std::string(64, '\0');
}

TEST_F(Refusals, SayWhatAFileIs) {
    struct Case {
        const char* name;
        std::string bytes;
        const char *what, *remedy;
    };
    const std::string zip = "PK\x03\x04"s + std::string(26, '\0');
    const Case cases[] = {
        {"part.step", step("AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }"), "STEP file of CAD surfaces",
         "export it as STL"},
        {"part.stp", "\n" + step("CONFIG_CONTROL_DESIGN"), "STEP file of CAD surfaces", "glTF"},
        {"house.ifc", step("IFC4"), "a building in IFC4,", "export it as IFC2x3"},
        {"road.ifc", step("IFC4X3_ADD2"), "IFC4X3_ADD2", "export it as IFC2x3"},
        {"a.zip", zip + "model.obj", "zip archive", "unpack it"},
        {"a.amf", zip + "model.amf", "zip archive", "unpack it"},
        {"chair.usdz", zip + "chair.usdc", "USDZ", "glTF"},
        {"chair.zip", zip + "chair.usda", "USDZ", "glTF"},
        {"chair.3mf", "PK\x03\x04"s + std::string(22, '\0') + "\x09\0\0\0"s + "CHAIR.USD" + "\x01\x02",
         "USDZ", "Blender"},
        {"chair", zip + "0/chair.usdc", "USDZ", "OBJ"},
        {"a.glb", "PXR-USDC\0\x8"s, "USD file", "glTF"},
        {"part.FCStd", zip + "Document.xml", "FreeCAD", "STL"},
        {"box.zip", zip + "3D/3dmodel.model", "3MF", "ends in .3mf"},
        {"scan.ply.gz", "\x1F\x8B\x08\0\0\0\0\0\0\3"s, "packed by gzip", "gunzip"},
        {"scan.ply", "\x1F\x8B\x08\0\0\0\0\0\0\3"s, "packed by gzip", "gunzip"},
        {"a.7z", "7z\xBC\xAF\x27\x1C\0\4"s, "7z archive", "unpack it"},
        {"a.obj", "Rar!\x1A\x07\1\0"s, "RAR archive", "unpack it"},
        {"old.fbx", fbxHead(6100), "FBX file of version 6.1", "2011 or later"},
        {"older.fbx", fbxHead(5800), "FBX file of version 5.8", "glTF"},
        {"text.fbx", "; FBX 6.1.0 project file\nFBXHeaderExtension:  {\n\tFBXVersion: 6100\n}\n",
         "version 6.1", "2011 or later"},
        {"new.blend", "BLENDER-v402RENDH\0\0\0"s, "Blender 4.2", "export it as glTF"},
        {"packed.blend", "\x28\xB5\x2F\xFD\xA0\xF4\4\1"s, "Blender", "export it as glTF"},
        {"a.usda", "#usda 1.0\ndef Xform \"a\" {}\n", "USD file", "glTF"},
        {"a.usd", "PXR-USDC\0\x8"s, "USD file", "glTF"},
        {"a.3dm", "3D Geometry File Format       70", "Rhino", "export it as glTF"},
        {"a.skp", "\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0U\0p\0 \0"s, "SketchUp", "Collada"},
        {"a.rvt", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"s, "Revit", "IFC2x3"},
        {"a.max", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"s, "3ds Max", "FBX"},
        {"a.SLDPRT", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"s, "CAD program", "STL"},
        {"a.dwg", "AC1032\0\0"s, "DWG", "export it as FBX"},
        {"a.las", "LASF\0\0\0\0"s, "point cloud", "make a mesh"},
        {"a.e57", "ASTM-E57\1\0"s, "point cloud", "make a mesh"},
        {"a.pcd", "# .PCD v0.7\nVERSION 0.7\n", "point cloud", "make a mesh"},
        {"a.wrl", "#VRML V2.0 utf8\nShape {}\n", "VRML", "glTF"},
        {"a.igs", std::string(72, ' ') + "S      1\n", "IGES", "STL"},
        {"a.brep", "\nCASCADE Topology V1, (c) Matra-Datavision\n", "BREP", "STL"},
        {"a.glb", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n", "Git LFS",
         "git lfs pull"},
        {"b.glb", "<!DOCTYPE html>\n<html></html>\n", "web page", "download the file itself"},
        {"a.stl", "\x89PNG\r\n\x1A\n"s, "an image", "give a model"},
    };
    for (const Case& c : cases) expectSays(refusal(c.name, c.bytes), c.what, c.remedy);
}

TEST_F(Refusals, SayThatANameDoesNotFit) {
    const std::string gltf = QuadsFile({{0, metallicRoughness("1,1,1,1", 1)}}).text();
    expectSays(refusal("a.obj", gltf), "does not fit its content", "ends in .gltf");
    expectSays(refusal("a.dae", gltf), "does not fit its content", "ends in .gltf");
    expectSays(refusal("a.stl", "glTF\2\0\0\0\x20\0\0\0"s), "does not fit its content", "ends in .glb");
    expectSays(refusal("scene", "glTF\2\0\0\0\x20\0\0\0"s), "does not fit its content", "ends in .glb");
    expectSays(refusal("b.obj", fbxHead(7400)), "does not fit its content", "ends in .fbx");
    expectSays(refusal("c.ply", "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\"></COLLADA>"),
               "does not fit its content", "ends in .dae");
}

TEST_F(Refusals, NameWhatAGltfNeeds) {
    QuadsFile file({{0, metallicRoughness("1,1,1,1", 1)}});
    const auto needs = [&](const std::string& extension) {
        file.more = ",\"extensionsUsed\":[" + extension + "],\"extensionsRequired\":[" + extension + "]";
        return refusal("a.gltf", file.text());
    };
    expectSays(needs("\"KHR_meshopt_compression\""), "it needs KHR_meshopt_compression, which is not read",
               "export without it (gltfpack");
    expectSays(needs("\"KHR_meshopt_compression\",\"KHR_gaussian_splatting\",\"KHR_mesh_quantization\""),
               "it needs KHR_meshopt_compression and KHR_gaussian_splatting, which are", "export without");
    // Extensions that leave positions as they are stop nothing; those that are not read are told.
    const auto opens = [&](const std::string& extensions) {
        file.more = ",\"extensionsRequired\":[" + extensions + "]";
        test::writeText(folder / "a.gltf", file.text());
        return see("a.gltf", "whitted", kStraight).said;
    };
    expectSays(opens("\"KHR_texture_basisu\""), "it needs KHR_texture_basisu, which", "PNG or JPEG");
    expectSays(opens("\"XYZ_something\""), "it needs XYZ_something, which", "export without it");
    const std::string said = opens("\"KHR_texture_transform\",\"KHR_materials_iridescence\"");
    EXPECT_EQ(said.find("needs"), std::string::npos) << said;
}

TEST_F(Refusals, DamageIsNotClaimedForWhatIsNotShown) {
    const auto said = [&](const std::string& scenes) {
        QuadsFile file({{0, metallicRoughness("1,1,1,1", 1)}, {1, metallicRoughness("1,0,0,1", 1)}});
        file.scenes = scenes;
        test::writeText(folder / "a.gltf", file.text());
        return see("a.gltf", "whitted", kStraight).said;
    };
    for (const char* scenes : {"\"scene\":0,\"scenes\":[{\"nodes\":[0]},{\"nodes\":[1]}]",
                               "\"scene\":1,\"scenes\":[{\"nodes\":[0]},{\"nodes\":[1]}]",
                               "\"scenes\":[{\"nodes\":[1]}]", "\"scene\":0,\"scenes\":[{\"nodes\":[0,1]}]"})
        EXPECT_EQ(said(scenes).find("damaged"), std::string::npos) << scenes << ": " << said(scenes);
}

std::string number(std::uint32_t value) {
    std::string bytes;
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFFU);
    return bytes;
}

/// A whole binary glTF of one triangle.
class Glb {
  public:
    std::uint32_t version = 2;
    std::string json =
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"buffers\":[{\"byteLength\":36}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,"
        "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,0]}]}";

    std::string bytes() const {
        std::string text = json;
        while (text.size() % 4 != 0) text += ' ';
        const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        const std::string binary(reinterpret_cast<const char*>(corners), sizeof corners);
        const std::string chunks = number(static_cast<std::uint32_t>(text.size())) + "JSON" + text +
                                   number(static_cast<std::uint32_t>(binary.size())) + "BIN\0"s + binary;
        return "glTF" + number(version) + number(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
    }
};

TEST_F(Refusals, SayThatABinaryGltfIsCutOff) {
    const std::string whole = Glb().bytes();
    const std::size_t json = whole.find("BIN") - 4, binary = json + 8;
    for (const std::size_t size : {std::size_t{12}, std::size_t{15}, std::size_t{20}, json / 2, json,
                                   json + 4, binary, binary + 20, whole.size() - 1}) {
        const std::string said = refusal("a.glb", whole.substr(0, size));
        EXPECT_NE(said.find("it is cut off: " + std::to_string(size) + " of at least " +
                            std::to_string(whole.size()) + " bytes are there; copy it again"),
                  std::string::npos)
            << said;
    }
    expectSays(refusal("a.glb", whole.substr(0, 6)), "it is cut off: 6 of at least 20 bytes",
               "copy it again");
}

TEST_F(Refusals, SayWhereAGltfIsWrong) {
    const auto says = [&](const std::string& name, const std::string& bytes, const std::string& what) {
        const std::string said = refusal(name, bytes);
        EXPECT_NE(said.find(what), std::string::npos) << said << "\nshould say: " << what;
    };
    const std::string text = QuadsFile({{0, metallicRoughness("1,1,1,1", 1)}}).text();
    const std::string third = std::to_string(text.size() / 3);
    says("a.gltf", text.substr(0, text.size() / 3),
         "it is cut off: its JSON does not end within " + third + " bytes; copy it again");
    says("a.gltf", "{\"asset\": {]", "its JSON is damaged at byte 12;");
    says("a.gltf", "{\"asset\": {\"version\": \"3.0\"}}", "it is glTF 3.0, which is not read");
    says("a.gltf", "{\"asset\": {}}", "does not say which version of glTF it is");
    Glb glb;
    std::string bytes = glb.bytes();
    says("a.glb", std::string(bytes).replace(12, 4, number(100)), "its JSON is damaged at byte 121;");
    says("a.glb", std::string(bytes).replace(12, 4, number(100'000)), "first chunk is longer than the file");
    says("a.glb", std::string(bytes).replace(16, 4, "BIN\0"s), "first chunk holds no JSON");
    glb.version = 1;
    says("a.glb", glb.bytes(), "it is glTF 1 in a binary file, which is not read; export it as glTF 2.0");
    // A wrong sum of right lengths harms nothing.
    test::writeText(folder / "a.glb", bytes.replace(8, 4, number(100'000)));
    EXPECT_EQ(see("a.glb", "whitted", kStraight).said.find("cut off"), std::string::npos);
}

TEST_F(Refusals, SayThatAFileIsCutOff) {
    const std::string half = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0";
    const std::string fbx =
        "Kaydara FBX Binary  \0\x1A\0"s + number(7400) + number(900) + std::string(40, '\0');
    const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                            "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
                            "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    struct Case {
        const char* name;
        std::string bytes, what;
    };
    const Case cases[] = {
        {"a.stl", std::string(80, ' ') + number(10) + std::string(70, '\0'), "154 of at least 584 bytes"},
        {"b.stl", half, "'endsolid' is missing"},
        {"a.3ds", "MM" + number(500) + "\2\0\x0A\0\0\0\3\0\0\0=="s + number(400), "of at least 500 bytes"},
        {"a.fbx", fbx, "71 of at least 913 bytes"},
        {"a.dae", "<?xml version=\"1.0\"?>\n<!-- by <me@home> -->\n<COLLADA version=\"1.4.1\"><asset>",
         "'</COLLADA>' is missing"},
        {"a.3mf", "PK\x03\x04"s + std::string(40, '\0'), "the list of what it holds is missing"},
        {"a.zae", "PK\x03\x04"s + std::string(40, '\0'), "the list of what it holds is missing"},
        {"a.ifc", step("IFC2X3").substr(0, 150), "'END-ISO-10303-21' is missing"},
        {"a.blend", "BLENDER-v248REND" + number(1000), "'ENDB' is missing"},
    };
    for (const Case& c : cases) {
        const std::string said = refusal(c.name, c.bytes);
        EXPECT_NE(said.find("it is cut off: "), std::string::npos) << c.name << ": " << said;
        EXPECT_NE(said.find(c.what), std::string::npos) << said << "\nshould say: " << c.what;
        EXPECT_NE(said.find("; copy it again"), std::string::npos) << said;
    }
    const std::string said = refusal("a.ply", ply);
    EXPECT_NE(said.find("it ends after 1 of the 2 elements 'face' that its head promises"), std::string::npos)
        << said;
}

TEST_F(Refusals, WhatIsLeftOfAFileIsShownWithAWarning) {
    const std::string bones = "version 1\nnodes\n0 \"root\" -1\nend\nskeleton\ntime 0\n0 0 0 0 0 0 0\nend\n";
    const std::string triangle = "a.bmp\n0 0 0 0 0 0 1 0 0\n0 1 0 0 0 0 1 1 0\n0 0 1 0 0 0 1 0 1\n";
    const auto said = [&](const std::string& end) {
        test::writeText(folder / "a.smd", bones + "triangles\n" + triangle + triangle + end);
        return see("a.smd", "whitted", kStraight).said;
    };
    EXPECT_NE(said("").find("it is cut off: 'end' is missing at its end; copy it again"), std::string::npos);
    EXPECT_EQ(said("end\n").find("cut off"), std::string::npos);
}

TEST_F(Refusals, TheSharedCasesAreRight) {
    const char* const folderOfScenes = std::getenv("RT_TEST_SCENES");
    if (folderOfScenes == nullptr ||
        !std::filesystem::exists(std::filesystem::path(folderOfScenes) / "field3"))
        GTEST_SKIP() << "RT_TEST_SCENES is not set";
    const std::filesystem::path scenes = folderOfScenes;
    expectSays(refusalOf(scenes / "field3/cad/cad.step"), "STEP file of CAD surfaces", "glTF");
    expectSays(refusalOf(scenes / "field3/cad/ifc4_min.ifc"), "IFC4", "IFC2x3");
}

} // namespace

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
    expectSays(needs("\"KHR_mesh_quantization\""), "it needs KHR_mesh_quantization, which is not read",
               "gltfpack -noq");
    expectSays(needs("\"EXT_meshopt_compression\""), "it needs EXT_meshopt_compression, which",
               "export without it (gltfpack");
    expectSays(needs("\"EXT_meshopt_compression\",\"KHR_mesh_quantization\""),
               "it needs EXT_meshopt_compression and KHR_mesh_quantization, which are", "export without");
    // What is read, or does not say how positions are stored, stops nothing, and is told.
    const auto opens = [&](const std::string& extensions) {
        file.more = ",\"extensionsRequired\":[" + extensions + "]";
        test::writeText(folder / "a.gltf", file.text());
        return see("a.gltf", "whitted", kStraight).said;
    };
    expectSays(opens("\"KHR_texture_basisu\""), "it needs KHR_texture_basisu, which", "PNG or JPEG");
    expectSays(opens("\"XYZ_something\""), "it needs XYZ_something, which", "export without it");
    const std::string said = opens("\"KHR_texture_transform\",\"KHR_materials_clearcoat\"");
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

TEST_F(Refusals, TheSharedCasesAreRight) {
    const char* const folderOfScenes = std::getenv("RT_TEST_SCENES");
    if (folderOfScenes == nullptr ||
        !std::filesystem::exists(std::filesystem::path(folderOfScenes) / "field3"))
        GTEST_SKIP() << "RT_TEST_SCENES is not set";
    const std::filesystem::path scenes = folderOfScenes;
    expectSays(refusalOf(scenes / "field3/cad/cad.step"), "STEP file of CAD surfaces", "glTF");
    expectSays(refusalOf(scenes / "field3/cad/ifc4_min.ifc"), "IFC4", "IFC2x3");
    expectSays(refusalOf(scenes / "field3/gltf/meshopt/meshopt-no-fallback.gltf"), "EXT_meshopt_compression",
               "without");
    expectSays(refusalOf(scenes / "field3/gltf/short.gltf"), "KHR_mesh_quantization", "-noq");
    expectSays(refusalOf(scenes / "truth3/quantization.glb"), "KHR_mesh_quantization", "-noq");
}

} // namespace

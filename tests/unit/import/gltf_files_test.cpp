/// glTF files as a whole: containers, buffers, compression, needs, lights; and damaged ones.
#include "rtcore/io/import/gltf/data_uri.h"
#include "support/damaged_text.h"
#include "unit/import/gltf_builder.h"

#ifdef RT_HAVE_MESHOPT
#include <meshoptimizer.h>
#endif

namespace {

using namespace rtcore;
using test::GltfBuilder;
using test::Json;
using test::meshOf;

void expectFound(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text << "\nshould have: " << part;
}

TEST(GltfContainer, ChunksOfAnyLengthAreFound) {
    const GltfBuilder file = test::squareFile();
    Json whole = file.root;
    whole["buffers"] = {{{"byteLength", file.bytes.size()}}};
    const std::string json = whole.dump();
    for (std::size_t blanks = 0; blanks < 4; ++blanks) {
        const std::string text = json + std::string(blanks, ' ');
        EXPECT_EQ(GltfBuilder::importBytes("m.glb", GltfBuilder::container(text, file.bytes, false))
                      .model.triangles.size(),
                  2U)
            << text.size() % 4;
    }
    const std::string zeros = json + std::string((4 - json.size() % 4) % 4 + 4, '\0');
    EXPECT_EQ(GltfBuilder::importBytes("m.VRM", GltfBuilder::container(zeros, file.bytes)).model.parts.size(),
              1U);
    EXPECT_FALSE(importGltf("/nowhere/m.glb", {}));
    EXPECT_EQ(GltfBuilder::importBytes("model", GltfBuilder::container(json, file.bytes)).model.parts.size(),
              1U)
        << "content tells what a name does not";
}

TEST(GltfContainer, NamesThatAreNoUtf8DoNotStopIt) {
    GltfBuilder file = test::squareFile();
    file.root["nodes"][0]["name"] = "Gr#n";
    file.node({{"name", "b"}});
    Json whole = file.root;
    whole["buffers"] = {{{"byteLength", file.bytes.size()}}};
    std::string json = whole.dump();
    json[json.find("Gr#n") + 2] = '\xFC'; // of Latin-1
    const FileImport read = GltfBuilder::importBytes("m.glb", GltfBuilder::container(json, file.bytes));
    EXPECT_EQ(std::string(read.model.strings.data() + read.model.parts[0].nameOffset), "Gr\xC3\xBCn");
}

TEST(GltfBuffers, AreFoundByTheirDecodedNames) {
    const test::TemporaryFolder folder;
    const GltfBuilder file = test::squareFile();
    Json whole = file.root;
    whole["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", "my%20b%C3%B6x.bin"}}};
    test::writeText(folder / "m.gltf", whole.dump());
    try {
        importGltf(folder / "m.gltf", {});
        ADD_FAILURE() << "its buffer is missing";
    } catch (const std::exception& error) {
        expectFound(error.what(), "its geometry is in 'my b\xC3\xB6x.bin', which is missing");
    }
    test::writeText(folder / "my b\xC3\xB6x.bin", file.bytes);
    const auto read = importGltf(folder / "m.gltf", {});
    ASSERT_TRUE(read);
    EXPECT_EQ(read->model.triangles.size(), 2U);
    ASSERT_EQ(read->report.files.size(), 2U);
    expectFound(read->report.files[1], "my b\xC3\xB6x.bin");
}

TEST(GltfBuffers, BytesInUrisAreDecoded) {
    const auto text = [](const char* uri) {
        std::string read;
        for (const std::byte b : gltf::bytesOfDataUri(uri)) read += static_cast<char>(b);
        return read;
    };
    EXPECT_EQ(text("data:application/octet-stream;base64,SGVsbG8="), "Hello");
    EXPECT_EQ(text("data:;base64,SGVs\nbG8"), "Hello");
    EXPECT_EQ(text("data:text/plain,a%20b"), "a b");
    EXPECT_EQ(text("data:;base64,S*GVs"), "") << "up to what does not belong there";
    EXPECT_EQ(text("data:"), "");
}

#ifdef RT_HAVE_MESHOPT
TEST(GltfMeshopt, IsDecoded) {
    GltfBuilder file;
    std::string code(meshopt_encodeVertexBufferBound(4, 12), '\0');
    code.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(code.data()), code.size(),
                                           test::kSquare.data(), 4, 12));
    const std::vector<std::uint32_t> corners{0, 1, 2, 0, 2, 3};
    std::string order(meshopt_encodeIndexBufferBound(6, 4), '\0');
    order.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(order.data()), order.size(),
                                           corners.data(), 6));
    const auto packed = [&](const std::string& bytes, const char* mode, int count, int stride) {
        const int view = file.view(bytes);
        Json& stated = file.root["bufferViews"][static_cast<std::size_t>(view)];
        Json extension{{"buffer", 0},
                       {"byteOffset", stated["byteOffset"]},
                       {"byteLength", bytes.size()},
                       {"byteStride", stride},
                       {"count", count},
                       {"mode", mode}};
        stated = {{"buffer", 1},
                  {"byteLength", count * stride},
                  {"extensions", {{"EXT_meshopt_compression", extension}}}};
        return view;
    };
    const int positions = file.accessor(Json{{"bufferView", packed(code, "ATTRIBUTES", 4, 12)},
                                             {"componentType", 5126},
                                             {"count", 4},
                                             {"type", "VEC3"}});
    const int indices = file.accessor(Json{{"bufferView", packed(order, "TRIANGLES", 6, 4)},
                                           {"componentType", 5125},
                                           {"count", 6},
                                           {"type", "SCALAR"}});
    file.show({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
    file.root["extensionsRequired"] = {"EXT_meshopt_compression"};
    const FileImport read = file.import();
    ASSERT_EQ(read.model.triangles.size(), 2U);
    EXPECT_EQ(test::areaOf(meshOf(read.model)), 1) << "whatever corner its triangles begin with";

    // A view that stands for more than its code could is refused before memory goes.
    Json& extension = file.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
    extension["count"] = 4'000'000'000U;
    file.root["accessors"][0]["count"] = 4'000'000'000U;
    EXPECT_NE(test::refusalOf(file), "");
}
#endif

TEST(GltfNeeds, AreSaidFirstWithTheRemedy) {
    GltfBuilder file = test::squareFile();
    file.root["extensionsRequired"] = {"KHR_meshopt_compression", "XYZ_b"};
    expectFound(test::refusalOf(file), "it needs KHR_meshopt_compression and XYZ_b, which are not read");
    file.root["extensionsRequired"] = {"XYZ_b"};
    expectFound(test::warningsOf(file.import()), "it needs XYZ_b, which is not read; export without it");
    file.root["extensionsRequired"] = {"KHR_materials_sheen"};
    file.root["extensionsUsed"] = {"KHR_materials_sheen", "KHR_materials_specular", "XYZ_c"};
    const std::string said = test::warningsOf(file.import());
    expectFound(said, "ignored, since not supported: 'KHR_materials_sheen' and 'XYZ_c'; lost: the sheen");
}

TEST(GltfNeeds, ImagesOfOtherFormatsAreNoneWhereOthersStandBesideThem) {
    GltfBuilder file = test::squareFile();
    file.root["extensionsUsed"] = {"KHR_texture_basisu"};
    file.root["textures"] = {{{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}};
    expectFound(test::warningsOf(file.import()), "'KHR_texture_basisu'; lost: images of Basis Universal");
    file.root["textures"][0]["source"] = 1;
    EXPECT_EQ(test::warningsOf(file.import()), "");
    file.root["extensionsRequired"] = {"KHR_texture_basisu"};
    expectFound(test::warningsOf(file.import()), "it needs KHR_texture_basisu");
}

TEST(GltfMaterials, SpecularScalesTheReflectance) {
    GltfBuilder file = test::squareFile();
    file.root["meshes"][0]["primitives"][0]["material"] = 0;
    file.root["materials"] = {
        {{"pbrMetallicRoughness", {{"metallicFactor", 0}}},
         {"extensions",
          {{"KHR_materials_ior", {{"ior", 3}}},
           {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 2, 8}}}}}}}};
    const FileImport read = file.import();
    EXPECT_TRUE(test::near(read.model.materials[0].specular, {0.125F, 0.25F, 0.5F}));
}

TEST(GltfMaterials, AttenuationNeedsAThicknessAndADistance) {
    GltfBuilder file = test::squareFile();
    file.root["meshes"][0]["primitives"][0]["material"] = 0;
    const auto glass = [&](const Json& volume) {
        file.root["materials"] = {{{"pbrMetallicRoughness", {{"metallicFactor", 0}}},
                                   {"extensions",
                                    {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                                     {"KHR_materials_volume", volume}}}}};
        return file.import().model.materials[0];
    };
    const Json red{1, 0.5, 0.25};
    const Material volume =
        glass({{"thicknessFactor", 1}, {"attenuationDistance", 2}, {"attenuationColor", red}});
    EXPECT_EQ(volume.attenuationDistance, 2);
    EXPECT_EQ(volume.transmission, (Colour{1, 0.5F, 0.25F}));
    EXPECT_EQ(glass({{"thicknessFactor", 1}, {"attenuationColor", red}}).transmission, kWhite);
    EXPECT_EQ(glass({{"attenuationDistance", 2}, {"attenuationColor", red}}).transmission, kWhite);
}

TEST(GltfLightsOfNodes, OneDefinitionMayStandManyTimes) {
    GltfBuilder file = test::squareFile();
    file.root["extensions"] = {{"KHR_lights_punctual", {{"lights", {{{"type", "point"}}, {{"type", "x"}}}}}}};
    const auto lamp = [&](int light, float x) {
        file.node(
            {{"translation", {x, 0, 0}}, {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
    };
    lamp(0, 1);
    lamp(0, 2);
    lamp(1, 3);
    file.node(
        {{"extensions", {{"EXT_lights_ies", {{"light", 0}, {"multiplier", 5}, {"color", {1, 0.5, 0}}}}}}});
    const FileImport read = file.import();
    ASSERT_EQ(read.model.lights.size(), 3U);
    EXPECT_EQ(read.model.lights[1].position, (Vec3{2, 0, 0}));
    EXPECT_EQ(read.model.lights[2].intensity, (Colour{5, 2.5F, 0}));
    expectFound(test::warningsOf(read), "is left out");
    expectFound(test::warningsOf(read), "shine to all sides alike");
}

/// Any bytes give a model or a reason, and nothing else happens.
TEST(GltfMutation, FilesAreReadOrRefused) {
    GltfBuilder rich = test::squareFile();
    Json& primitive = rich.root["meshes"][0]["primitives"][0];
    primitive["targets"] = {{{"POSITION", 0}}};
    primitive["attributes"]["COLOR_0"] = rich.accessor(std::vector<std::uint8_t>(16, 200), "VEC4", true);
    primitive["attributes"]["JOINTS_0"] = rich.accessor(std::vector<std::uint8_t>(16, 0), "VEC4");
    primitive["attributes"]["WEIGHTS_0"] = rich.accessor(std::vector<std::uint8_t>(16, 99), "VEC4", true);
    primitive["material"] = 0;
    rich.root["materials"] = {{{"alphaMode", "BLEND"},
                               {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}},
                               {"extensions", {{"KHR_materials_unlit", Json::object()}}}}};
    rich.root["textures"] = {{{"source", 0}, {"sampler", 0}}};
    rich.root["images"] = {{{"bufferView", 0}, {"mimeType", "image/png"}}};
    rich.root["skins"] = {{{"joints", {0, 1}}}};
    rich.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}}}}};
    rich.root["nodes"][0]["skin"] = 0;
    rich.node({{"camera", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
    rich.root["meshes"][0]["weights"] = {0.5};
    rich.root["extensions"] = {
        {"EXT_lights_ies",
         {{"lights",
           {{{"bufferView", rich.view("IESNA91\nTILT=NONE\n1 -1 1 2 2 1 1 0 0 0\n1 1 9\n"
                                      "0 90\n0 90\n100 50 40 3\n")}}}}}}};
    rich.node({{"extensions", {{"EXT_lights_ies", {{"light", 0}, {"multiplier", 2}}}}}});
    const test::TemporaryFolder folder;
    test::GltfScene scene;
    scene.colours = true;
    test::DamagedText damaged({rich.binary(), scene.text(), scene.binary()}, test::kJsonTokens, 8);
    FileImportOptions options;
    options.memoryLimit = 200'000'000;
    long read = 0, refused = 0;
    for (long i = 0; i < test::damagedTexts(); ++i) {
        test::writeText(folder / "a.glb", damaged.next());
        try {
            read += importGltf(folder / "a.glb", options) ? 1 : 0;
        } catch (const std::runtime_error&) {
            ++refused;
        }
    }
    EXPECT_GT(read, 0);
    EXPECT_GT(refused, 0);
}

} // namespace

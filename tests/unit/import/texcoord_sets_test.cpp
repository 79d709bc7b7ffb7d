// Images of one material that lie on a surface in ways of their own: each use has its set and its transform.
#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/images/image_file.h"
#include "rtcore/scene/sky_ground.h"
#include "rtcore/shading/surface/surface.h"

#include "unit/import/gltf_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace {

using namespace rtcore;

/// 4 x 4 texels, each of its own colour; alpha is full.
LdrImage chequers() {
    LdrImage image(4, 4);
    for (int i = 0; i < 16; ++i)
        image.pixels[static_cast<std::size_t>(i)] = {static_cast<std::uint8_t>(16 * i),
                                                     static_cast<std::uint8_t>(255 - 16 * i),
                                                     static_cast<std::uint8_t>(i % 4 * 80), 255};
    return image;
}

/// That of the file's coordinates, which repeat: (0, 0) is the upper left corner.
Rgba8 texelAt(float u, float v) {
    const auto cell = [](float t) { return static_cast<std::size_t>(std::floor((t - std::floor(t)) * 4)); };
    return chequers().pixels[cell(v) * 4 + cell(u)];
}

Colour lightOf(Rgba8 t) {
    const auto linear = [](std::uint8_t code) { return srgbDecode(static_cast<float>(code) / 255); };
    return {linear(t.r), linear(t.g), linear(t.b)};
}

/// The square (0 0 0) (1 1 0) with set 0 (x, 1 - y) and set 1 (y / 2, x / 2 + 1 / 4), of one material.
test::GltfBuilder file(const test::Json& material) {
    test::GltfBuilder made;
    const int positions = made.accessor(test::kSquare, "VEC3"),
              corners = made.accessor(test::kSquareCorners, "SCALAR");
    const int first = made.accessor<float>({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
    const int second = made.accessor<float>({0, 0.25F, 0, 0.75F, 0.5F, 0.75F, 0.5F, 0.25F}, "VEC2");
    made.show({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", first}, {"TEXCOORD_1", second}}},
               {"indices", corners},
               {"material", 0}});
    const std::vector<std::byte> png = encodeImage(chequers(), "png");
    const int view = made.view({reinterpret_cast<const char*>(png.data()), png.size()});
    made.root["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
    made.root["samplers"] = {{{"magFilter", 9728}}};
    made.root["textures"] = {{{"source", 0}, {"sampler", 0}}};
    made.root["materials"] = {material};
    return made;
}

test::Json lying(int set, const test::Json& transform = {}) {
    test::Json use = {{"index", 0}, {"texCoord", set}};
    if (!transform.is_null()) use["extensions"] = {{"KHR_texture_transform", transform}};
    return use;
}

Scene sceneOf(const Model& model) {
    Scene scene;
    scene.model = model;
    scene.materials.assign(model.materials.begin(), model.materials.end());
    return scene;
}

/// At (x, y) of the square: its first triangle is (0 0) (1 0) (1 1), the second (0 0) (1 1) (0 1).
Hit hitAt(float x, float y) {
    Hit hit;
    hit.triangle = x >= y ? 0 : 1;
    hit.u = x >= y ? x - y : x;
    hit.v = x >= y ? y : y - x;
    return hit;
}

void forPoints(const std::function<void(float x, float y)>& use) {
    for (const float x : {0.07F, 0.31F, 0.55F, 0.81F})
        for (const float y : {0.11F, 0.44F, 0.68F, 0.93F}) use(x, y);
}

void expectColour(Colour seen, Colour wanted, float x, float y) {
    EXPECT_TRUE(test::near(seen, wanted))
        << "at " << x << " " << y << ": " << seen.r << " " << seen.g << " " << seen.b << " and not "
        << wanted.r << " " << wanted.g << " " << wanted.b;
}

const test::Json kTurned = {
    {"offset", {0.25, 0.125}}, {"scale", {2, 0.5}}, {"rotation", std::numbers::pi / 2}};

/// What the format says of kTurned: rotation is counter-clockwise where v points up.
Vec2 turned(float u, float v) { return {v * 0.5F + 0.25F, -u * 2 + 0.125F}; }

const test::Json kTwoWays = {
    {"pbrMetallicRoughness", {{"baseColorTexture", lying(0)}, {"metallicFactor", 0}}},
    {"emissiveFactor", {1, 1, 1}},
    {"emissiveTexture", lying(1, kTurned)}};

TEST(TexcoordSets, EachImageLiesBySetAndTransformOfItsUse) {
    const FileImport import = file(kTwoWays).import();
    EXPECT_EQ(test::warningsOf(import), "");
    const Scene scene = sceneOf(makeModel(import.model));
    ASSERT_EQ(scene.model.mesh.furtherSets(), 1U);
    forPoints([&](float x, float y) {
        const Surface s = surfaceAt(scene, true, {0, 0, -1}, hitAt(x, y));
        const Vec2 second = turned(y / 2, x / 2 + 0.25F);
        expectColour(s.diffuse, lightOf(texelAt(x, 1 - y)), x, y);
        expectColour(s.emission, lightOf(texelAt(second.x, second.y)), x, y);
        expectColour(emissionAt(scene, true, hitAt(x, y)), lightOf(texelAt(second.x, second.y)), x, y);
    });
}

TEST(TexcoordSets, RoughnessMetalAndGlassHaveTheirOwn) {
    const test::Json material = {
        {"pbrMetallicRoughness",
         {{"baseColorTexture", lying(1)}, {"metallicRoughnessTexture", lying(0, {{"scale", {3, 1}}})}}},
        {"extensions",
         {{"KHR_materials_transmission",
           {{"transmissionFactor", 1}, {"transmissionTexture", lying(0, {{"offset", {0.5, 0}}})}}}}}};
    const Scene scene = sceneOf(makeModel(file(material).import().model));
    ASSERT_EQ(scene.model.mesh.furtherSets(), 2U);
    forPoints([&](float x, float y) {
        expectColour(diffuseAt(scene, true, hitAt(x, y)), lightOf(texelAt(y / 2, x / 2 + 0.25F)), x, y);
        const RoughnessFactors factors = roughnessAt(scene, hitAt(x, y));
        const Rgba8 rough = texelAt(3 * x, 1 - y), passing = texelAt(x + 0.5F, 1 - y);
        EXPECT_NEAR(factors.roughness, static_cast<float>(rough.g) / 255, 1e-5) << x << " " << y;
        EXPECT_NEAR(factors.metallic, static_cast<float>(rough.b) / 255, 1e-5) << x << " " << y;
        const float opacity = scene.materials[0].opacity;
        EXPECT_NEAR(opacityAt(scene, true, hitAt(x, y)),
                    1 - (1 - opacity) * static_cast<float>(passing.r) / 255, 1e-5)
            << x << " " << y;
    });
}

/// A normal that leans to the right of the image stands upright on the surface where that is turned.
TEST(TexcoordSets, NormalsLeanAsTheirImageLies) {
    test::GltfBuilder made =
        file({{"pbrMetallicRoughness", {{"baseColorTexture", lying(0)}, {"metallicFactor", 0}}},
              {"normalTexture", {{"index", 1}, {"texCoord", 1}}}});
    LdrImage right(1, 1);
    right.pixels[0] = {218, 128, 218, 255};
    const std::vector<std::byte> png = encodeImage(right, "png");
    const int view = made.view({reinterpret_cast<const char*>(png.data()), png.size()});
    made.root["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    made.root["textures"].push_back({{"source", 1}});
    const Scene scene = sceneOf(makeModel(made.import().model));
    const Vec3 n = surfaceAt(scene, true, {0, 0, -1}, hitAt(0.4F, 0.3F)).shadingNormal;
    EXPECT_NEAR(n.y, std::numbers::sqrt2 / 2, 0.01) << "set 1 grows along y";
    EXPECT_NEAR(n.x, 0, 0.01);
}

TEST(TexcoordSets, HolesLieAsTheBaseColourAndNotAsOtherImages) {
    test::Json material = kTwoWays;
    material["alphaMode"] = "MASK";
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 1}, {"texCoord", 1}};
    test::GltfBuilder made = file(material);
    LdrImage half(2, 1);
    half.pixels = {{255, 255, 255, 255}, {255, 255, 255, 0}};
    const std::vector<std::byte> png = encodeImage(half, "png");
    const int view = made.view({reinterpret_cast<const char*>(png.data()), png.size()});
    made.root["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
    made.root["textures"].push_back({{"source", 1}, {"sampler", 0}});
    const Scene scene = sceneOf(makeModel(made.import().model));
    forPoints([&](float x, float y) {
        const float u = y / 2; // of set 1: the left half
        EXPECT_EQ(coverageAt(scene, true, hitAt(x, y), false), u < 0.5F ? 1 : 0) << x << " " << y;
    });
}

TEST(TexcoordSets, OneWayForAllImagesNeedsNoFurtherSet) {
    test::Json material = kTwoWays;
    material["pbrMetallicRoughness"]["baseColorTexture"] = lying(1, kTurned);
    const FileImport import = file(material).import();
    EXPECT_TRUE(import.model.furtherTexcoords.empty());
    EXPECT_EQ(import.model.textures.size(), 1U);
}

TEST(TexcoordSets, OthersMeshesBesideHaveNoneOfThem) {
    test::GltfBuilder made = file(kTwoWays);
    made.root["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", lying(1)}}}});
    test::Json plain = made.root["meshes"][0]["primitives"][0];
    plain["material"] = 1;
    for (const bool before : {false, true}) {
        test::GltfBuilder both = made;
        test::Json& primitives = both.root["meshes"][0]["primitives"];
        primitives.insert(before ? primitives.begin() : primitives.end(), plain);
        const FileImport import = both.import();
        ASSERT_EQ(import.model.triangles.size(), 4U);
        const Scene scene = sceneOf(makeModel(import.model));
        forPoints([&](float x, float y) {
            Hit two = hitAt(x, y), one = two;
            (before ? two : one).triangle += 2;
            const Vec2 second = turned(y / 2, x / 2 + 0.25F);
            expectColour(diffuseAt(scene, true, two), lightOf(texelAt(x, 1 - y)), x, y);
            expectColour(emissionAt(scene, true, two), lightOf(texelAt(second.x, second.y)), x, y);
            expectColour(diffuseAt(scene, true, one), lightOf(texelAt(y / 2, x / 2 + 0.25F)), x, y);
        });
    }
}

TEST(TexcoordSets, ASetThatIsNotThereIsTheFirst) {
    test::Json material = kTwoWays;
    material["emissiveTexture"] = lying(5);
    const Scene scene = sceneOf(makeModel(file(material).import().model));
    forPoints([&](float x, float y) {
        expectColour(emissionAt(scene, true, hitAt(x, y)), lightOf(texelAt(x, 1 - y)), x, y);
    });
}

TEST(TexcoordSets, StandInBspFilesAndOnSkyGrounds) {
    const test::TemporaryFolder folder;
    const Model model = makeModel(file(kTwoWays).import().model);
    writeBsp(folder / "m.bsp", model, nullptr, {});
    const Model read = readBsp(folder / "m.bsp").model;
    ASSERT_EQ(read.mesh.furtherTexcoords.size(), model.mesh.furtherTexcoords.size());
    for (std::size_t i = 0; i < read.mesh.furtherTexcoords.size(); ++i)
        EXPECT_EQ(read.mesh.furtherTexcoords[i], model.mesh.furtherTexcoords[i]);
    EXPECT_EQ(read.textures[1].texcoordSet, 1U);
    const auto ground = makeGround(read, {0, 0, 1}, {0.2F, 0.2F, 0.2F});
    ASSERT_EQ(ground->mesh.furtherSets(), 1U);
    EXPECT_EQ(ground->mesh.furtherTexcoords.size(), ground->mesh.normals.size());
    EXPECT_EQ(ground->mesh.texcoord(2, 1), read.mesh.texcoord(2, 1));
}

TEST(TexcoordSets, BspFilesWithOthersAreRefused) {
    const test::TemporaryFolder folder;
    const ModelBuffers good = file(kTwoWays).import().model;
    const auto refusal = [&](const std::function<void(ModelBuffers&)>& change) -> std::string {
        ModelBuffers bad = good;
        change(bad);
        try {
            writeBsp(folder / "m.bsp", makeModel(bad), nullptr, {});
        } catch (const std::exception& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(refusal([](ModelBuffers&) {}), "none");
    EXPECT_NE(refusal([](ModelBuffers& b) { b.furtherTexcoords.pop_back(); }).find("texcoordsets"),
              std::string::npos);
    EXPECT_NE(refusal([](ModelBuffers& b) { b.furtherTexcoords[3].y = NAN; }).find("texcoordsets"),
              std::string::npos);
    EXPECT_NE(refusal([](ModelBuffers& b) {
                  b.furtherTexcoords.resize(8 * b.normals.size());
              }).find("texcoordsets"),
              std::string::npos);
    EXPECT_NE(refusal([](ModelBuffers& b) { b.textures[0].texcoordSet = 2; }).find("texture coordinates"),
              std::string::npos);
    EXPECT_NE(refusal([](ModelBuffers& b) { b.texcoords.clear(); }).find("texcoordsets"), std::string::npos);
}

} // namespace

#include "rtcore/io/bsp/model_check.h"

#include "bsp_support.h"

#include <functional>
#include <limits>

using rtcore::ModelBuffers;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

struct Fault {
    const char* section; ///< that the finding must name
    std::function<void(ModelBuffers&)> make;
};

const std::vector<Fault>& faults() {
    static const std::vector<Fault> all{
        {"vertices", [](ModelBuffers& b) { b.vertices[7].y = kNan; }},
        {"vertices", [](ModelBuffers& b) { b.vertices[7].x = -kInf; }},
        {"vertices", [](ModelBuffers& b) { b.vertices[7].z = 2e18F; }},
        {"vertices", [](ModelBuffers& b) { b.vertices.back().unused = kNan; }},
        {"triangles",
         [](ModelBuffers& b) { b.triangles[3].v[2] = static_cast<std::uint32_t>(b.vertices.size()); }},
        {"triangles", [](ModelBuffers& b) { b.vertices.clear(); }},
        {"shading", [](ModelBuffers& b) { b.shading[3].v[1] = 0xFFFFFFFF; }},
        {"shading", [](ModelBuffers& b) { b.shading[3].material = 3; }},
        {"shading", [](ModelBuffers& b) { b.shading.pop_back(); }},
        {"normals",
         [](ModelBuffers& b) {
             b.normals[5] = {0.5F, 0.5F, 0.5F};
         }},
        {"normals",
         [](ModelBuffers& b) {
             b.normals[5] = {kNan, 0, 1};
         }},
        {"texcoords", [](ModelBuffers& b) { b.texcoords[5].x = kInf; }},
        {"texcoords", [](ModelBuffers& b) { b.texcoords.pop_back(); }},
        {"colours", [](ModelBuffers& b) { b.colours[5].g = -0.1F; }},
        {"colours", [](ModelBuffers& b) { b.colours[5].b = kNan; }},
        {"colours", [](ModelBuffers& b) { b.colours.pop_back(); }},
        {"texcoordsets", [](ModelBuffers& b) { b.furtherTexcoords.pop_back(); }},
        {"texcoordsets", [](ModelBuffers& b) { b.furtherTexcoords[5].y = kNan; }},
        {"textures", [](ModelBuffers& b) { b.textures[0].texcoordSet = 2; }},
        {"alphas", [](ModelBuffers& b) { b.alphas.pop_back(); }},
        {"alphas", [](ModelBuffers& b) { b.alphas[5] = 1.5F; }},
        {"alphas", [](ModelBuffers& b) { b.alphas[5] = kNan; }},
        {"materials", [](ModelBuffers& b) { b.materials.clear(); }},
        {"materials", [](ModelBuffers& b) { b.materials[1].diffuse.r = 1.5F; }},
        {"materials",
         [](ModelBuffers& b) {
             b.materials[0].diffuse = b.materials[0].specular = {0.6F, 0, 0};
         }},
        {"materials", [](ModelBuffers& b) { b.materials[1].opacity = kNan; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].specular.g = -1; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].shininess = 1e6F; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].mirror.b = 2; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].mirrorScale = -0.5F; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].transmission.r = 1.01F; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].attenuationDistance = -1; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].emission.r = kInf; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].indexOfRefraction = 0.5F; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].priority = 1.5F; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].priority = 101; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].fresnel = 2; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].alphaFromAlpha = 2; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].alphaCutoff = 2; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].normalTexture = 3; }},
        {"materials",
         [](ModelBuffers& b) { b.materials[2].nameOffset = static_cast<std::uint32_t>(b.strings.size()); }},
        {"textures", [](ModelBuffers& b) { b.textures[1].width = 0; }},
        {"textures", [](ModelBuffers& b) { b.textures[1].height += 1; }},
        {"textures", [](ModelBuffers& b) { b.textures[1].width = 32769; }},
        {"textures", [](ModelBuffers& b) { b.textures[1].firstTexel = ~std::uint64_t{0}; }},
        {"textures", [](ModelBuffers& b) { b.textures[1].width = b.textures[1].height = 32768; }},
        {"lights",
         [](ModelBuffers& b) { b.lights[0].kind = static_cast<rtcore::LightKind>(rtcore::kLightKinds); }},
        {"lights", [](ModelBuffers& b) { b.lights[0].position.x = kNan; }},
        {"lights", [](ModelBuffers& b) { b.lights[1].direction = {}; }},
        {"lights", [](ModelBuffers& b) { b.lights[1].intensity.g = -1; }},
        {"lights", [](ModelBuffers& b) { b.lights[0].radius = kInf; }},
        {"lights", [](ModelBuffers& b) { b.lights[0].width = -1; }},
        {"lights", [](ModelBuffers& b) { b.lights[4].right = b.lights[4].direction; }},
        {"lights", [](ModelBuffers& b) { b.lights[4].right = {}; }},
        {"lights", [](ModelBuffers& b) { b.lights[2].cosOuter = b.lights[2].cosInner; }},
        {"lights", [](ModelBuffers& b) { b.lights[2].cosInner = 1.5F; }},
        {"lights", [](ModelBuffers& b) { b.lights[2].on = 7; }},
        {"lights", [](ModelBuffers& b) { b.lights[2].nameOffset = 1U << 30U; }},
        {"cameras", [](ModelBuffers& b) { b.cameras[1].eye.z = kInf; }},
        {"cameras", [](ModelBuffers& b) { b.cameras[1].forward = {}; }},
        {"cameras",
         [](ModelBuffers& b) {
             b.cameras[1].up = {kNan, 0, 0};
         }},
        {"cameras", [](ModelBuffers& b) { b.cameras[1].up = b.cameras[1].forward * -3.0F; }},
        {"cameras", [](ModelBuffers& b) { b.cameras[1].horizontalFov = 180; }},
        {"cameras", [](ModelBuffers& b) { b.cameras[1].horizontalFov = 0; }},
        {"cameras", [](ModelBuffers& b) { b.cameras[1].nameOffset = 0xFFFFFFFF; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].roughness = -0.5F; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].flipTextures = 2; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].roughness = kNan; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].metallic = 1.1F; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].metallicRoughnessTexture = 3; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].emissionLights = 2; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].normalScale = kInf; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].vertexAlpha = 2; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].tintsEmission = 2; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].frontOnly = 2; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].transmissionTexture = 3; }},
        {"materials", [](ModelBuffers& b) { b.materials[1].specularTexture = 3; }},
        {"textures", [](ModelBuffers& b) { b.textures[1].filter = static_cast<rtcore::TextureFilter>(2); }},
        {"textures", [](ModelBuffers& b) { b.textures[1].storage = static_cast<rtcore::TextureStorage>(2); }},
        {"textures", [](ModelBuffers& b) { b.textures[1].storage = rtcore::TextureStorage::Blocks; }},
        {"textures", [](ModelBuffers& b) { b.textures[2].firstTexel = 2; }},
        {"textures", [](ModelBuffers& b) { b.textures[2].firstTexel = ~std::uint64_t{0}; }},
        {"textures", [](ModelBuffers& b) { b.textures[2].height = 5; }},
        {"textures", [](ModelBuffers& b) { b.textures[2].width = 9; }},
        {"textures", [](ModelBuffers& b) { b.blocks.pop_back(); }},
        {"textures", [](ModelBuffers& b) { b.textures[1].wrapU = static_cast<rtcore::TextureWrap>(3); }},
        {"textures", [](ModelBuffers& b) { b.textures[1].wrapV = static_cast<rtcore::TextureWrap>(~0U); }},
        {"cameras", [](ModelBuffers& b) { b.cameras[0].kind = static_cast<rtcore::CameraKind>(2); }},
        {"cameras", [](ModelBuffers& b) { b.cameras[0].kind = rtcore::CameraKind::Orthographic; }},
        {"cameras", [](ModelBuffers& b) { b.cameras[1].orthographicWidth = kNan; }},
        {"cameras", [](ModelBuffers& b) { b.cameras[1].orthographicWidth = kInf; }},
        {"cameras", [](ModelBuffers& b) { b.cameras[1].aspect = -1; }},
        {"cameras", [](ModelBuffers& b) { b.cameras[1].aspect = kInf; }},
        {"parts", [](ModelBuffers& b) { b.parts[1].triangleCount += 1; }},
        {"parts", [](ModelBuffers& b) { b.parts[1].triangleCount = 0xFFFFFFFF; }},
        {"parts", [](ModelBuffers& b) { b.parts[0].triangleCount = 8; }},
        {"parts", [](ModelBuffers& b) { std::swap(b.parts[0], b.parts[1]); }},
        {"parts", [](ModelBuffers& b) { b.parts[1].nameOffset = 0xFFFFFFFF; }},
        {"strings", [](ModelBuffers& b) { b.strings.back() = 'x'; }},
        {"strings", [](ModelBuffers& b) { b.strings.front() = 'x'; }},
        {"strings", [](ModelBuffers& b) { b.strings.clear(); }},
    };
    return all;
}

} // namespace

TEST(CheckModel, NamesTheSectionOfEveryFault) {
    ASSERT_FALSE(rtcore::checkModel(rtcore::makeModel(test::SampleModel(21).make(10))));
    const auto& all = faults();
    for (std::size_t i = 0; i < all.size(); ++i) {
        ModelBuffers buffers = test::SampleModel(21).make(10);
        all[i].make(buffers);
        const auto finding = rtcore::checkModel(rtcore::makeModel(std::move(buffers)));
        ASSERT_TRUE(finding) << "fault " << i << " in " << all[i].section << " was not found";
        EXPECT_TRUE(finding->english().starts_with(std::string(all[i].section) + ": "))
            << "fault " << i << ": " << finding->english();
    }
}

TEST(CheckModel, WriterRefusesThemAllAndLeavesTheOldFile) {
    const test::TemporaryFolder folder;
    const rtcore::Model sound = rtcore::makeModel(test::SampleModel(21).make(10));
    rtcore::writeBsp(folder / "f.bsp", sound, nullptr, {});
    for (const Fault& fault : faults()) {
        ModelBuffers buffers = test::SampleModel(21).make(10);
        fault.make(buffers);
        EXPECT_THROW(rtcore::writeBsp(folder / "f.bsp", rtcore::makeModel(std::move(buffers)), nullptr, {}),
                     rtcore::FileError);
    }
    test::expectEqual(rtcore::readBsp(folder / "f.bsp").model, sound);
}

TEST(CheckModel, BordersOfRangesAreInside) {
    ModelBuffers b = test::SampleModel(21).make(10);
    b.vertices[0] = {rtcore::kLargestNumber, -rtcore::kLargestNumber, 0, 0};
    b.normals[0] = {};
    b.normals[1] = rtcore::normalize({1, 1, 1});
    b.colours[0] = {0, -0.0F, 5000};
    b.materials[0].diffuse = {1, 0, 0.5F};
    b.materials[0].specular = {0, 1, 0.5F};
    b.materials[0].shininess = 100000;
    b.materials[0].indexOfRefraction = 1;
    b.lights[0].direction = {}; // a point light has none
    EXPECT_FALSE(rtcore::checkModel(rtcore::makeModel(std::move(b))));
}

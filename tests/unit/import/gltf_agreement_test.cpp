/// Our reader of glTF beside Assimp's, which it takes the place of: the same model where that was right.
#include "rtcore/io/import/assimp/assimp_import.h"
#include "unit/import/gltf_builder.h"

#include <algorithm>
#include <array>
#include <optional>

namespace {

namespace fs = std::filesystem;
using namespace rtcore;

std::string shadingDifference(const ModelBuffers& a, const ModelBuffers& b) {
    for (std::size_t t = 0; t < a.shading.size(); ++t) {
        if (a.shading[t].material != b.shading[t].material) return "materials of triangles";
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t x = a.shading[t].v[i], y = b.shading[t].v[i];
            if (a.normals[x] != b.normals[y]) return "normals of corners of triangle " + std::to_string(t);
            if (a.texcoords.empty() != b.texcoords.empty()) return "texcoords";
            if (!a.texcoords.empty() && a.texcoords[x] != b.texcoords[y]) return "texcoords";
        }
    }
    return a.shading != b.shading ? "sharing" : "";
}

/// The first list in which they differ; "" where they are equal.
std::string difference(const ModelBuffers& a, const ModelBuffers& b) {
    if (a.triangles != b.triangles) return "triangles";
    if (a.vertices != b.vertices) return "vertices";
    if (const std::string at = shadingDifference(a, b); !at.empty()) return at;
    if (a.normals != b.normals) return "normals";
    if (a.texcoords != b.texcoords) return "texcoords";
    if (a.colours != b.colours) return "colours";
    if (a.alphas != b.alphas) return "alphas";
    if (a.materials != b.materials) return "materials";
    if (a.textures != b.textures) return "textures";
    if (a.texels.size() != b.texels.size() || a.blocks.size() != b.blocks.size()) return "texels";
    if (a.lights != b.lights) return "lights";
    if (a.cameras != b.cameras) return "cameras";
    if (a.parts != b.parts) return "parts";
    return a.strings == b.strings ? "" : "names";
}

/// Models that differ, in what first, and why.
struct Known {
    const char *name, *in, *why;
};
constexpr std::array kKnown{
    Known{"issue_3269/texcoord_crash.gltf", "refused",
          "Assimp refuses texture coordinates of set 1 without a set 0"},
    Known{"wrongTypes/badExtension.gltf", "refused", "a wrong member of a material costs itself alone"},
    Known{"wrongTypes/badNumber.gltf", "refused", "the same"},
    Known{"wrongTypes/badObject.gltf", "refused", "the same"},
    Known{"wrongTypes/badString.gltf", "refused", "the same"},
    Known{"wrongTypes/badUint.gltf", "refused", "the same"},
    Known{"BoxTexcoords-glTF/boxTexcoords.gltf", "materials", "its images lie by two sets of coordinates"},
    Known{"ClearCoat-glTF/ClearCoatTest.gltf", "materials", "it has coats of varnish"},
    Known{"simple_skin/simple_skin.gltf", "vertices", "posed by its joints"},
    Known{"textureTransform/TextureTransformTest.gltf", "texcoords", "two textures are turned"},
};

std::optional<FileImport> byAssimp(const fs::path& path) {
    try {
        return importWithAssimp(path, {.creaseAngle = 0.0F});
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

std::optional<FileImport> byOurs(const fs::path& path) {
    try {
        return importGltf(path, {.creaseAngle = 0.0F});
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

void compare(const fs::path& path) {
    const auto ours = byOurs(path), theirs = byAssimp(path);
    std::string differ;
    if (ours.has_value() != theirs.has_value()) {
        differ = ours ? "refused" : "lost";
    } else if (ours) {
        differ = difference(ours->model, theirs->model);
    }
    const auto known =
        std::ranges::find_if(kKnown, [&](const Known& k) { return path.generic_string().ends_with(k.name); });
    EXPECT_EQ(differ, known != kKnown.end() ? known->in : "") << path;
}

/// glTF 2 alone is read by ours.
bool isOurs(const fs::path& path) {
    const std::string ending = path.extension().string();
    return (ending == ".gltf" || ending == ".glb") &&
           path.generic_string().find("/glTF/") == std::string::npos;
}

void compareAll(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && isOurs(entry.path())) paths.push_back(entry.path());
    std::ranges::sort(paths);
    for (const fs::path& path : paths) compare(path);
}

TEST(GltfAgreement, OnModelsThatTestAssimp) {
    const fs::path folder = "/usr/share/assimp/models";
    if (!fs::exists(folder / "glTF2")) GTEST_SKIP() << "assimp-testmodels is not installed";
    compareAll(folder / "glTF2");
}

TEST(GltfAgreement, OnWholeScenes) {
    const char* const folder = std::getenv("RT_TEST_SCENES");
    if (folder == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
    for (const char* const name : {"spot/spot.glb", "lamborghini/lamborghini.glb"})
        if (fs::exists(fs::path(folder) / name)) compare(fs::path(folder) / name);
}

} // namespace

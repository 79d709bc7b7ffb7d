#include "rtcore/io/loading/material_overrides.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/io/loading/sections.h"
#include "rtcore/scene/image_summary.h"
#include "rtcore/scene/material_edit.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace rtcore {

namespace {

std::string_view materialName(const Scene& scene, std::size_t index) {
    return scene.model.name(scene.materials[index].nameOffset);
}

void changeMaterial(const Model& model, const MaterialOverride& change, std::optional<std::uint32_t> texture,
                    const std::vector<LdrImage>& pictures, Material& material) {
    const std::uint32_t seen = texture                                ? *texture
                               : change.textures && !*change.textures ? kNoTexture
                                                                      : material.diffuseTexture;
    TextureMeans means;
    if (change.needsMeans()) {
        means = roughnessMeans(model, material);
        const std::size_t known = model.textures.size();
        if (seen != kNoTexture)
            means.diffuse =
                seen < known ? textureMean(model, seen) : summarise(pictures[seen - known].pixels).meanColour;
    }
    change.applyTo(material, means);
    if (texture) material.diffuseTexture = *texture;
}

/// The model's textures followed by these, in memory of their own.
void addTextures(Model& model, const std::vector<LdrImage>& pictures) {
    struct Extended {
        std::shared_ptr<const void> model;
        std::vector<Texture> textures;
        std::vector<Rgba8> texels;
    };
    auto extended = std::make_shared<Extended>();
    extended->model = model.storage;
    extended->textures.assign(model.textures.begin(), model.textures.end());
    extended->texels.assign(model.texels.begin(), model.texels.end());
    for (const LdrImage& picture : pictures) {
        extended->textures.push_back({extended->texels.size(), static_cast<std::uint32_t>(picture.width),
                                      static_cast<std::uint32_t>(picture.height)});
        extended->texels.insert(extended->texels.end(), picture.pixels.begin(), picture.pixels.end());
    }
    model.textures = extended->textures;
    model.texels = extended->texels;
    model.storage = extended;
}

} // namespace

void overrideMaterials(Loading& loading, const std::filesystem::path& path, const SceneFile& file) {
    Scene& scene = loading.out.scene;
    std::vector<LdrImage> pictures;
    for (const MaterialOverride& change : file.materials) {
        std::optional<std::uint32_t> texture;
        bool used = false;
        for (std::size_t i = 0; i < scene.materials.size(); ++i) {
            if (!isNamed(change.pattern, change.number, i, materialName(scene, i))) continue;
            used = true;
            if (change.diffuseTexture && !texture) {
                texture = static_cast<std::uint32_t>(scene.model.textures.size() + pictures.size());
                pictures.push_back(readLdrImage(*change.diffuseTexture));
                loading.out.files.push_back(*change.diffuseTexture);
            }
            changeMaterial(scene.model, change, texture, pictures, scene.materials[i]);
        }
        if (!used) loading.out.warnings.push_back(unusedMaterial(path, change));
    }
    if (!pictures.empty()) addTextures(scene.model, pictures);
}

} // namespace rtcore

#include "rtcore/sections/cap_colours.h"

#include "rtcore/scene/image_summary.h"

namespace rtcore {

const std::vector<Colour>& CapMaterialColours::of(const Scene& scene, const SectionCaps& caps) {
    if (model_ != scene.model.storage) means_.clear();
    model_ = scene.model.storage;
    colours_.resize(scene.materials.size());
    for (const PlaneCaps& cut : caps.planes)
        for (const CapShape& shape : cut.shapes)
            colours_[shape.material] = colourOf(scene, scene.materials[shape.material]);
    return colours_;
}

Colour CapMaterialColours::colourOf(const Scene& scene, const Material& material) {
    const std::uint32_t number = material.diffuseTexture;
    if (number >= scene.model.textures.size()) return material.diffuse;
    const auto [mean, fresh] = means_.try_emplace(number);
    if (fresh) mean->second = summarise(scene.model, scene.model.textures[number]).meanColour;
    return material.diffuse * mean->second;
}

} // namespace rtcore

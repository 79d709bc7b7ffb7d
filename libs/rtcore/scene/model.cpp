#include "rtcore/scene/model.h"

#include <utility>

namespace rtcore {

std::uint32_t ModelBuffers::addName(std::string_view name) {
    const std::string_view usable = name.substr(0, name.find('\0'));
    if (usable.empty()) return 0;
    const auto offset = static_cast<std::uint32_t>(strings.size());
    strings.insert(strings.end(), usable.begin(), usable.end());
    strings.push_back('\0');
    return offset;
}

Model makeModel(ModelBuffers buffers) {
    const auto owned = std::make_shared<const ModelBuffers>(std::move(buffers));
    Model model;
    model.mesh = {owned->vertices,  owned->triangles, owned->shading, owned->normals,
                  owned->texcoords, owned->colours,   owned->alphas,  owned->furtherTexcoords};
    model.materials = owned->materials;
    model.textures = owned->textures;
    model.texels = owned->texels;
    model.blocks = owned->blocks;
    model.lights = owned->lights;
    model.cameras = owned->cameras;
    model.parts = owned->parts;
    model.strings = owned->strings;
    model.storage = owned;
    return model;
}

} // namespace rtcore

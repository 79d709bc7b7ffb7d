/// Edits of the materials of a scene.
#pragma once

#include "rtcore/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace rtcore {

/// The mean colour of a texture of the model, linear.
Colour textureMean(const Model& model, std::uint32_t texture);
/// The means of the material's texture of roughness and metal.
TextureMeans roughnessMeans(const Model& model, const Material& material);

/// The material as `change` makes it, but for the path of a texture.
Material changedMaterial(const Model& model, Material material, const MaterialOverride& change);

/// Adds `change` (without a texture's path) to what edits made of a material; `loaded` are the materials as
/// the files have them. `index` counts from 0. Scene::closed and `solids` are to be made again by
/// closeSurfaces().
void editMaterial(Scene& scene, std::span<const Material> loaded, std::size_t index,
                  const MaterialOverride& change);
/// Makes `look` all that is edited of a material, but for a priority that it does not say, which stays.
void giveLook(Scene& scene, std::span<const Material> loaded, std::size_t index, MaterialOverride look);
/// The material as the files have it.
void resetMaterial(Scene& scene, std::span<const Material> loaded, std::size_t index);

/// Makes Scene::closed again where materials have become transparent or opaque since they were `before`.
void closeSurfaces(Scene& scene, std::span<const Material> before);

} // namespace rtcore

/// Materials of a scene in the words of a [[material]].
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/scene/material_override.h"
#include "rtcore/scene/scene.h"

#include <cstddef>

namespace rtcore {

/// Whether `table` is for that material of the scene, counted from 0.
bool isFor(const MaterialOverride& table, const Scene& scene, std::size_t index);
/// Whether it is for one material alone, and names it by its number or its whole name.
bool isForOne(const MaterialOverride& table, const Scene& scene);
/// By its name in place of its number, where that is the material's own and no pattern.
void nameMaterial(const Scene& scene, std::size_t index, MaterialOverride& table);

/// Whether images show no difference: a mirror that reflects nothing is none, whatever its scale.
bool looksAs(Material a, Material b);

/// The same material in words of its own kind: what tables say one after the other in words of both kinds
/// depends on the material before each.
MaterialOverride speltOut(MaterialOverride table, const Material& shown);

/// All that a [[material]] can say of how `shown` looks, without a name, in words of its own kind, so that
/// giveLook() makes a material `to` of the model look the same. Where the files give `to` the same textures,
/// these stay; otherwise their means are told in their stead, and `to` has none.
MaterialOverride lookOf(const Model& model, const Material& shown, const Material& to);

/// The words that make the material `from` the material `to` of the scene. `edit`, where it is not null, is
/// what made `to` of something else, whose words are preferred. The name or number is not set. What no words
/// can say - textures that `from` lacks - stays out.
MaterialOverride changeBetween(const Model& model, const Material& from, const Material& to,
                               const MaterialOverride* edit);

} // namespace rtcore

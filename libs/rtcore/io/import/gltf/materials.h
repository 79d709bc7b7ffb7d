/// Materials of a glTF file.
#pragma once

#include "rtcore/io/import/gltf/images.h"
#include "rtcore/io/import/gltf/texcoord_use.h"
#include "rtcore/io/import/materials/material_mapping.h"

namespace rtcore::gltf {

/// A material as its JSON states it; of null, the format's default. Without `vertexAlpha`.
SourceMaterial sourceMaterialOf(const Json& material, const Images& images);

/// How its images lie on a surface: as the first of them does, the one of the base colour where there is one.
struct Layout {
    TexcoordUse use;
    bool alike = true; ///< all of them lie so
};
Layout layoutOf(const Json& material, const Images& images);
/// Whether images say how its coat of varnish varies, of which the mean is taken.
bool hasUnevenCoat(const Json& material, const Images& images);

} // namespace rtcore::gltf

/// Materials of a glTF file.
#pragma once

#include "rtcore/io/import/gltf/images.h"
#include "rtcore/io/import/gltf/texcoord_use.h"
#include "rtcore/io/import/materials/material_mapping.h"

#include <vector>

namespace rtcore::gltf {

/// A material, and how its images lie on a surface.
struct StatedMaterial {
    SourceMaterial source;
    /// By the numbers that its images have as sets (SourceMap::texcoordSet); one at least. The first is that
    /// of the base colour, where there is one.
    std::vector<TexcoordUse> texcoords;
};

/// A material as its JSON states it; of null, the format's default. Without `vertexAlpha`.
StatedMaterial materialOf(const Json& material, const Images& images);
/// Whether images say how its coat of varnish varies, of which the mean is taken.
bool hasUnevenCoat(const Json& material, const Images& images);

} // namespace rtcore::gltf

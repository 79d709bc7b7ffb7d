/// The materials of a model, made of those of a glTF file that its scene shows.
#pragma once

#include "rtcore/io/import/file_import.h"
#include "rtcore/io/import/gltf/materials.h"
#include "rtcore/io/import/gltf/primitive.h"
#include "rtcore/io/import/gltf/scene_meshes.h"

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace rtcore::gltf {

class ModelMaterials {
  public:
    /// Finds what is shown. All must outlive the object.
    ModelMaterials(const Json& root, const NodeWalk& walk, std::span<const Placement> placements,
                   const Images& images, PrimitiveReader& primitives);

    /// Adds them, in the order in which nodes come to them, leaves first, that
    /// of primitives without one last; and their images.
    void addTo(FileImport& import, TextureStore& textures);

    /// The number in the model of a primitive's material.
    std::uint32_t numberOf(const Json& primitive) const;
    /// How its texture coordinates lie, and whether alphas of its vertices count.
    PrimitiveUse useOf(const Json& primitive) const;

  private:
    /// One of the file; the last stands for none.
    struct Entry {
        bool shown = false, alphas = false;
        std::uint32_t number = ~std::uint32_t{0};
        std::vector<TexcoordUse> texcoords;
    };
    std::size_t entryOf(const Json& primitive) const;
    void use(const Json& mesh, PrimitiveReader& primitives);

    const Json& stated_;
    const Images& images_;
    std::vector<Entry> entries_;
    std::vector<std::size_t> order_;   ///< of those that are shown
    std::set<const Json*> withAlphas_; ///< primitives
};

} // namespace rtcore::gltf

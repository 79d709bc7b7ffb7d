/// Materials of the triangles of a 3MF package.
#pragma once

#include "rtcore/io/import/file_import.h"
#include "rtcore/io/import/materials/material_mapping.h"
#include "rtcore/io/import/threemf/model_part.h"
#include "rtcore/io/import/threemf/package_images.h"

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rtcore::threemf {

/// What corners tell of a material, beside where they are.
struct Look {
    std::uint32_t material = 0; ///< number in the model
    std::string name;
    bool painted = false;     ///< by colours of its corners
    bool translucent = false; ///< by their alphas, too
    bool textured = false;
};

/// How a triangle looks.
struct Surface {
    std::uint32_t look = 0; ///< number
    std::array<Paint, 3> paints;
    std::array<Vec2, 3> coordinates;
    bool unknown = false; ///< grey, as its group or its entries do not exist
};

class Looks {
  public:
    /// All must outlive the object.
    Looks(PackageImages& images, TextureStore& textures, FileImport& import)
        : images_(images), textures_(textures), import_(import) {}

    /// Makes the material where it is new. `part` must outlive the object.
    Surface surfaceOf(const PartContent& part, const Properties& properties);
    const Look& look(std::uint32_t number) const { return looks_[number]; }

    /// Groups of layers whose images lie in different ways, and that have colours that vary below them.
    bool laidApart() const { return laidApart_; }
    bool unevenLayers() const { return unevenLayers_; }

  private:
    struct Key {
        const PartContent* part = nullptr;
        std::uint32_t group = kNoNumber;
        std::uint64_t detail = 0;
        auto operator<=>(const Key&) const = default;
    };
    Surface plain();
    Surface unknown();
    Surface painted(const PartContent& part, const Properties& properties);
    Surface ofMaterial(const PartContent& part, const PropertyGroup& group, const Properties& properties);
    Surface textured(const PartContent& part, const PropertyGroup& group, const Properties& properties);
    Surface layered(const PartContent& part, const PropertyGroup& group, const Properties& properties);
    bool lay(const PartContent& part, const PropertyGroup& group, const Properties& properties,
             Surface& surface);
    std::vector<ImageLayer> layersOf(const PartContent& part, const PropertyGroup& group,
                                     std::uint32_t entry);
    template <typename Make>
    std::uint32_t numberOf(const Key& key, const Make& make);
    std::uint32_t add(SourceMaterial source, Look look);

    PackageImages& images_;
    TextureStore& textures_;
    FileImport& import_;
    std::map<Key, std::uint32_t> numbers_;
    std::pair<Key, std::uint32_t> last_{{}, kNoNumber};
    std::vector<Look> looks_;
    std::map<const PropertyGroup*, std::uint32_t> composed_; ///< how many images of layers a group has
    bool laidApart_ = false, unevenLayers_ = false;
};

} // namespace rtcore::threemf

/// Properties of materials that the text of model files states and Assimp does not hand over.
#pragma once

#include "rtcore/math/vec.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// Where the specular colour of a material comes from.
enum class SpecularOrigin {
    Stated,  ///< what Assimp has is right
    Texture, ///< the file has an image alone
    None,    ///< the file has none, so it is black
};

/// The property of a material that an image supplies.
enum class MapUse { Diffuse, Opacity, Normal, Emission, Height, Specular };
inline constexpr std::size_t kMapUses = 6;

/// Options of a texture statement of MTL.
struct MapOptions {
    Vec2 scale{1, 1}, offset; ///< -s, -o: coordinates times scale plus offset
    float bump = 1;           ///< -bm
};

struct MaterialText {
    SpecularOrigin specular = SpecularOrigin::Stated;
    std::array<MapOptions, kMapUses> maps;

    MapOptions& optionsOf(MapUse use) { return maps[static_cast<std::size_t>(use)]; }
    const MapOptions& optionsOf(MapUse use) const { return maps[static_cast<std::size_t>(use)]; }
};

class MaterialTexts {
  public:
    /// Reads a Wavefront file (.obj), with the material libraries that Assimp finds, or a Collada file
    /// (.dae); empty for others.
    explicit MaterialTexts(const std::filesystem::path& path);

    /// `index` counts the materials as Assimp hands them over, `count` of them.
    MaterialText of(const std::string& name, std::size_t index, std::size_t count) const;

  private:
    std::map<std::string, MaterialText> byName_; ///< of MTL
    std::vector<MaterialText> inOrder_;          ///< of Collada
};

/// The text of a material library without the options that MapOptions has, of which Assimp expects three
/// numbers each, though the last two may be left out.
std::string withoutMapOptions(std::string_view mtl);

} // namespace rtcore

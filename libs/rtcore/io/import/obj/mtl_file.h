/// Material libraries of OBJ files.
#pragma once

#include "rtcore/io/import/import_report.h"
#include "rtcore/io/import/materials/material_mapping.h"
#include "rtcore/math/vec.h"
#include "rtcore/platform/files.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace rtcore {

/// Images of a material, in the order in which the first of them says how all lie.
enum class MtlMap { Diffuse, Opacity, Normal, Emission, Height, Specular };
inline constexpr std::size_t kMtlMaps = 6;

/// How an image lies: coordinates times scale plus offset.
struct MtlLayout {
    Vec2 scale{1, 1}, offset; ///< -s, -o
    friend bool operator==(const MtlLayout&, const MtlLayout&) = default;
};

struct MtlMaterial {
    SourceMaterial source;
    bool isDescribed = false; ///< by a library; else a name alone
    std::array<MtlLayout, kMtlMaps> layouts;

    SourceMap& map(MtlMap which);
    MtlLayout& layout(MtlMap which) { return layouts[static_cast<std::size_t>(which)]; }
};

/// All materials that libraries describe or a model names, in the order in which they come up.
class MtlMaterials {
  public:
    static constexpr std::uint32_t kDefault = 0; ///< of faces without a material

    MtlMaterials();
    /// The number of the material of this name, which is made where there is none.
    std::uint32_t numberOf(const std::string& name);
    std::span<MtlMaterial> all() { return materials_; }

  private:
    std::vector<MtlMaterial> materials_;
    std::unordered_map<std::string, std::uint32_t> numbers_;
};

/// Adds what a library describes. A statement that is not understood costs itself alone, with a warning.
/// Colours are decoded where the program that wrote it, else that of the model (`exporter`), has them as
/// displays show them. `unsupported` gets the statements that are known and have no counterpart here, each
/// once. Names of images are those of the library, whose folder is `folder` as seen from the model's ("" for
/// the same). Throws as openFileBytes() does.
void readMtl(const std::filesystem::path& path, const std::string& folder, MtlMaterials& materials,
             std::vector<std::string>& unsupported, std::string_view exporter, ImportReport& report);

} // namespace rtcore

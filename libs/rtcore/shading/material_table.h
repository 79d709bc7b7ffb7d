/// What shading needs of each material, worked out once for a frame.
#pragma once

#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// What is asked of a point beyond the diffuse lobe of its material's own colour. A point with none of these but
/// kGlossy is plain: vector code alone shades it.
namespace traits {
inline constexpr std::uint32_t kPoint = 1;     ///< there is a surface to be lit
inline constexpr std::uint32_t kGlossy = 2;    ///< it has a Phong lobe
inline constexpr std::uint32_t kColoured = 4;  ///< the albedo varies: texture, colours of vertices
inline constexpr std::uint32_t kMirror = 8;    ///< opaque, and reflects
inline constexpr std::uint32_t kGeneral = 16;  ///< transparent, perforated, bump mapped, glowing by a texture
inline constexpr std::uint32_t kNotPlain = kColoured | kMirror | kGeneral;
} // namespace traits

/// Sixteen numbers, so that a row is a cache line.
struct alignas(64) MaterialRow {
    float diffuse[3] = {}; ///< albedo / pi
    std::uint32_t traits = 0;
    float glow[3] = {};    ///< emission and reflected ambient light, as radiance
    float shininess = 0;
    float specular[3] = {};
    float lobeScale = 0;   ///< of the Phong lobe, (n + 2) / 2 pi
    float unused[4] = {};
};
static_assert(sizeof(MaterialRow) == 64);

/// Immutable while rays are traced; shared by all threads.
class MaterialTable {
  public:
    /// Keeps its memory from frame to frame.
    void prepare(const Scene& scene, const RenderSettings& settings);

    const MaterialRow* rows() const { return rows_.data(); }
    bool anyGlow() const { return anyGlow_; }
    /// Something lets light through, so that shadows may be tinted.
    bool tintedShadows() const { return tintedShadows_; }

  private:
    std::vector<MaterialRow> rows_; ///< by index of the material
    bool anyGlow_ = false, tintedShadows_ = false;
};

} // namespace rtcore

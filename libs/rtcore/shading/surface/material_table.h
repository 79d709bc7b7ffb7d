/// What shading needs of each material, worked out once for a frame.
#pragma once

#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// What is asked of a point beyond the diffuse lobe of its material's own colour.
namespace traits {
inline constexpr std::uint32_t kPoint = 1;     ///< there is a surface to be lit
inline constexpr std::uint32_t kGlossy = 2;    ///< it has a Phong lobe
inline constexpr std::uint32_t kMirror = 4;    ///< opaque, reflects, and is not kGeneral
inline constexpr std::uint32_t kFresnel = 8;   ///< a mirror that reflects more at grazing angles
inline constexpr std::uint32_t kColoured = 16; ///< the albedo varies: texture, colours of vertices
inline constexpr std::uint32_t kGeneral = 32; ///< transparent, perforated, bump mapped, emitting by a texture
inline constexpr std::uint32_t kSpecular = 64;   ///< of points, not of materials: a mirrored ray follows
inline constexpr std::uint32_t kRough = 128;     ///< it has a rough lobe (phong.h)
inline constexpr std::uint32_t kMetallic = 1024; ///< of the metallic-roughness model: has none of the lobes
                                                 ///< and mirrors above
inline constexpr std::uint32_t kSharp = 2048; ///< of these: no glass, and somewhere so smooth that it mirrors
inline constexpr std::uint32_t kVaried = 4096; ///< of these: a texture has roughness and metal
/// Of points that vector code alone cannot shade: seen from behind; shading normal turned (surface.h).
inline constexpr std::uint32_t kFromInside = 256, kTurned = 512;
/// Vector code alone cannot shade such a point.
inline constexpr std::uint32_t kNotPlain = kColoured | kGeneral;
} // namespace traits

/// A power of two of floats, so that indices are multiplied by shifts.
struct alignas(64) MaterialRow {
    float diffuse[3] = {}; ///< albedo / pi
    std::uint32_t traits = 0;
    float specular[3] = {}; ///< kMetallic: reflectance of what is no metal, straight on
    float shininess = 0;    ///< of the Phong lobe, at least kLeastShininess
    float lobeScale = 0;    ///< of the Phong lobe, (n + 2) / 2 pi times its fraction
    float roughScale = 0;   ///< of the rough lobe, its fraction over 2 pi
    float mirrorScale = 0;
    float mirror[3] = {};
    float emission[3] = {};
    float ambient[3] = {}; ///< radiance of reflected ambient light; 0 of kMetallic, where it varies
    float emitted[3] = {}; ///< emission + ambient
    float roughness = 0, metallic = 0; ///< of kMetallic
    float unused[7] = {};
};
inline constexpr int kRowShift = 5; ///< a row has 2^kRowShift floats
static_assert(sizeof(MaterialRow) == sizeof(float) << kRowShift);

/// Immutable while rays are traced; shared by all threads.
class MaterialTable {
  public:
    /// For surfaces that reflect the ambient light of the scene. Keeps its memory from frame to frame.
    void prepare(const Scene& scene, const RenderSettings& settings);
    /// For surfaces that reflect this ambient light, a radiance from all directions.
    void prepare(const Scene& scene, const RenderSettings& settings, Colour ambientLight);

    const MaterialRow* rows() const { return rows_.data(); }
    bool anyEmission() const { return anyEmission_; }
    bool anyMirror() const { return (traits_ & traits::kMirror) != 0; }
    bool anyMetallic() const { return (traits_ & traits::kMetallic) != 0; }
    bool anyVaried() const { return (traits_ & traits::kVaried) != 0; }
    /// A texture has the colour of highlights.
    bool anyTint() const { return anyTint_; }
    /// Mirrored rays may follow from points.
    bool anySecondary() const {
        return (traits_ & (traits::kMirror | traits::kGeneral | traits::kSharp)) != 0;
    }
    /// Something lets light through, so that shadows may be tinted.
    bool tintedShadows() const { return tintedShadows_; }
    /// By material: 1 where it may let light through, else 0; empty where none does.
    std::span<const std::uint8_t> clear() const {
        return tintedShadows_ ? std::span(clear_) : std::span<const std::uint8_t>();
    }

  private:
    std::vector<MaterialRow> rows_; ///< by index of the material
    std::uint32_t traits_ = 0;      ///< of any
    std::vector<std::uint8_t> clear_;
    bool anyEmission_ = false, tintedShadows_ = false, anyTint_ = false;
};

} // namespace rtcore

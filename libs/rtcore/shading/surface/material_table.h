/// Values of each material for shading, worked out once for a frame.
#pragma once

#include "rtcore/shading/surface/material_row.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Immutable while rays are traced; shared by all threads.
class MaterialTable {
  public:
    /// For surfaces that reflect the ambient light of the scene. Keeps its memory from frame to frame.
    void prepare(const Scene& scene, const RenderSettings& settings);
    /// For surfaces that reflect this ambient light, a radiance from all directions.
    void prepare(const Scene& scene, const RenderSettings& settings, Colour ambientLight);

    const MaterialRow* rows() const { return rows_.data(); }
    /// The index of one more row: matte, of an albedo of 1.
    std::uint32_t white() const { return static_cast<std::uint32_t>(rows_.size()) - 1; }
    bool anyEmission() const { return anyEmission_; }
    bool anyMirror() const { return (traits_ & traits::kMirror) != 0; }
    bool anyMetallic() const { return (traits_ & traits::kMetallic) != 0; }
    bool anyVaried() const { return (traits_ & traits::kVaried) != 0; }
    bool anyCoated() const { return (traits_ & traits::kCoated) != 0; }
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
    std::vector<MaterialRow> rows_; ///< by index of the material; the last is white
    std::uint32_t traits_ = 0;      ///< of any
    std::vector<std::uint8_t> clear_;
    bool anyEmission_ = false, tintedShadows_ = false, anyTint_ = false;
};

} // namespace rtcore

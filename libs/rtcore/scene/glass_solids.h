/// Solids of glass, which may overlap or touch each other.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/scene/closed_surfaces.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rtcore {

/// Media are materials, counted from 1: all solids of one are the same medium. A solid with several of them
/// goes by that of its first triangle. Materials beyond the 65,535th are not known as media.
struct GlassSolids {
    /// Triangles of two solids with the same corners: rays meet one of them alone.
    struct Twin {
        std::uint32_t triangle, other;
        bool sameSide; ///< both are seen from the front, or neither
    };

    std::vector<std::uint16_t> medium; ///< by triangle; 0: bounds no glass solid
    std::vector<Box3> boxes;           ///< of connected triangles of glass
    bool overlap = false;              ///< some may, since their boxes do
    std::vector<Twin> twins;           ///< ascending, each of them in both orders; none without `overlap`

    /// Null where it has none.
    const Twin* twinOf(std::uint32_t triangle) const;
};

/// Of the glass that is closed, with these materials; null where there is none. Time and memory go with the
/// triangles of the glass.
std::shared_ptr<const GlassSolids> findGlassSolids(const Mesh& mesh, std::span<const Material> materials,
                                                   const ClosedSurfaces& closed);

} // namespace rtcore

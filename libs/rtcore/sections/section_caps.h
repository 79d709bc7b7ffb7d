/// Areas that close the solids that sections cut open.
#pragma once

#include "rtcore/scene/scene.h"
#include "rtcore/sections/closed_pieces.h"
#include "rtcore/sections/cut_outlines.h"
#include "rtcore/sections/cut_plane.h"

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

namespace rtcore {

struct FlatLine {
    FlatPoint a, b;
    auto operator<=>(const FlatLine&) const = default;
};

/// Where one plane cuts the solids of one part.
struct CapShape {
    std::uint32_t material = 0;  ///< of the scene
    std::vector<FlatLoop> loops; ///< as those of CutOutline, as far as other sections leave the plane
    std::vector<FlatLine> edges; ///< their lines, but those along which two solids touch
};

/// On one plane, larger ones first: of solids that lie in each other the inner one is seen.
struct PlaneCaps {
    CutPlane plane;
    std::vector<CapShape> shapes;
};

struct SectionCaps {
    std::vector<PlaneCaps> planes;      ///< those that cut solids
    std::vector<std::string> openParts; ///< names of parts that are cut and not closed, each once

    bool empty() const { return planes.empty(); }
};

/// `pieces` are of the scene's model.
SectionCaps sectionCapsOf(const Scene& scene, ClosedPieces& pieces);

} // namespace rtcore

/// Solids of a CAD document where they stand.
#pragma once

#include "rtcore/math/colour.h"

#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>

#include <optional>
#include <string>
#include <vector>

namespace rtcore {

/// A colour with its alpha, linear.
struct CadPaint {
    Colour colour;
    float alpha = 1;
    friend bool operator==(const CadPaint&, const CadPaint&) = default;
};

/// A face and its colour; none where nothing says one.
struct CadFace {
    TopoDS_Shape face;
    std::optional<CadPaint> paint;
};

struct CadPart {
    std::string name; ///< of the assemblies from the outermost down, joined by slashes
    TopoDS_Shape shape;
    TopLoc_Location location;
    std::vector<CadFace> faces; ///< in the coordinates of `shape`
};

/// In the order of the document. Throws FileError BadData where assemblies hold themselves, or the parts,
/// which are counted first, do not fit into so many bytes (0: any).
std::vector<CadPart> cadPartsOf(const Handle(TDocStd_Document) & document, std::uint64_t memoryLimit);

} // namespace rtcore

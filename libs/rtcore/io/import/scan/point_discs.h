/// Clouds of points as small discs.
#pragma once

#include "rtcore/io/import/scan/scan_mesh.h"
#include "rtcore/scene/model.h"

#include <cstdint>
#include <functional>

namespace rtcore {

/// More are refused: see refuseManyPoints().
inline constexpr std::uint64_t kMaxPoints = 10'000'000;
/// Up to here discs have six corners, beyond four.
inline constexpr std::uint64_t kMaxHexagons = 1'000'000;

/// Throws FileError BadData where so many points are more than kMaxPoints or fit not into `memoryLimit`
/// bytes; 0 is none.
void refuseManyPoints(std::uint64_t count, std::uint64_t memoryLimit);

/// Points that are not shown.
struct LostPoints {
    std::uint64_t nonFinite = 0; ///< a coordinate is no number or beyond 1e12
    std::uint64_t equal = 0;     ///< lie where one before them does
};

/// Puts a flat disc at every point, in their order, two or four triangles each, which faces along the point's
/// normal - that of the plane of its neighbours where it has none - and takes its colour. Discs reach as far
/// as 0.72 times the distance of the sixth neighbour, so that those of a surface overlap; but not where the
/// neighbours themselves lie closer together, so that a point far off from all others stays a dot. Takes the
/// lists of `points`. `model` has the material 0 and no triangles before. Memory: 330 bytes for each point.
/// By the threads of OpenMP; the model does not depend on them. `alive` is called now and then. Throws
/// std::bad_alloc.
LostPoints addDiscs(ScanMesh points, ModelBuffers& model, const std::function<void()>& alive);

} // namespace rtcore

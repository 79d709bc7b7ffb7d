/// Triangles of the modes in which primitives are drawn.
#pragma once

#include "rtcore/io/import/gltf/json_members.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore::gltf {

/// The numbers that stand for them in files.
enum class Mode : std::uint32_t { Points, Lines, LineLoop, LineStrip, Triangles, TriangleStrip, TriangleFan };

/// Mode::Points for one that there is not.
Mode modeOf(const Json& primitive);

struct TriangleList {
    std::vector<Triangle> triangles;  ///< of vertices that there are
    std::uint64_t unconnected = 0;    ///< left out: a corner does not exist
    std::uint64_t pointsAndLines = 0; ///< left out
};

/// As many triangles, points or lines as `corners` make.
std::uint64_t facesOf(Mode mode, std::uint64_t corners);

/// `corners`: numbers of vertices, below `vertices` where they exist.
TriangleList trianglesOf(Mode mode, std::span<const std::uint32_t> corners, std::uint64_t vertices);
/// Of vertices in their order, without a list of corners.
TriangleList trianglesOf(Mode mode, std::uint64_t vertices);
/// Leaves out those with a corner that does not exist.
TriangleList connected(std::vector<Triangle> triangles, std::uint64_t vertices);

} // namespace rtcore::gltf

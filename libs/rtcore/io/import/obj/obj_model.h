/// An OBJ file as it is read: lists of numbers, and faces that name them.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rtcore {

inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFFU;

/// Corners of all faces, in the order of the file; indices count from 0, and are of any value.
struct ObjCorners {
    std::vector<std::uint32_t> positions;
    std::vector<std::uint32_t> texcoords, normals; ///< kNoIndex = none; empty, or as long as `positions`
};

/// Positions, normals, texture coordinates and faces, which nearly all statements of a file are.
struct ObjLists {
    std::vector<Vec3> positions, normals;
    std::vector<Vec2> texcoords;
    std::vector<Colour> colours; ///< of positions, as in the file; empty, or as many as there are
    ObjCorners corners;
    std::vector<std::uint32_t> sizes; ///< corners of each face; empty where all have three
    std::size_t faces = 0;
};

/// Faces behind each other.
struct ObjRun {
    std::size_t firstFace, endFace, firstCorner, endCorner;
};

/// Faces of one object that have one material.
struct ObjMesh {
    std::string name; ///< of its group or material
    std::uint32_t object = kNoIndex, material = kNoIndex;
    std::vector<ObjRun> runs;
    std::uint64_t statements = 0; ///< faces, lines and points
};

struct ObjModel : ObjLists {
    std::uint64_t segments = 0; ///< lines between two points, and points

    std::vector<std::string> objects;
    std::vector<ObjMesh> meshes; ///< in the order in which they begin
};

} // namespace rtcore

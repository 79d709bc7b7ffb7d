/// Models of ten million triangles, as files.
#pragma once

#include <filesystem>
#include <string_view>

namespace bench {

/// A sheet of hills of 10,000,000 triangles, as glTF (`.glb`) or OBJ by the ending of the name:
///   whole    one mesh with normals and texture coordinates, one index for all of them
///   bare     one mesh of positions alone
///   objects  1,000 meshes with normals, each a node of its own
///   quads    (OBJ) quads in 45 groups of 7 materials, with other numbers for texture coordinates and normals
/// Numbers have six digits behind the point, as most programs write them. Throws std::runtime_error.
void writeLargeModel(std::string_view kind, const std::filesystem::path& path);

} // namespace bench

/// Views that are compressed by EXT_meshopt_compression.
#pragma once

#include "rtcore/io/import/gltf/json_members.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore::gltf {

inline constexpr const char* kMeshoptExtension = "EXT_meshopt_compression";

enum class MeshoptMode { None, Attributes, Triangles, Indices };
enum class MeshoptFilter { None, Octahedral, Quaternion, Exponential };

struct MeshoptView {
    MeshoptMode mode = MeshoptMode::None;
    MeshoptFilter filter = MeshoptFilter::None;
    std::uint64_t count = 0, stride = 0;
};

/// As the extension of a view states it.
MeshoptView meshoptView(const Json& stated);

/// Whether this program was built with the library.
bool readsMeshopt();

/// count * stride bytes; none where the code is damaged, or stands for more than it could.
std::vector<std::byte> decodeMeshopt(std::span<const std::byte> code, const MeshoptView& view);

} // namespace rtcore::gltf

/// Bytes inside of a URI (RFC 2397).
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace rtcore::gltf {

inline bool isDataUri(std::string_view uri) { return uri.starts_with("data:"); }

/// Up to the first character that does not belong there. Memory: the result, which is shorter than `uri`.
std::vector<std::byte> bytesOfDataUri(std::string_view uri);

} // namespace rtcore::gltf

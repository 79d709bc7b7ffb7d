/// Members of JSON that anybody may have written: what is missing or of the wrong kind is nothing.
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace rtcore::gltf {

using Json = nlohmann::json;

/// null where there is none.
const Json& member(const Json& object, const char* name);
const Json& element(const Json& list, std::optional<std::size_t> index);
/// object.extensions.name
const Json& extension(const Json& object, const char* name);

/// Of a number that is whole, from 0 to 2^53.
std::optional<std::uint64_t> wholeNumber(const Json& value);
std::optional<std::size_t> index(const Json& object, const char* name);
std::uint64_t wholeNumber(const Json& object, const char* name, std::uint64_t otherwise);
/// Never NaN; what no float can hold is the largest of them.
float number(const Json& object, const char* name, float otherwise);
bool flag(const Json& object, const char* name, bool otherwise);
std::string text(const Json& object, const char* name);

/// A list of N numbers, or none of them is read. As doubles, they are finite.
template <std::size_t N, typename Number = float>
std::optional<std::array<Number, N>> numbers(const Json& object, const char* name);

/// As many as there are elements; 0 for what is no list.
inline std::size_t sizeOf(const Json& list) { return list.is_array() ? list.size() : 0; }

} // namespace rtcore::gltf

/// The head of a PLY file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// Bytes.
std::size_t sizeOf(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;                      ///< of a list: of its members
    std::optional<PlyType> listLength; ///< of a list: the type of its length, which stands before it
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0; ///< as the head says, whatever the file holds
    std::vector<PlyProperty> properties;

    bool hasList() const;
    /// Bytes of all properties but lists.
    std::size_t fixedSize() const;
};

struct PlyHeader {
    bool isText = false; ///< each element is a line
    bool bigEndian = false;
    std::size_t size = 0;             ///< bytes; the first element begins there
    std::vector<PlyElement> elements; ///< in the order of the file, no name twice
};

inline constexpr std::size_t kMaxPlyHeader = 262'144;

/// `head` is the beginning of a file. Nothing when that is no PLY file or its head has more than
/// kMaxPlyHeader bytes, words that the format does not have, or the name of a texture.
std::optional<PlyHeader> readPlyHeader(std::string_view head);

/// Whether `text`, the beginning of a file, begins as a PLY file of any kind does, and ends before its head
/// does.
bool endsInPlyHeader(std::string_view text);

} // namespace rtcore

/// The bytes of a .bsp file, version 2 (docs/formats.md): this header, then the sections in the order of
/// BspSection, each at the next multiple of 64 bytes behind the one before, the gaps filled with zeros.
/// Numbers are in the byte order of the machine that wrote the file. Every byte is under one of the two CRCs.
#pragma once

#include "rtcore/accel/kd_node.h"
#include "rtcore/scene/model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace rtcore {

enum class BspSection : std::uint32_t {
    Nodes,      ///< KdNode; none in a file without a tree
    References, ///< std::uint32_t
    Vertices,   ///< Vertex
    Triangles,  ///< Triangle
    Shading,    ///< ShadingTriangle, one per triangle
    Normals,    ///< Vec3
    Texcoords,  ///< Vec2, none or one per normal
    Colours,    ///< Colour, none or one per normal
    Materials,  ///< Material, at least one
    Textures,   ///< Texture
    Texels,     ///< Rgba8
    Lights,     ///< Light
    Cameras,    ///< Camera
    Strings,    ///< char; the first and the last are zero
};
inline constexpr std::size_t kBspSections = 14;

inline constexpr std::array<const char*, kBspSections> kBspSectionNames{
    "nodes",   "references", "vertices", "triangles", "shading", "normals", "texcoords",
    "colours", "materials",  "textures", "texels",    "lights",  "cameras", "strings"};

inline constexpr std::array<std::uint32_t, kBspSections> kBspElementSizes{
    sizeof(KdNode), sizeof(std::uint32_t), sizeof(Vertex), sizeof(Triangle), sizeof(ShadingTriangle),
    sizeof(Vec3),   sizeof(Vec2),          sizeof(Colour), sizeof(Material), sizeof(Texture),
    sizeof(Rgba8),  sizeof(Light),         sizeof(Camera), sizeof(char)};

/// As PNG's: the first byte catches channels that drop the eighth bit, the line ends those that translate
/// them. No other format called .bsp begins so.
inline constexpr std::array<std::uint8_t, 8> kBspMagic{0x89, 'R', 'T', 'K', '\r', '\n', 0x1A, '\n'};
inline constexpr std::uint32_t kBspByteOrder = 0x01020304;
inline constexpr std::uint32_t kBspVersion = 2;
inline constexpr std::uint64_t kBspAlignment = 64; ///< of sections: a cache line

struct BspSectionEntry {
    std::uint64_t offset; ///< of the first byte, from the start of the file
    std::uint64_t count;  ///< of elements
    std::uint64_t elementSize;
};

struct BspHeader {
    std::array<std::uint8_t, 8> magic;
    std::uint32_t byteOrder; ///< kBspByteOrder, as the writing machine stores it
    std::uint32_t version;
    std::uint32_t headerSize; ///< sizeof(BspHeader); the payload begins there
    std::uint32_t sectionCount;
    std::uint64_t fileSize;         ///< bytes, all of the file
    std::uint64_t sourceSize;       ///< bytes of the file that the model was imported from
    std::uint32_t sourceCrc;        ///< CRC-32 of the same
    std::uint32_t buildOptionsHash; ///< of all that decides how the tree was built
    std::array<float, 3>
        boundsLo; ///< the tree's bounds, else those of all triangles; lo > hi when there are none
    std::array<float, 3> boundsHi;
    std::uint32_t hasTree;    ///< 0 or 1
    std::uint32_t payloadCrc; ///< CRC-32 of all bytes behind the header
    std::array<BspSectionEntry, kBspSections> sections;
    std::array<std::uint32_t, 7> reserved; ///< zero
    std::uint32_t headerCrc;               ///< CRC-32 of the header up to here
};

static_assert(sizeof(BspSectionEntry) == 24);
static_assert(sizeof(BspHeader) == 7 * kBspAlignment);
static_assert(offsetof(BspHeader, fileSize) == 24 && offsetof(BspHeader, sections) == 80);
static_assert(offsetof(BspHeader, headerCrc) == sizeof(BspHeader) - 4);
static_assert(std::is_trivially_copyable_v<BspHeader> &&
              std::has_unique_object_representations_v<BspSectionEntry>);

} // namespace rtcore

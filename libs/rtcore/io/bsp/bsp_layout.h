/// The bytes of a .bsp file, version 6 (docs/formats.md): the head, a table of sections, then the sections in
/// the order of the table, each at the next multiple of 64 bytes behind what is before it, the gaps filled
/// with zeros. Sections are known by name and say how large their elements are: a reader skips names that it
/// does not know, and takes of an element what it knows. Numbers are in the byte order of the machine that
/// wrote the file. Every byte is under one of the two CRCs.
#pragma once

#include "rtcore/accel/kd_node.h"
#include "rtcore/scene/model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace rtcore {

enum class BspSection : std::uint32_t {
    Nodes,        ///< KdNode; none in a file without a tree
    References,   ///< std::uint32_t
    Vertices,     ///< Vertex
    Triangles,    ///< Triangle
    Shading,      ///< ShadingTriangle, one per triangle
    Normals,      ///< Vec3
    Texcoords,    ///< Vec2, none or one per normal
    Colours,      ///< Colour, none or one per normal
    Alphas,       ///< float, none or one per normal
    TexcoordSets, ///< Vec2 of further sets, none or as many for each normal, at most kMaxFurtherSets
    Materials,    ///< Material, at least one
    Textures,     ///< Texture
    Texels,       ///< Rgba8
    Lights,       ///< Light
    Cameras,      ///< Camera
    Parts,        ///< ModelPart
    Strings,      ///< char; the first and the last are zero
    Warnings,     ///< char: lines about what the import left out
    Origin,       ///< char: lines of writeOrigin()
    TexelBlocks,  ///< TexelBlock; not there where no texture is in blocks and no Luminaires follow
    Luminaires,   ///< double: numbersOf() each distribution; not there without any
};

/// A record grows at its end only, by whole fields of 4 bytes or more.
struct BspSectionKind {
    std::string_view name;     ///< at most 12 bytes
    std::uint32_t elementSize; ///< as it is written
    std::uint32_t minSize;     ///< as the first file with this section had it; there are no smaller ones
};

/// In the order of BspSection.
inline constexpr std::array kBspSectionKinds{
    BspSectionKind{"nodes", sizeof(KdNode), 8},
    BspSectionKind{"references", sizeof(std::uint32_t), 4},
    BspSectionKind{"vertices", sizeof(Vertex), 16},
    BspSectionKind{"triangles", sizeof(Triangle), 12},
    BspSectionKind{"shading", sizeof(ShadingTriangle), 16},
    BspSectionKind{"normals", sizeof(Vec3), 12},
    BspSectionKind{"texcoords", sizeof(Vec2), 8},
    BspSectionKind{"colours", sizeof(Colour), 12},
    BspSectionKind{"alphas", sizeof(float), 4},
    BspSectionKind{"texcoordsets", sizeof(Vec2), 8},
    BspSectionKind{"materials", sizeof(Material), 112},
    BspSectionKind{"textures", sizeof(Texture), 16},
    BspSectionKind{"texels", sizeof(Rgba8), 4},
    BspSectionKind{"lights", sizeof(Light), 80},
    BspSectionKind{"cameras", sizeof(Camera), 44},
    BspSectionKind{"parts", sizeof(ModelPart), 12},
    BspSectionKind{"strings", sizeof(char), 1},
    BspSectionKind{"warnings", sizeof(char), 1},
    BspSectionKind{"origin", sizeof(char), 1},
    BspSectionKind{"texelblocks", sizeof(TexelBlock), 32},
    BspSectionKind{"luminaires", sizeof(double), 8},
};
inline constexpr std::size_t kBspSections = kBspSectionKinds.size();

/// As PNG's: the first byte catches channels that drop the eighth bit, the line ends those that translate
/// them. No other format called .bsp begins so.
inline constexpr std::array<std::uint8_t, 8> kBspMagic{0x89, 'R', 'T', 'K', '\r', '\n', 0x1A, '\n'};
inline constexpr std::uint32_t kBspByteOrder = 0x01020304;
inline constexpr std::uint32_t kBspVersion = 6;
inline constexpr std::uint32_t kBspVersionOfBlocks = 5;      ///< written without luminaires
inline constexpr std::uint32_t kBspVersionWithoutBlocks = 4; ///< written where no texture is in blocks, too
inline constexpr std::uint64_t kBspAlignment = 64;           ///< of sections: a cache line
inline constexpr std::uint32_t kMaxBspSections = 1024;       ///< known or not
inline constexpr std::size_t kMaxBspWarningBytes = 64 * 1024;

struct BspSectionEntry {
    std::array<char, 12> name; ///< behind its end zeros
    std::uint32_t elementSize; ///< bytes, not 0
    std::uint64_t offset;      ///< of the first byte, from the start of the file
    std::uint64_t count;       ///< of elements
};

struct BspHead {
    std::array<std::uint8_t, 8> magic;
    std::uint32_t byteOrder; ///< kBspByteOrder, as the writing machine stores it
    std::uint32_t version;
    std::uint32_t headSize; ///< sizeof(BspHead); the table of sections begins there
    std::uint32_t sectionCount;
    std::uint64_t fileSize;         ///< bytes, all of the file
    std::uint64_t sourceSize;       ///< bytes of the file that the model was imported from
    std::uint32_t sourceCrc;        ///< CRC-32 of the same
    std::uint32_t buildOptionsHash; ///< of all that decides how the tree was built
    std::array<float, 3>
        boundsLo; ///< the tree's bounds, else those of all triangles; lo > hi when there are none
    std::array<float, 3> boundsHi;
    std::uint32_t hasTree;                  ///< 0 or 1
    std::uint32_t payloadCrc;               ///< CRC-32 of all bytes behind the head
    std::array<std::uint32_t, 11> reserved; ///< zero
    std::uint32_t headCrc;                  ///< CRC-32 of the head up to here
};

static_assert(sizeof(BspSectionEntry) == 32);
static_assert(sizeof(BspHead) == 2 * kBspAlignment);
static_assert(offsetof(BspHead, fileSize) == 24 && offsetof(BspHead, reserved) == 80);
static_assert(offsetof(BspHead, headCrc) == sizeof(BspHead) - 4);
static_assert(std::is_trivially_copyable_v<BspHead> &&
              std::has_unique_object_representations_v<BspSectionEntry>);

inline const BspSectionKind& kindOf(BspSection section) {
    return kBspSectionKinds[static_cast<std::size_t>(section)];
}

} // namespace rtcore

/// The head of a .bsp file of version 2, which is still read: the sections have no names but a fixed order,
/// and their elements one size.
#pragma once

#include "rtcore/io/bsp/bsp_layout.h"

namespace rtcore {

inline constexpr std::array kBspSectionsOfVersion2{
    BspSection::Nodes,     BspSection::References, BspSection::Vertices,  BspSection::Triangles,
    BspSection::Shading,   BspSection::Normals,    BspSection::Texcoords, BspSection::Colours,
    BspSection::Materials, BspSection::Textures,   BspSection::Texels,    BspSection::Lights,
    BspSection::Cameras,   BspSection::Strings,
};

struct BspSectionEntry2 {
    std::uint64_t offset, count, elementSize;
};

struct BspHead2 {
    std::array<std::uint8_t, 8> magic;
    std::uint32_t byteOrder, version, headSize, sectionCount;
    std::uint64_t fileSize, sourceSize;
    std::uint32_t sourceCrc, buildOptionsHash;
    std::array<float, 3> boundsLo, boundsHi;
    std::uint32_t hasTree, payloadCrc;
    std::array<BspSectionEntry2, kBspSectionsOfVersion2.size()> sections;
    std::array<std::uint32_t, 7> reserved;
    std::uint32_t headCrc;
};
static_assert(sizeof(BspHead2) == 448 && offsetof(BspHead2, headCrc) == 444);
// Up to the sections both heads are the same.
static_assert(offsetof(BspHead2, sections) == offsetof(BspHead, reserved));

} // namespace rtcore

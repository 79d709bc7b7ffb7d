/// Where the sections of a .bsp file lie, whichever version wrote it.
#pragma once

#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/bsp/bsp_layout.h"
#include "rtcore/math/box.h"
#include "rtcore/platform/sentence.h"

#include <string>
#include <vector>

namespace rtcore {

struct BspTable {
    std::uint32_t version = kBspVersion;
    BspIdentity identity;
    Box3 bounds;
    bool hasTree = false;
    std::vector<BspSectionEntry> sections; ///< ascending, inside the file, no name twice

    /// Null when the file has no such section.
    const BspSectionEntry* find(BspSection section) const;
};

/// Checks both checksums and everything that the table says. Throws FileError BadData; `name` stands for the
/// file.
BspTable readBspTable(std::span<const std::byte> bytes, const std::string& name);

/// Throws FileError BadData, with a remedy behind `problem`.
[[noreturn]] void failBsp(const std::string& name, const Sentence& problem);

} // namespace rtcore

/// Files of indirect light that was learned, NAME.light, so that a second visit begins with what the first
/// one ended with. Caches: they may be deleted at any time.
#pragma once

#include "rtcore/gathering/indirect_state.h"
#include "rtcore/io/light/light_key.h"
#include "rtcore/platform/sentence.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace rtcore {

/// Whether a file is of a scene.
enum class LightMatch {
    OtherSurfaces,
    OtherLight, ///< on the same surfaces
    Same        ///< IndirectLight::restore()
};

struct LightFile {
    LightMatch match = LightMatch::OtherSurfaces;
    IndirectState light; ///< empty where it is of another scene
};

/// The size of a file of so many records and cells.
std::uint64_t lightFileBytes(std::size_t records, std::size_t cells);

/// Writes by writeFileAtomically(): a reader sees the old file or all of the new one, whenever the writer is
/// killed. The same light gives the same bytes.
/// Throws FileError: CannotWrite, and BadData where readLightFile() would refuse the file.
void writeLightFile(const std::filesystem::path& path, const LightKey& key, const IndirectState& light);

/// Reads what was learned of the scene of that key. All of the file is checked: its size before anything is
/// allocated, its checksum, each number, and what checkIndirectState() asks. Throws FileError: NoInput, and
/// BadData that tells to delete the file.
LightFile readLightFile(const std::filesystem::path& path, const LightKey& key);

/// The same for bytes that are in memory; `name` stands for the file in messages.
LightFile readLightFile(std::span<const std::byte> bytes, const LightKey& key, const std::string& name);

/// The warning where a file is asked for by settings that images are not lit by any of.
Sentence lightIsUnused(const std::filesystem::path& path);

} // namespace rtcore

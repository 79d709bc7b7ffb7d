/// The repeated sections of a .scn, each read and written side by side in a file of its own.
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/io/text/strict_table.h"
#include "rtcore/io/text/toml_writer.h"

namespace rtcore {

/// The readers call table.finish() and throw FileError BadData. `folder` is where relative paths start.
LightDescription readLight(StrictTable& table);
MaterialOverride readMaterial(StrictTable& table, const std::filesystem::path& folder);
EnvironmentFile readEnvironment(StrictTable& table, const std::filesystem::path& folder);

/// The writers check nothing.
void writeLight(TomlWriter& writer, const LightDescription& description);
void writeMaterial(TomlWriter& writer, const MaterialOverride& material, const std::filesystem::path& folder);
void writeEnvironment(TomlWriter& writer, const EnvironmentFile& environment,
                      const std::filesystem::path& folder);

} // namespace rtcore

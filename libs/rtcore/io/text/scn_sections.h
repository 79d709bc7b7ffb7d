/// Sections of a .scn, each read and written side by side in a file of its own.
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/io/text/strict_table.h"
#include "rtcore/io/text/toml_writer.h"

namespace rtcore {

/// Selects the parts or materials of the model that a section is for.
struct NameOrNumber {
    std::optional<std::string> name; ///< a pattern
    std::optional<int> number;       ///< counted from 1; since version 2
    std::string_view what;           ///< for errors

    /// Checks that exactly one is given, and not "".
    void check(const StrictTable& table) const;
};
NameOrNumber readNameOrNumber(StrictTable& table, std::string_view what);

/// The readers call table.finish() and throw FileError BadData. `folder` is where relative paths start.
LightDescription readLight(StrictTable& table, const std::filesystem::path& folder);
MaterialOverride readMaterial(StrictTable& table, const std::filesystem::path& folder);
PartDescription readPart(StrictTable& table);
EnvironmentFile readEnvironment(StrictTable& table, const std::filesystem::path& folder);
/// All [[section]] of the root, and what light knows of them.
SectionPlanes readSectionPlanes(StrictTable& root);
Sky readSky(StrictTable& table, const Sky& usual = {});

/// All [[measure]] of the root, and the unit of their labels.
KeptMeasures readMeasures(StrictTable& root);
/// All [[note]] of the root; `up` as in readCamera().
SceneNotes readNotes(StrictTable& root, Vec3 up);
/// All [[bookmark]] of the root; `up` as in readCamera().
SceneBookmarks readBookmarks(StrictTable& root, Vec3 up);
/// All [[flight]] of the root; the same.
Flights readFlights(StrictTable& root, Vec3 up);

/// All [[variant]] of the root.
SceneVariants readVariants(StrictTable& root, const std::filesystem::path& folder);
/// [shown] of the root.
std::optional<SceneVariant> readShown(StrictTable& root, const std::filesystem::path& folder);

/// The writers check nothing. Positions of a light and of a flight are written in the coordinates in which
/// that of the scene's zero is `zero`.
void writeLight(TomlWriter& writer, const LightDescription& description, const std::filesystem::path& folder,
                const LocalOrigin& zero = {}, std::string_view header = "[[light]]");
void writeMaterial(TomlWriter& writer, const MaterialOverride& material, const std::filesystem::path& folder,
                   std::string_view header = "[[material]]");
void writePart(TomlWriter& writer, const PartDescription& part, std::string_view header = "[[part]]");
void writeEnvironment(TomlWriter& writer, const EnvironmentFile& environment,
                      const std::filesystem::path& folder);
void writeSectionStyle(TomlWriter& writer, const SectionPlanes& sections);
void writeSectionPlane(TomlWriter& writer, const SectionPlane& plane);
void writeMeasureStyle(TomlWriter& writer, const KeptMeasures& measures);
void writeMeasure(TomlWriter& writer, const KeptMeasure& measure);
void writeNote(TomlWriter& writer, const SceneNote& note);
void writeSky(TomlWriter& writer, const Sky& sky, std::string_view header = "[sky]");
void writeBookmark(TomlWriter& writer, const SceneBookmark& bookmark);
void writeFlight(TomlWriter& writer, const Flight& flight, const LocalOrigin& zero = {});
/// As a [[variant]]; without a name, as [shown].
void writeVariant(TomlWriter& writer, const SceneVariant& variant, const std::filesystem::path& folder,
                  const LocalOrigin& zero = {});

} // namespace rtcore

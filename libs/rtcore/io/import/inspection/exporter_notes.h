/// Notes in a model's file on the program that wrote it, and on its unit, in places that importers pass over.
#pragma once

#include "rtcore/scene/model_origin.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

/// The comments at the beginning of an OBJ file, or of its material library where it has none; those of a PLY
/// file; the name of an ASCII STL file and the head of a binary one; "" of other formats. One line.
std::string exporterNotes(const std::filesystem::path& path);

/// The comments at the beginning of the text of an OBJ file or a material library, as one line.
std::string openingComments(std::string_view text);

/// A unit that such notes state: "File units = inches", "units: mm". Nothing when they do not.
std::optional<double> statedUnit(const std::string& notes);

/// Reads axis and unit where the format leaves no choice: AMF. Leaves `origin` as it is for others.
void readFixedUnits(const std::filesystem::path& path, ModelOrigin& origin);

} // namespace rtcore

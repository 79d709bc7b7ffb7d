/// Where a model comes from: what its file, its format and the program that wrote it say of it.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/scene/local_origin.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

struct ModelOrigin {
    std::string format;     ///< the importer's name for it, as "Wavefront Object Importer"; "" = unknown
    std::string exporter;   ///< in the words of the program that wrote it, one line; "" = it says nothing
    std::optional<Vec3> up; ///< one of the six axes, as imported, where the format fixes it
    std::optional<double> metresPerUnit; ///< above 0, as imported, where the format or the file says it
    LocalOrigin zero = {};               ///< of the model, in the coordinates of its file
    friend bool operator==(const ModelOrigin&, const ModelOrigin&) = default;
};

inline constexpr std::size_t kMaxOriginBytes = 4096;

/// Lines "name value", each ended by a line feed, at most kMaxOriginBytes; what is not printable becomes
/// '?'.
std::string writeOrigin(const ModelOrigin& origin);
/// Takes one such line; false, and nothing changed, when it is none.
bool readOriginLine(std::string_view line, ModelOrigin& origin);
/// Takes any text: lines that it does not know are skipped.
ModelOrigin readOrigin(std::string_view text);

} // namespace rtcore

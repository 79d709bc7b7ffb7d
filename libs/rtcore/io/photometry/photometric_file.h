/// Photometric files of luminaires: IES LM-63 and EULUMDAT.
#pragma once

#include "rtcore/platform/sentence.h"
#include "rtcore/scene/photometry.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

struct PhotometricFile {
    PhotometricWeb web;
    std::vector<Sentence> warnings; ///< what of the file does not count
};

/// Larger files are refused.
inline constexpr std::size_t kMaxPhotometricBytes = std::size_t{4} << 20;

/// Which of the formats it is, its content tells: IES files have a line that begins with TILT=.
/// Throws FileError NoInput, or BadData with the line.
PhotometricFile readPhotometricFile(const std::filesystem::path& path);
/// The same from memory; `name` is named in errors.
PhotometricFile parsePhotometricFile(std::string_view text, const std::string& name);

/// LM-63 of 1986, 1991, 1995, 2002 and 2019, type C, with TILT=NONE and TILT=INCLUDE, whose factors are left
/// out, since they are of other positions; a tilt in a file of its own gives a warning.
PhotometricFile parseIes(std::string_view text, const std::string& name);
/// EULUMDAT (Stockmar 1990), with the light sources that it lists first.
PhotometricFile parseEulumdat(std::string_view text, const std::string& name);

} // namespace rtcore

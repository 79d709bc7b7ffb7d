#include "rtcore/io/photometry/photometric_file.h"

#include "rtcore/io/photometry/photometric_numbers.h"
#include "rtcore/platform/files.h"

namespace rtcore {

namespace {

bool isIes(std::string_view text) {
    for (PhotometricLines lines(text, ""); const auto line = lines.next();)
        if (line->starts_with("TILT=")) return true;
    return false;
}

} // namespace

PhotometricFile parsePhotometricFile(std::string_view text, const std::string& name) {
    return isIes(text) ? parseIes(text, name) : parseEulumdat(text, name);
}

PhotometricFile readPhotometricFile(const std::filesystem::path& path) {
    return parsePhotometricFile(readTextFile(path, kMaxPhotometricBytes), path.string());
}

} // namespace rtcore

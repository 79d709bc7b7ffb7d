/// Clouds of points in files of text: XYZ and PTS.
#pragma once

#include "rtcore/io/import/import_report.h"
#include "rtcore/io/import/scan/scan_mesh.h"
#include "rtcore/platform/files.h"

#include <filesystem>
#include <functional>

namespace rtcore {

/// A point on each line: x, y and z, then - told by the first lines of the file - nothing, an intensity, a
/// colour, a normal, or several of these. Numbers are parted by blanks, commas or semicolons. Colours count
/// to 1, 255 or 65535; where there is none, the intensity is a grey. Lines of one number (PTS says by these
/// how many follow), comments and a line of names at the beginning are passed over; others that are no points
/// cost themselves alone, with a warning. More than kMaxPoints are counted only. Throws FileError BadData for
/// what holds none and for molecules, which are called .xyz, too; what InputFile throws; and std::bad_alloc.
/// `origin` is taken off the positions. `alive` is called now and then.
struct PointText {
    ScanMesh points;
    std::uint64_t count = 0; ///< of the file
};
PointText readPointText(const std::filesystem::path& path, const LocalOrigin& origin, ImportReport& report,
                        const std::function<void()>& alive);

} // namespace rtcore

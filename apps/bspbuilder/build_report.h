/// BSPBuilder's reports on a build, for -v, -vv and -hist.
#pragma once

#include "rtcore/accel/build_options.h"
#include "rtcore/accel/statistics.h"
#include "rtcore/platform/sentence.h"

#include <cstdint>
#include <optional>
#include <string>

namespace bspbuilder {

struct BuildReport {
    std::string format;            ///< of the model's file, as the importer calls it
    std::uint64_t triangles = 0;   ///< kept
    std::uint64_t degenerate = 0;  ///< dropped by the import: without area
    std::uint64_t nonFinite = 0;   ///< dropped: a coordinate is no number, or far too large
    std::uint64_t unconnected = 0; ///< dropped: a corner that does not exist
    std::uint64_t equal = 0;       ///< dropped: the third and further of equal ones
    std::uint64_t primitives = 0;  ///< dropped: points and lines
    std::uint64_t vertices = 0, materials = 0, textures = 0, lights = 0, cameras = 0;
    double importSeconds = 0, writeSeconds = 0;
    rtcore::BuildTimes build;
    std::uint64_t fileBytes = 0;
    std::uint64_t peakBytes = 0; ///< of this process' memory
};

/// Findings of the checks of the tree; none when it passed.
struct TreeVerdict {
    std::optional<rtcore::Sentence> structure, coverage;
    double seconds = 0;

    bool sound() const { return !structure && !coverage; }
};

/// -v: the model and the times.
std::string describeModel(const BuildReport& report);
/// -vv: the tree, each phase, and the verdict.
std::string describeTree(const BuildReport& report, const rtcore::KdStatistics& statistics,
                         const TreeVerdict& verdict);
/// -hist.
std::string describeLeaves(const rtcore::KdStatistics& statistics, int bands);

} // namespace bspbuilder

#include "bspbuilder/build_report.h"

#include <fmt/core.h>

namespace bspbuilder {

namespace {

constexpr int kLabelWidth = 25;

template <typename Value>
std::string line(const std::string& label, const Value& value) {
    return fmt::format("{:<{}}{}\n", label + ":", kLabelWidth, value);
}

std::string decimals(double value, int digits) { return fmt::format("{:.{}f}", value, digits); }
std::string seconds(double value) { return fmt::format("{:.3f} s", value); }
std::string megabytes(std::uint64_t bytes) {
    return fmt::format("{:.2f} MB", static_cast<double>(bytes) / 1e6);
}

std::string describe(const std::optional<rtcore::Sentence>& problem) {
    return problem ? "WRONG: " + problem->english() : "sound";
}

} // namespace

std::string describeModel(const BuildReport& report) {
    return line("format", report.format) + line("triangles", report.triangles) +
           line("dropped: no area", report.degenerate) + line("dropped: not finite", report.nonFinite) +
           line("dropped: no corner", report.unconnected) + line("dropped: copies", report.equal) +
           line("dropped: points, lines", report.primitives) + line("vertices", report.vertices) +
           line("materials", report.materials) + line("textures", report.textures) +
           line("lights", report.lights) + line("cameras", report.cameras) +
           line("import", seconds(report.importSeconds)) + line("tree", seconds(report.build.total())) +
           line("write", seconds(report.writeSeconds)) + line("file", megabytes(report.fileBytes));
}

std::string describeTree(const BuildReport& report, const rtcore::KdStatistics& statistics,
                         const TreeVerdict& verdict) {
    return line("tree: prepare", seconds(report.build.prepare)) +
           line("tree: split", seconds(report.build.split)) + line("tree: emit", seconds(report.build.emit)) +
           line("nodes", statistics.nodes) + line("leaves", statistics.leaves) +
           line("empty leaves", statistics.emptyLeaves) + line("depth", statistics.depth) +
           line("average leaf depth", decimals(statistics.averageLeafDepth, 2)) +
           line("references", statistics.references) + line("largest leaf", statistics.largestLeaf) +
           line("average filled leaf", decimals(statistics.averageFilledLeaf, 2)) +
           line("expected cost", decimals(statistics.expectedCost, 3)) +
           line("tree memory", megabytes(statistics.bytes)) +
           line("peak memory", megabytes(report.peakBytes)) +
           line("check: structure", describe(verdict.structure)) +
           line("check: coverage", describe(verdict.coverage)) + line("checks", seconds(verdict.seconds));
}

std::string describeLeaves(const rtcore::KdStatistics& statistics, int bands) {
    return rtcore::drawHistogram("Leaves by number of triangles", statistics.leavesBySize, bands) +
           rtcore::drawHistogram("Leaves by depth", statistics.leavesByDepth, bands);
}

} // namespace bspbuilder

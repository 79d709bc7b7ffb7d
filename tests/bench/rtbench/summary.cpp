#include "bench/rtbench/summary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace rtbench {

namespace {

// Both of several values, not of none.
double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}
double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

} // namespace

std::optional<double> geometricMean(std::span<const SceneFigures> scenes,
                                    const std::function<std::vector<double>(const SceneFigures&)>& ratios,
                                    OfViews ofViews) {
    std::map<std::string, std::vector<double>> logarithms;
    for (const SceneFigures& scene : scenes) {
        for (const double ratio : ratios(scene)) {
            if (ratio > 0) logarithms[scene.scene].push_back(std::log(ratio));
        }
    }
    if (logarithms.empty()) return std::nullopt;
    double all = 0;
    for (const auto& [scene, views] : logarithms)
        all += ofViews == OfViews::Median ? median(views) : mean(views);
    return std::exp(all / static_cast<double>(logarithms.size()));
}

std::optional<double> meanRatio(std::span<const SceneFigures> scenes, const RayTest& test, bool robust,
                                OfViews ofViews) {
    const auto ratiosOf = [&](const SceneFigures& scene) {
        std::vector<double> ratios;
        for (const RayFigures& rays : scene.rays) {
            const auto& rival = robust ? rays.robust : rays.best;
            if (rays.test == &test && rival) ratios.push_back(rival->ratio);
        }
        return ratios;
    };
    return geometricMean(scenes, ratiosOf, ofViews);
}

std::optional<double> meanFrameRatio(std::span<const SceneFigures> scenes, const std::string& kind,
                                     int threads) {
    return geometricMean(scenes, [&](const SceneFigures& scene) {
        std::vector<double> ratios;
        for (const FrameFigures& frame : scene.frames) {
            if (frame.kind == kind && frame.threads == threads) ratios.push_back(frame.ratio());
        }
        return ratios;
    });
}

std::vector<std::pair<std::string, int>> frameKinds(std::span<const SceneFigures> scenes) {
    std::vector<std::pair<std::string, int>> kinds;
    for (const SceneFigures& scene : scenes) {
        for (const FrameFigures& frame : scene.frames) {
            const std::pair kind{frame.kind, frame.threads};
            if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
        }
    }
    return kinds;
}

} // namespace rtbench

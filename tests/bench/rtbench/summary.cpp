#include "bench/rtbench/summary.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rtbench {

std::optional<double> geometricMean(std::span<const SceneFigures> scenes,
                                    const std::function<std::vector<double>(const SceneFigures&)>& ratios) {
    struct Sum {
        double logarithms = 0;
        int count = 0;
    };
    std::map<std::string, Sum> sums;
    for (const SceneFigures& scene : scenes) {
        for (const double ratio : ratios(scene)) {
            if (!(ratio > 0)) continue;
            Sum& sum = sums[scene.scene];
            sum.logarithms += std::log(ratio);
            ++sum.count;
        }
    }
    if (sums.empty()) return std::nullopt;
    double all = 0;
    for (const auto& [scene, sum] : sums) all += sum.logarithms / sum.count;
    return std::exp(all / static_cast<double>(sums.size()));
}

std::optional<double> meanRatio(std::span<const SceneFigures> scenes, const RayTest& test, bool robust) {
    return geometricMean(scenes, [&](const SceneFigures& scene) {
        std::vector<double> ratios;
        for (const RayFigures& rays : scene.rays) {
            const auto& rival = robust ? rays.robust : rays.best;
            if (rays.test == &test && rival) ratios.push_back(rival->ratio);
        }
        return ratios;
    });
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

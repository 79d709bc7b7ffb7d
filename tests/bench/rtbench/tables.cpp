#include "bench/rtbench/tables.h"

#include "bench/rtbench/summary.h"

#include <cstdarg>
#include <cstdio>
#include <initializer_list>

namespace rtbench {

namespace {

[[gnu::format(printf, 1, 2)]] std::string print(const char* format, ...) {
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

std::string rayLine(const RayFigures& f) {
    std::string line = print("  %-8s %9zu %8.2f", std::string(f.test->name).c_str(), f.rays, f.speed);
    for (const auto& rival : {f.best, f.robust}) {
        line += rival ? print("  %8.2f %-21s %5.2f %6zu", rival->speed, rival->mode.c_str(), rival->ratio,
                              rival->differences)
                      : "";
    }
    return line + print("  %5.1f %%\n", 100 * f.spread);
}

std::string modeLines(const RayFigures& f) {
    std::string lines;
    for (const Rival& mode : f.modes) {
        lines += print("    %-21s %8.2f  ratio %5.2f  differ %zu\n", mode.mode.c_str(), mode.speed,
                       mode.ratio, mode.differences);
    }
    return lines;
}

std::string rayHeading(const RayFigures& f) {
    std::string line = print("  %-8s %9s %8s", "Mrays/s", "rays", "ours");
    if (f.best) line += print("  %8s %-21s %5s %6s", "Embree", "best mode", "ratio", "differ");
    if (f.robust) line += print("  %8s %-21s %5s %6s", "Embree", "best robust mode", "ratio", "differ");
    return line + "   spread\n";
}

std::string frameLine(const FrameFigures& f) {
    const auto fps = [](const FrameTimes& times) { return 1 / times.best; };
    std::string line = print("  %-8s %7d %8.2f %8.2f %7.1f", f.kind.c_str(), f.threads, 1e3 * f.ours.best,
                             1e3 * f.ours.median, fps(f.ours));
    if (f.embree) {
        line += print("  %8.2f %8.2f %7.1f  %5.2f %6zu", 1e3 * f.embree->best, 1e3 * f.embree->median,
                      fps(*f.embree), f.ratio(), f.differentPixels);
    }
    return line + "\n";
}

std::string frameHeading(const FrameFigures& f) {
    std::string line = print("  %-8s %7s %8s %8s %7s", "frames", "threads", "ours ms", "median", "fps");
    if (f.embree) line += print("  %8s %8s %7s  %5s %6s", "Embree", "median", "fps", "ratio", "differ");
    return line + "\n";
}

std::string treesLine(const std::vector<TreeFigures>& trees) {
    std::string line = "  bytes a triangle:";
    for (const TreeFigures& tree : trees) {
        line += print("%s %s %.0f", &tree == trees.data() ? "" : ",", tree.name.c_str(), tree.bytes);
    }
    return line + "\n";
}

std::string meanLine(const std::string& name, std::initializer_list<std::optional<double>> means) {
    std::string line = print("  %-20s", name.c_str());
    for (const auto& mean : means) line += mean ? print(" %12.3f", *mean) : print(" %12s", "");
    while (line.ends_with(' ')) line.pop_back();
    return line + "\n";
}

} // namespace

std::string sceneTable(const SceneFigures& scene, bool modes) {
    std::string text = print("%s: %zu triangles, headlight\n", scene.name().c_str(), scene.triangles);
    if (!scene.rays.empty()) text += rayHeading(scene.rays.front());
    for (const RayFigures& figures : scene.rays) {
        text += rayLine(figures);
        if (modes) text += modeLines(figures);
    }
    if (!scene.frames.empty()) text += frameHeading(scene.frames.front());
    for (const FrameFigures& figures : scene.frames) text += frameLine(figures);
    if (!scene.trees.empty()) text += treesLine(scene.trees);
    return text + "\n";
}

std::string meansTable(std::span<const SceneFigures> scenes) {
    std::string lines;
    for (const RayTest& test : kRayTests) {
        if (const auto mean = meanRatio(scenes, test, false)) {
            lines += meanLine(std::string(test.name), {mean, meanRatio(scenes, test, true),
                                                       meanRatio(scenes, test, false, OfViews::Median),
                                                       meanRatio(scenes, test, true, OfViews::Median)});
        }
    }
    for (const auto& [kind, threads] : frameKinds(scenes)) {
        const auto mean = meanFrameRatio(scenes, kind, threads);
        const std::string name = "frame " + kind + ", " + std::to_string(threads) + " thr.";
        if (mean) lines += meanLine(name, {std::nullopt, mean});
    }
    if (lines.empty()) return "";
    return print("%-22s %12s %12s %12s %12s\n", "geometric means", "ratio best", "ratio robust",
                 "median best", "robust") +
           lines;
}

} // namespace rtbench

#include "bench/rtbench/json_report.h"

#include "bench/rtbench/summary.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace rtbench {

namespace {

using Json = nlohmann::ordered_json;

/// The digits that a reader can use; the noise has more.
Json rounded(double value) { return std::round(value * 1e4) / 1e4; }

Json rayJson(const RayFigures& f) {
    Json json;
    json["ours"] = rounded(f.speed);
    json["embree"] = f.best ? rounded(f.best->speed) : Json();
    json["mode"] = f.best ? Json(f.best->mode) : Json();
    json["ratio"] = f.best ? rounded(f.best->ratio) : Json();
    json["ratioRobust"] = f.robust ? rounded(f.robust->ratio) : Json();
    json["spread"] = rounded(f.spread);
    return json;
}

Json frameJson(const FrameFigures& f) {
    Json json;
    json["ours"] = rounded(1e3 * f.ours.best);
    json["oursMedian"] = rounded(1e3 * f.ours.median);
    json["embree"] = f.embree ? rounded(1e3 * f.embree->best) : Json();
    json["embreeMedian"] = f.embree ? rounded(1e3 * f.embree->median) : Json();
    json["ratio"] = f.embree ? rounded(f.ratio()) : Json();
    json["fps"] = rounded(1 / f.ours.best);
    return json;
}

Json meansJson(std::span<const SceneFigures> scenes, bool robust, OfViews ofViews) {
    Json means = Json::object();
    for (const RayTest& test : kRayTests) {
        if (const auto mean = meanRatio(scenes, test, robust, ofViews))
            means[std::string(test.name)] = rounded(*mean);
    }
    return means;
}

Json framesJson(std::span<const SceneFigures> scenes) {
    Json json{{"scenes", Json::array()}, {"geomean", Json::object()}};
    for (const SceneFigures& scene : scenes) {
        Json one{{"name", scene.name()}};
        for (const FrameFigures& f : scene.frames) one[f.kind][std::to_string(f.threads)] = frameJson(f);
        json["scenes"].push_back(std::move(one));
    }
    for (const auto& [kind, threads] : frameKinds(scenes)) {
        const auto mean = meanFrameRatio(scenes, kind, threads);
        if (mean) json["geomean"][kind][std::to_string(threads)] = rounded(*mean);
    }
    return json;
}

} // namespace

std::string jsonReport(std::span<const SceneFigures> scenes) {
    Json json{{"scenes", Json::array()}};
    for (const SceneFigures& scene : scenes) {
        Json rays = Json::object();
        for (const RayFigures& f : scene.rays) rays[std::string(f.test->name)] = rayJson(f);
        json["scenes"].push_back(Json{{"name", scene.name()},
                                      {"triangles", scene.triangles},
                                      {"look", "headlight"},
                                      {"rays", std::move(rays)}});
        for (const TreeFigures& tree : scene.trees)
            json["scenes"].back()["bytesPerTriangle"][tree.name] = rounded(tree.bytes);
    }
    json["geomean"] = meansJson(scenes, false, OfViews::Mean);
    json["geomeanRobust"] = meansJson(scenes, true, OfViews::Mean);
    json["geomeanOfMedians"] = meansJson(scenes, false, OfViews::Median);
    json["geomeanOfMediansRobust"] = meansJson(scenes, true, OfViews::Median);
    if (!frameKinds(scenes).empty()) json["frames"] = framesJson(scenes);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace rtbench

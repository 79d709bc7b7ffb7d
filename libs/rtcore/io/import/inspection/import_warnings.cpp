#include "rtcore/io/import/inspection/import_warnings.h"

#include "rtcore/accel/float4.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/mesh/equal_positions.h"
#include "rtcore/math/box.h"
#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <vector>

namespace rtcore {

namespace {

bool isInvisible(const Material& m) {
    return m.opacity == 0 && m.indexOfRefraction == 1 && m.transmission == kWhite && isBlack(m.emission);
}

Box3 boundsOfAll(std::span<const Vertex> vertices) {
    Bounds4 all{set4(Box3::kHuge), set4(-Box3::kHuge)};
    for (const Vertex& v : vertices) {
        const Float4 position = load4(&v);
        all = extended(all, {position, position});
    }
    return boxOf(all);
}

Vec3 positionOf(const Vertex& v) { return v.position(); }
Vec3 positionOf(Vec3 p) { return isUsablePosition(p) ? p : Vec3{}; }

template <typename Point>
Box3 bulkOfAll(std::span<const Point> points) {
    constexpr std::size_t kMaxSamples = 20'000;
    const std::size_t step = points.size() / kMaxSamples + 1;
    Vec3 lo, hi;
    std::vector<float> values;
    for (int axis = 0; axis < 3; ++axis) {
        values.clear();
        for (std::size_t i = 0; i < points.size(); i += step) values.push_back(positionOf(points[i])[axis]);
        std::sort(values.begin(), values.end());
        lo[axis] = values[values.size() / 20];
        hi[axis] = values[values.size() - 1 - values.size() / 20];
    }
    return {lo, hi};
}

} // namespace

void warnOfLostTriangles(const ModelBuffers& model, ImportReport& report) {
    const std::uint64_t damaged = report.nonFiniteTriangles + report.unconnectedTriangles;
    const std::uint64_t lost = damaged + report.degenerateTriangles;
    const std::uint64_t all = lost + model.triangles.size() + report.equalTriangles;
    // Triangles without area cover nothing, and strips are sewn together by some; half of all is a sign of
    // damage.
    if (damaged > 0 || report.degenerateTriangles > all / 2) {
        std::optional<Sentence> why;
        const auto add = [&](std::uint64_t count, const char* form) {
            if (count == 0) return;
            const Sentence each = say(form, count);
            why = why ? say(import_forms::kComma, *why, each) : each;
        };
        add(report.nonFiniteTriangles, import_forms::kNoNumbers);
        add(report.unconnectedTriangles, import_forms::kNoCorners);
        add(report.degenerateTriangles, import_forms::kNoArea);
        const char* const form = all == 1    ? import_forms::kOnlyDamaged
                                 : lost == 1 ? import_forms::kOneDamaged
                                             : import_forms::kDamaged;
        addWarning(report, say(form, lost, all, why.value_or(Sentence())));
    }
    if (report.equalTriangles > 0) {
        const bool one = report.equalTriangles == 1;
        addWarning(report, say(one ? import_forms::kOneEqual : import_forms::kEqual, report.equalTriangles));
    }
}

void warnOfMissingTextures(std::span<const std::string> names, ImportReport& report) {
    if (names.size() == 1) {
        addWarning(report, say(import_forms::kMissingTexture, firstOf(names)));
    } else if (names.size() > 1) {
        addWarning(report, say(import_forms::kMissingTextures, names.size(), firstOf(names)));
    }
}

void warnWhenInvisible(const ModelBuffers& model, ImportReport& report) {
    const bool invisible =
        std::all_of(model.shading.begin(), model.shading.end(),
                    [&](const ShadingTriangle& t) { return isInvisible(model.materials[t.material]); });
    if (invisible) addWarning(report, import_forms::kInvisible);
}

Box3 bulkOf(std::span<const Vertex> vertices) { return bulkOfAll(vertices); }
Box3 bulkOf(std::span<const Vec3> positions) { return bulkOfAll(positions); }

void warnOfCoarseness(double coarseness, const ModelBuffers& model, ImportReport& report) {
    constexpr double kFine = 1e-6;
    const Vec3 size = boundsOfAll(model.vertices).size();
    if (coarseness <= kFine * double{std::max({size.x, size.y, size.z})}) return;
    addWarning(report, say(import_forms::kCoarse, fmt::format("{:.2g}", coarseness)));
}

void warnOfOutliers(const ModelBuffers& model, ImportReport& report) {
    constexpr float kInvisible = 100'000; // times smaller: less than a pixel
    const Box3 bounds = boundsOfAll(model.vertices);
    const float bulk = bulkOf(model.vertices).diagonal();
    if (bulk * kInvisible >= bounds.diagonal()) return;
    addWarning(report, import_forms::kOutliers);
}

} // namespace rtcore

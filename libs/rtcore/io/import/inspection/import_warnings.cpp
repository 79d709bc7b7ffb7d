#include "rtcore/io/import/inspection/import_warnings.h"

#include "rtcore/accel/float4.h"
#include "rtcore/math/box.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <vector>

namespace rtcore {

namespace {

std::string counted(std::uint64_t count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

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

/// Without the outermost twentieth on each side of each axis.
Box3 bulkOf(std::span<const Vertex> vertices) {
    constexpr std::size_t kMaxSamples = 20'000;
    const std::size_t step = vertices.size() / kMaxSamples + 1;
    Vec3 lo, hi;
    std::vector<float> values;
    for (int axis = 0; axis < 3; ++axis) {
        values.clear();
        for (std::size_t i = 0; i < vertices.size(); i += step)
            values.push_back(vertices[i].position()[axis]);
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
        std::string why;
        const auto add = [&](std::uint64_t count, const char* what) {
            if (count > 0) why += fmt::format("{}{}{}", why.empty() ? "" : ", ", count, what);
        };
        add(report.nonFiniteTriangles, " with coordinates that are no numbers or beyond 1e12");
        add(report.unconnectedTriangles, " with corners that do not exist");
        add(report.degenerateTriangles, " without area");
        addWarning(report,
                   fmt::format("{} of {} {} damaged and left out: {}", lost,
                               counted(all, "triangle", "triangles"), lost == 1 ? "was" : "were", why));
    }
    if (report.equalTriangles > 0) {
        addWarning(report, counted(report.equalTriangles, "triangle is", "triangles are") +
                               " the third or a further one of the same corners and left out");
    }
}

void warnOfMissingTextures(std::span<const std::string> names, ImportReport& report) {
    if (names.size() == 1) {
        addWarning(report, "texture '" + names[0] + "' is missing; its material is plain");
    } else if (names.size() > 1) {
        addWarning(report, fmt::format("{} textures are missing, so their materials are plain: {}",
                                       names.size(), firstOf(names)));
    }
}

void warnWhenInvisible(const ModelBuffers& model, ImportReport& report) {
    const bool invisible =
        std::all_of(model.shading.begin(), model.shading.end(),
                    [&](const ShadingTriangle& t) { return isInvisible(model.materials[t.material]); });
    if (invisible)
        addWarning(report,
                   "every material is fully transparent, so nothing can be seen; give them an opacity");
}

void warnOfOutliers(const ModelBuffers& model, ImportReport& report) {
    constexpr float kInvisible = 100'000; // times smaller: less than a pixel
    const Box3 bounds = boundsOfAll(model.vertices);
    const float bulk = bulkOf(model.vertices).diagonal();
    if (bulk * kInvisible >= bounds.diagonal()) return;
    addWarning(report,
               "a few vertices lie more than 100000 times as far off as all others, which are too small "
               "to be seen beside them; remove them or place the camera yourself");
}

} // namespace rtcore

#include "rtcore/survey/seen_object.h"

#include <algorithm>
#include <cstddef>

namespace rtcore {

namespace {

std::optional<std::uint32_t> pieceOf(const Model& model, std::uint32_t triangle) {
    const auto behind =
        std::upper_bound(model.parts.begin(), model.parts.end(), triangle,
                         [](std::uint32_t t, const ModelPart& part) { return t < part.firstTriangle; });
    // Empty parts begin where the next one does.
    for (auto part = behind; part != model.parts.begin();) {
        --part;
        if (triangle - part->firstTriangle < part->triangleCount)
            return static_cast<std::uint32_t>(part - model.parts.begin());
        if (part->triangleCount > 0) break;
    }
    return {};
}

std::optional<SeenObject> objectOf(const Scene& scene, const HitWave& hits, std::size_t i) {
    const std::uint32_t triangle = hits.triangle[i];
    if (!hits.isHit(i) || triangle >= scene.model.mesh.triangles.size()) return {};
    return SeenObject{scene.mesh().shading[triangle].material, pieceOf(scene.model, triangle)};
}

} // namespace

std::optional<SeenObject> seenObject(const Scene& scene, const RayTracer& tracer, const CameraRays& view,
                                     float x, float y) {
    RayWave ray;
    HitWave hit;
    ray.push(view.at(x, y));
    tracer.intersect(RayKind::Primary, ray, hit);
    return objectOf(scene, hit, 0);
}

std::vector<std::optional<SeenObject>> seenObjects(const Scene& scene, const RayTracer& tracer,
                                                   const CameraRays& view, int width, int height) {
    const auto columns = static_cast<std::size_t>(width);
    std::vector<std::optional<SeenObject>> seen(columns * static_cast<std::size_t>(height));
#pragma omp parallel
    {
        RayWave rays;
        HitWave hits;
#pragma omp for schedule(dynamic, 8)
        for (int row = 0; row < height; ++row) {
            rays.clear();
            for (int column = 0; column < width; ++column)
                rays.push(view.at(static_cast<float>(column) + 0.5F, static_cast<float>(row) + 0.5F));
            tracer.intersect(RayKind::Primary, rays, hits);
            for (std::size_t i = 0; i < columns; ++i)
                seen[static_cast<std::size_t>(row) * columns + i] = objectOf(scene, hits, i);
        }
    }
    return seen;
}

} // namespace rtcore

#include "rtcore/sections/uncut_cover.h"

#include "rtcore/accel/visible_tree.h"
#include "rtcore/kernels/section_clip.h"
#include "rtcore/platform/task_errors.h"
#include "rtcore/render/camera_rays.h"

#include <vector>

namespace rtcore {

namespace {

Box3 boundsOf(const Mesh& mesh) {
    Box3 bounds;
    for (const Vertex& vertex : mesh.vertices) bounds.extend(vertex.position());
    return bounds;
}

KdTree treeOf(const Scene& scene) {
    std::vector<std::uint8_t> others = partTriangles(scene.model, scene.uncutParts);
    const std::vector<std::uint8_t> hidden = partTriangles(scene.model, scene.hiddenParts);
    for (std::size_t i = 0; i < others.size(); ++i) others[i] = others[i] == 0 || hidden[i] != 0 ? 1 : 0;
    return buildVisibleTree(scene.model.mesh, others, boundsOf(scene.model.mesh));
}

/// Where rays of pixels enter what sections leave, and whether a part stands before that.
class RowCover {
  public:
    RowCover(const RayTracer& parts, const SectionClip& clip, const CameraRays& camera)
        : parts_(parts), clip_(clip), camera_(camera) {}

    void restore(int row, const LdrImage& before, LdrImage& image) {
        constexpr float kMiddle = 0.5F;
        rays_.clear();
        columns_.clear();
        for (int x = 0; x < image.width; ++x) {
            if (image.at(x, row) == before.at(x, row)) continue;
            Ray ray = camera_.at(static_cast<float>(x) + kMiddle, static_cast<float>(row) + kMiddle);
            const Ray whole = ray;
            clip_.clip(whole, ray.tMin, ray.tMax);
            ray.tMax = ray.tMin; // where the cap is
            ray.tMin = whole.tMin;
            rays_.push(ray);
            columns_.push_back(x);
        }
        if (columns_.empty()) return;
        parts_.occluded(RayKind::Primary, rays_, covered_);
        for (std::size_t i = 0; i < columns_.size(); ++i)
            if (covered_[i] != 0) image.at(columns_[i], row) = before.at(columns_[i], row);
    }

  private:
    const RayTracer& parts_;
    const SectionClip& clip_;
    const CameraRays& camera_;
    RayWave rays_;
    std::vector<int> columns_;
    std::vector<std::uint8_t> covered_;
};

} // namespace

UncutCover::UncutCover(const Scene& scene)
    : tree_(treeOf(scene)), tracer_(tree_, scene.model.mesh, LeafRecords::Shared) {}

void UncutCover::restore(const Scene& scene, const Camera& camera, const LdrImage& before,
                         LdrImage& image) const {
    const SectionClip clip(scene.sections, tree_.bounds);
    const CameraRays rays(camera, image.width, image.height);
    TaskErrors errors;
#pragma omp parallel
    {
        RowCover cover(tracer_, clip, rays);
#pragma omp for schedule(dynamic)
        for (int row = 0; row < image.height; ++row) errors.guard([&] { cover.restore(row, before, image); });
    }
    errors.rethrow();
}

} // namespace rtcore

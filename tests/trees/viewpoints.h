/// Cameras in any scene: off its surfaces, with surfaces in most of their images.
#pragma once

#include "rtcore/kernels/single_ray.h"
#include "rtcore/render/camera_rays.h"
#include "support/random_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace test {

class Viewpoints {
  public:
    /// `tree` and the arrays behind `mesh` must outlive it.
    Viewpoints(const rtcore::KdTree& tree, const rtcore::Mesh& mesh, rtcore::Vec3 up, std::uint64_t seed)
        : tree_(tree), mesh_(mesh), up_(up), random_(seed) {
        double area = 0;
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
            areas_.push_back(area += double{length(mesh.geometricNormal(i))});
    }

    rtcore::Camera next() {
        constexpr int kTries = 1000;
        rtcore::Camera camera;
        for (int i = 0; i < kTries; ++i) {
            camera = any();
            if (isTelling(camera)) break;
        }
        return camera;
    }

  private:
    /// Between a point of a surface and what it faces, looking at another point of a surface: by turns where
    /// there is detail and where there are large surfaces.
    rtcore::Camera any() {
        const bool detail = random_.coin();
        const std::uint32_t triangle = anyTriangle(detail);
        const rtcore::Vec3 start = pointOf(triangle);
        rtcore::Vec3 away = random_.unitVector();
        if (dot(away, mesh_.geometricNormal(triangle)) < 0) away = -away;
        const float diagonal = tree_.bounds.diagonal();
        rtcore::Hit hit;
        const bool faces = intersect(tree_, mesh_, {start, 1e-4F * diagonal, away, diagonal}, hit);
        rtcore::Camera camera;
        camera.eye = start + away * ((faces ? hit.t : diagonal / 4) * random_.number(0.1F, 0.9F));
        camera.forward = pointOf(anyTriangle(detail)) - camera.eye;
        camera.up = up_;
        camera.horizontalFov = random_.number(40, 100);
        return camera;
    }

    std::uint32_t anyTriangle(bool detail) {
        if (detail) return random_.index(areas_.size());
        const double area = areas_.back() * double{random_.number(0, 1)};
        const auto found = std::lower_bound(areas_.begin(), areas_.end(), area);
        return static_cast<std::uint32_t>(std::min(found, areas_.end() - 1) - areas_.begin());
    }

    rtcore::Vec3 pointOf(std::uint32_t triangle) {
        float u = random_.number(0, 1), v = random_.number(0, 1);
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        return mesh_.position(triangle, 0) * (1 - u - v) + mesh_.position(triangle, 1) * u +
               mesh_.position(triangle, 2) * v;
    }

    /// Three quarters of its rays hit something, and no more than a quarter of them hits it from close by.
    bool isTelling(const rtcore::Camera& camera) const {
        constexpr int kSide = 8, kRays = kSide * kSide;
        const float diagonal = tree_.bounds.diagonal();
        if (length(camera.forward) < 1e-3F * diagonal || areParallel(camera.forward, up_)) return false;
        const rtcore::CameraRays rays(camera, kSide, kSide);
        int hits = 0, close = 0;
        for (int i = 0; i < kRays; ++i) {
            const auto x = static_cast<float>(i % kSide), y = static_cast<float>(i / kSide);
            rtcore::Hit hit;
            if (!intersect(tree_, mesh_, rays.at(x + 0.5F, y + 0.5F), hit)) continue;
            ++hits;
            if (hit.t < 0.01F * diagonal) ++close;
        }
        return 4 * hits >= 3 * kRays && 4 * close <= kRays;
    }

    const rtcore::KdTree& tree_;
    const rtcore::Mesh& mesh_;
    rtcore::Vec3 up_;
    Random random_;
    std::vector<double> areas_; ///< of all triangles up to each
};

} // namespace test

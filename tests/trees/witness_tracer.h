/// Names the rays that make images by two trees differ.
#pragma once

#include "rtcore/kernels/ray_tracer.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace test {

/// Answers by one tree, and prints the rays that another answers differently. Safe from many threads.
class WitnessTracer final : public rtcore::RayTracer {
  public:
    /// Both must outlive it. At most `max` rays are printed.
    WitnessTracer(const rtcore::RayTracer& tracer, const rtcore::RayTracer& other, int max)
        : tracer_(tracer), other_(other), left_(max) {}

    void intersect(rtcore::RayKind kind, const rtcore::RayWave& rays, rtcore::HitWave& hits) const override {
        rtcore::HitWave others;
        tracer_.intersect(kind, rays, hits);
        other_.intersect(kind, rays, others);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (!isSame(hits, others, i)) tell(rays.ray(i), textOf(hits, i), textOf(others, i));
        }
    }
    void occluded(rtcore::RayKind kind, const rtcore::RayWave& rays,
                  std::vector<std::uint8_t>& occluded) const override {
        std::vector<std::uint8_t> others;
        tracer_.occluded(kind, rays, occluded);
        other_.occluded(kind, rays, others);
        const auto text = [](std::uint8_t hits) { return hits != 0 ? "occluded" : "free"; };
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (occluded[i] != others[i]) tell(rays.ray(i), text(occluded[i]), text(others[i]));
        }
    }
    rtcore::Box3 bounds() const override { return tracer_.bounds(); }

  private:
    static bool isSame(const rtcore::HitWave& a, const rtcore::HitWave& b, std::size_t i) {
        using Bits = std::array<std::uint32_t, sizeof(rtcore::Hit) / sizeof(std::uint32_t)>;
        return a.isHit(i) == b.isHit(i) &&
               (!a.isHit(i) || std::bit_cast<Bits>(a.hit(i)) == std::bit_cast<Bits>(b.hit(i)));
    }
    static std::string textOf(const rtcore::HitWave& hits, std::size_t i) {
        if (!hits.isHit(i)) return "no hit";
        char text[100];
        std::snprintf(text, sizeof text, "triangle %u at %a", hits.triangle[i], double{hits.t[i]});
        return text;
    }
    void tell(const rtcore::Ray& ray, const std::string& one, const std::string& other) const {
#pragma omp critical(witness)
        if (left_-- > 0) {
            std::printf(
                "  ray from (%a, %a, %a) towards (%a, %a, %a) in %a to %a: %s, by the other tree %s\n",
                double{ray.origin.x}, double{ray.origin.y}, double{ray.origin.z}, double{ray.direction.x},
                double{ray.direction.y}, double{ray.direction.z}, double{ray.tMin}, double{ray.tMax},
                one.c_str(), other.c_str());
        }
    }

    const rtcore::RayTracer& tracer_;
    const rtcore::RayTracer& other_;
    mutable int left_;
};

} // namespace test

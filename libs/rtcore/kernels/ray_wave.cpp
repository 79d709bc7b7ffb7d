#include "rtcore/kernels/ray_wave.h"

#include <span>

namespace rtcore {

void RayWave::clear() {
    for (auto* array : {&ox, &oy, &oz, &dx, &dy, &dz, &tMin, &tMax}) array->clear();
}

void RayWave::reserve(std::size_t count) {
    for (auto* array : {&ox, &oy, &oz, &dx, &dy, &dz, &tMin, &tMax}) array->reserve(count);
}

void RayWave::push(const Ray& ray) {
    ox.push_back(ray.origin.x);
    oy.push_back(ray.origin.y);
    oz.push_back(ray.origin.z);
    dx.push_back(ray.direction.x);
    dy.push_back(ray.direction.y);
    dz.push_back(ray.direction.z);
    tMin.push_back(ray.tMin);
    tMax.push_back(ray.tMax);
}

void RayWave::append(const RayWave& from, std::size_t first, std::size_t count) {
    for (auto array : {&RayWave::ox, &RayWave::oy, &RayWave::oz, &RayWave::dx, &RayWave::dy, &RayWave::dz,
                       &RayWave::tMin, &RayWave::tMax}) {
        const std::span some = std::span(from.*array).subspan(first, count);
        (this->*array).insert((this->*array).end(), some.begin(), some.end());
    }
}

void RayWave::resize(std::size_t count) {
    for (auto* array : {&ox, &oy, &oz, &dx, &dy, &dz, &tMin, &tMax}) array->resize(count);
}

void HitWave::resize(std::size_t count) {
    for (auto* array : {&t, &u, &v}) array->resize(count);
    triangle.resize(count);
    clearance.clear();
}

void HitWave::take(const HitWave& from, std::size_t first, std::size_t count) {
    const auto takeSome = [&](auto& to, const auto& values) {
        const auto some = std::span(values).subspan(first, count);
        to.assign(some.begin(), some.end());
    };
    for (auto array : {&HitWave::t, &HitWave::u, &HitWave::v}) takeSome(this->*array, from.*array);
    takeSome(triangle, from.triangle);
    clearance.clear();
    if (!from.clearance.empty()) takeSome(clearance, from.clearance);
}

void HitWave::put(std::size_t i, const HitWave& from, std::size_t j) {
    set(i, from.hit(j));
    if (clearance.empty() && from.clearanceOf(j) == 0) return;
    clearance.resize(size());
    clearance[i] = from.clearanceOf(j);
}

} // namespace rtcore

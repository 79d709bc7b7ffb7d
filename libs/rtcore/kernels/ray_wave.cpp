#include "rtcore/kernels/ray_wave.h"

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

void RayWave::resize(std::size_t count) {
    for (auto* array : {&ox, &oy, &oz, &dx, &dy, &dz, &tMin, &tMax}) array->resize(count);
}

void HitWave::resize(std::size_t count) {
    for (auto* array : {&t, &u, &v}) array->resize(count);
    triangle.resize(count);
    clearance.clear();
}

} // namespace rtcore

#include "rtserver/frames/shadow_mapping.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace rtserver {

ShadowMapping::ShadowMapping(std::shared_ptr<const rtcore::Scene> scene,
                             std::shared_ptr<const rtcore::RayTracer> tracer)
    : maps_(std::async(std::launch::async, [this, scene = std::move(scene), tracer = std::move(tracer)] {
          return rtcore::ShadowMaps::make(*scene, *tracer, cancel_);
      })) {}

ShadowMapping::~ShadowMapping() {
    cancel_ = true;
    if (maps_.valid()) maps_.wait();
}

bool ShadowMapping::done() const {
    return maps_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

bool castAlike(std::span<const rtcore::SceneLight> before, std::span<const rtcore::SceneLight> now) {
    const auto alike = [](rtcore::Light a, const rtcore::Light& b) {
        a.on = b.on;
        a.intensity = b.intensity;
        return a == b;
    };
    return std::ranges::equal(before, now, alike, &rtcore::SceneLight::light, &rtcore::SceneLight::light);
}

} // namespace rtserver

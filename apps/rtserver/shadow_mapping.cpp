#include "rtserver/shadow_mapping.h"

#include <chrono>

namespace rtserver {

// With a scene of its own: lights are switched meanwhile.
ShadowMapping::ShadowMapping(const World& world)
    : maps_(std::async(std::launch::async, [this, scene = world.loaded.scene, &tracer = *world.tracer] {
          return rtcore::ShadowMaps::make(scene, tracer, cancel_);
      })) {}

ShadowMapping::~ShadowMapping() {
    cancel_ = true;
    if (maps_.valid()) maps_.wait();
}

bool ShadowMapping::done() const {
    return maps_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

} // namespace rtserver

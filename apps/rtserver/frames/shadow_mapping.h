/// The shadow maps of a scene that is shown, made beside it.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/scene.h"
#include "rtcore/shading/light/shadow_maps.h"

#include <atomic>
#include <future>
#include <memory>
#include <span>

namespace rtserver {

/// A thread of its own works, and keeps the scene and the tracer; all functions are for the one thread that
/// has the object. The destructor gives the work up.
class ShadowMapping {
  public:
    /// `tracer`: of that scene.
    ShadowMapping(std::shared_ptr<const rtcore::Scene> scene,
                  std::shared_ptr<const rtcore::RayTracer> tracer);
    ~ShadowMapping();
    ShadowMapping(const ShadowMapping&) = delete;
    ShadowMapping& operator=(const ShadowMapping&) = delete;

    bool done() const;
    /// Once, when done(). Throws std::bad_alloc.
    std::unique_ptr<const rtcore::ShadowMaps> take() { return maps_.get(); }

  private:
    std::atomic<bool> cancel_{false};
    std::future<std::unique_ptr<const rtcore::ShadowMaps>> maps_; ///< last: its thread uses the others
};

/// Whether shadow maps that were made for the lights `before` hold for `now`: each light may have been
/// switched or changed its colour, but stands as it did.
bool castAlike(std::span<const rtcore::SceneLight> before, std::span<const rtcore::SceneLight> now);

} // namespace rtserver

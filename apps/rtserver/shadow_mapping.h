/// The shadow maps of a scene that is shown, made beside it.
#pragma once

#include "rtserver/world.h"

#include <atomic>
#include <future>
#include <memory>

namespace rtserver {

/// A thread of its own works; all functions are for the one thread that has the object. The destructor gives
/// the work up. The world's tracer must outlive it.
class ShadowMapping {
  public:
    explicit ShadowMapping(const World& world);
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

} // namespace rtserver

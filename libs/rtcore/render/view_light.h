/// The indirect light of single views.
#pragma once

#include "rtcore/gathering/indirect_light.h"
#include "rtcore/gathering/indirect_state.h"
#include "rtcore/render/view.h"
#include "rtcore/render/view_steps.h"

#include <atomic>
#include <memory>
#include <utility>

namespace rtcore {

/// The light of one view, learned from nothing by a fixed schedule: an image that is lit by it depends on the
/// view alone, whatever was walked through before. Or from what is kept of the scene, to which it adds what
/// the view lacks: images of many views have the same light where they show the same.
class ViewLight {
  public:
    /// Views to come begin with that, of their scene and its light; null: with nothing.
    void beginWith(std::shared_ptr<const IndirectState> kept) { kept_ = std::move(kept); }
    /// The same bits for any number of threads. Returns false when control.cancel was set: only a
    /// part is known then. Takes some seconds of two processors, from kept light a tenth of a second.
    bool learn(const View& view, RenderControl& control);
    /// Progress of learn(), 0..1. Any thread.
    float fraction() const { return done_; }
    const IndirectLight& light() const { return light_; }

  private:
    bool learnWhatLacks(const View& view, RenderControl& control);
    bool learnAll(const View& view, RenderControl& control);

    std::shared_ptr<const IndirectState> kept_;
    ViewSteps steps_;
    IndirectLight light_;
    std::atomic<float> done_ = 0;
};

} // namespace rtcore

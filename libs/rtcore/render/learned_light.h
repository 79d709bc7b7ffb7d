/// The indirect light of a scene, learned of one view after another, to be kept.
#pragma once

#include "rtcore/gathering/indirect_light.h"
#include "rtcore/gathering/indirect_state.h"
#include "rtcore/render/view.h"
#include "rtcore/render/view_steps.h"

#include <cstddef>

namespace rtcore {

/// What it knows depends on the scene and the views in their order alone, to the bit. Not for several threads
/// at once: it uses those of the control itself.
class LearnedLight {
  public:
    /// Begins with nothing. The arguments must outlive it, or the next begin().
    /// What is learned has the same random numbers whatever seed the settings name, which may be that of a
    /// frame.
    void begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings) {
        RenderSettings seedless = settings;
        seedless.path.seed = 0;
        light_.begin(scene, tracer, seedless);
    }
    /// Goes on from what is kept of that scene and its light.
    void restore(const IndirectState& kept) { light_.restore(kept); }
    /// Learns what a view of the scene shows, by the pixels of that size. Some seconds for the first one, a
    /// tenth of one for what is known. False when control.cancel was set; what was learned stays.
    bool learn(const View& view, RenderControl& control);

    IndirectState state() const { return light_.state(); }
    std::size_t records() const { return light_.cache().size(); }
    std::size_t cells() const { return light_.cells().size(); }

  private:
    ViewSteps steps_;
    IndirectLight light_;
};

} // namespace rtcore

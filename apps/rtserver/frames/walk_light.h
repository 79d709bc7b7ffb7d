/// Indirect light of the frames of a walk: learned while the camera moves, and forgotten as the state
/// changes.
#pragma once

#include "rtserver/document/document.h"

#include "rtcore/gathering/indirect_light.h"
#include "rtcore/render/view_steps.h"

#include <memory>
#include <utility>
#include <vector>

namespace rtserver {

/// One thread, which uses those of the control itself. Keeps its memory from frame to frame.
class WalkLight {
  public:
    /// The work of a live frame at most, and in how many of them samples follow what is learned.
    static constexpr rtcore::GatherBudget kBudget{.rays = 8192, .paths = 768, .compared = 256};
    /// By FrameDetail::learning: a part of it; beyond 1 it itself, and more only where nothing is known.
    static rtcore::GatherBudget budgetOf(double learning);
    static constexpr int kTurns = 48;

    /// kTurns, but for some frames after a change of light, and in frames of so much of the size each way:
    /// then samples follow sooner. A frame of few pixels updates about as many as one of all.
    int turns(double scale) const;
    /// Before each frame: takes what has changed, so that what is known suits the state.
    void follow(const Document& document, int threads);
    /// Of a frame that no time is planned for.
    static constexpr double kAtLeisure = 4;
    /// Learns about some of the pixels of a frame that is not live, with so many times kBudget.
    bool learn(const rtcore::View& view, double times, rtcore::RenderControl& control);
    /// Goes on until the view that rests is known about as well as one whose light is learned for it alone.
    bool learnRest(const rtcore::View& view, rtcore::RenderControl& control);
    rtcore::IndirectLight& light() { return *light_; }
    /// Null before the first follow(), and while what is known does not suit the state yet.
    const rtcore::IndirectLight* known() const {
        return light_ != nullptr && !light_->changing() ? light_.get() : nullptr;
    }
    /// Goes on from what is kept of the light of the state.
    void beginWith(const Document& document, const rtcore::IndirectState& kept) {
        follow(document, 1);
        light_->restore(kept);
    }

  private:
    std::unique_ptr<rtcore::IndirectLight> light_;
    rtcore::ViewSteps steps_;
    std::shared_ptr<const rtcore::Scene> scene_; ///< whose light is known
    std::shared_ptr<const rtcore::RayTracer> tracer_;
    /// Those before, while the light changes from theirs.
    std::vector<std::pair<std::shared_ptr<const rtcore::Scene>, std::shared_ptr<const rtcore::RayTracer>>>
        before_;
    rtcore::RenderSettings settings_;
    rtcore::Subscription known_;
    int frames_ = kTurns; ///< since light changed, as far as that counts
};

} // namespace rtserver

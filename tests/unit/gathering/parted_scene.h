/// Scenes whose parts are hidden and shown while their indirect light is learned.
#pragma once

#include "gathering_support.h"

#include "rtcore/render/visible_scene.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace test {

/// A scene with the tree of what is not hidden.
struct VisibleScene {
    VisibleScene(const rtcore::KdTree& whole, rtcore::Scene of)
        : scene(std::move(of)), tree(rtcore::visibleTree(whole, scene)), tracer(tree, scene.mesh()) {}

    rtcore::Scene scene;
    rtcore::KdTree tree;
    rtcore::KdRayTracer tracer;
};

/// Changes its states as a server would.
class PartedScene {
  public:
    explicit PartedScene(rtcore::Scene scene, const std::vector<std::uint8_t>& hidden = {})
        : whole_(rtcore::buildKdTree(scene.mesh(), {})) {
        settings.path.emitters = rtcore::EmitterLight::On;
        state_ = std::make_shared<VisibleScene>(whole_, withHidden(std::move(scene), hidden));
        light.begin(state_->scene, state_->tracer, settings);
    }
    PartedScene(const PartedScene&) = delete;
    PartedScene& operator=(const PartedScene&) = delete;

    const rtcore::Scene& scene() const { return state_->scene; }
    const rtcore::RayTracer& tracer() const { return state_->tracer; }
    /// By part of the model: 1 where it is hidden.
    void hide(const std::vector<std::uint8_t>& hidden) { change(withHidden(state_->scene, hidden)); }
    /// Another scene of the same model: of lights and materials, or of parts.
    void change(rtcore::Scene scene) {
        const bool parts = !rtcore::sameParts(scene.hiddenParts, state_->scene.hiddenParts);
        if (!light.changing()) before_.clear();
        before_.push_back(std::exchange(state_, std::make_shared<VisibleScene>(whole_, std::move(scene))));
        if (parts)
            light.changeParts(state_->scene, state_->tracer, settings, threads);
        else
            light.changeLight(state_->scene, state_->tracer, settings);
    }
    /// So many steps, each with some of the receivers.
    void learn(int steps, std::size_t some = 2000) {
        std::vector<rtcore::Receiver> now(some);
        std::vector<rtcore::ArrivingLight> arriving(some);
        for (int step = 0; step < steps; ++step) {
            for (rtcore::Receiver& each : now) each = receivers[random.index(receivers.size())];
            light.step(now, arriving, budget, threads);
        }
    }
    /// At each receiver.
    std::vector<double> shown() const {
        std::vector<rtcore::ArrivingLight> arriving(receivers.size());
        light.cache().lookUp(receivers, arriving);
        std::vector<double> found;
        for (const rtcore::ArrivingLight& each : arriving) found.push_back(each.irradiance.g);
        return found;
    }
    /// Adds points of the faces of a box, seen from inside.
    void addReceiversOfBox(rtcore::Vec3 lo, rtcore::Vec3 hi, std::size_t ofFace, float pixel) {
        for (int face = 0; face < 6; ++face) {
            for (std::size_t i = 0; i < ofFace; ++i) {
                rtcore::Vec3 at, normal;
                for (int axis = 0; axis < 3; ++axis) at[axis] = random.number(lo[axis], hi[axis]);
                at[face / 2] = face % 2 == 0 ? lo[face / 2] : hi[face / 2];
                normal[face / 2] = face % 2 == 0 ? 1.0F : -1.0F;
                receivers.push_back(receiverAt(at, normal, pixel));
            }
        }
    }

    rtcore::RenderSettings settings = exactSettings();
    rtcore::IndirectLight light;
    rtcore::GatherBudget budget{8192, 768}; ///< as a live frame has it
    std::vector<rtcore::Receiver> receivers;
    Random random{5};
    int threads = 0;

  private:
    static rtcore::Scene withHidden(rtcore::Scene scene, const std::vector<std::uint8_t>& hidden) {
        scene.hiddenParts =
            hidden.empty() ? nullptr : std::make_shared<const std::vector<std::uint8_t>>(hidden);
        return scene;
    }

    rtcore::KdTree whole_;
    std::shared_ptr<const VisibleScene> state_;
    std::vector<std::shared_ptr<const VisibleScene>> before_; ///< while the light changes from theirs
};

} // namespace test

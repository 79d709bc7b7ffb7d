#include "rtserver/frames/walk_light.h"

#include "rtcore/settings/settings_table.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rtserver {

rtcore::GatherBudget WalkLight::budgetOf(double learning) {
    const double part = std::min(learning, 1.0);
    return {.rays = static_cast<std::uint32_t>(kBudget.rays * part),
            .paths = static_cast<std::uint32_t>(kBudget.paths * part),
            .maxTimes = learning / part,
            .compared = kBudget.compared};
}

void WalkLight::follow(const Document& document, int threads) {
    using rtcore::Change;
    // Of whole frames: coarse ones have cheaper samples, but the same light.
    const rtcore::RenderSettings settings = document.frameSettings();
    const rtcore::Changes changes = known_.take(document.revisions());
    const auto cut = [](const auto& scene) { return scene != nullptr && scene->sections.letLightIn(); };
    const bool opened = changes.has(Change::Section) && (cut(scene_) || cut(document.imagedScene()));
    const bool begins = light_ == nullptr || changes.has(Change::Scene) || opened,
               parts = changes.has(Change::Visibility),
               other = changes.hasAny({Change::Light, Change::Sky, Change::Material}) ||
                       !rtcore::sameLight(settings, settings_);
    const bool rebinds = tracer_ != document.tracer(); // a better tree of the same surfaces
    const bool stillChanges = light_ != nullptr && light_->changing();
    frames_ = (parts || other || stillChanges) && !begins ? 0 : std::min(frames_ + 1, kTurns);
    if (!stillChanges) before_.clear();
    if (!begins && !parts && !other && !rebinds) return;
    if (light_ == nullptr) light_ = std::make_unique<rtcore::IndirectLight>();
    // What the light was of until now lives until it has followed the change.
    before_.emplace_back(std::exchange(scene_, document.imagedScene()),
                         std::exchange(tracer_, document.tracer()));
    settings_ = settings;
    if (begins) {
        light_->begin(*scene_, *tracer_, settings_);
        return;
    }
    if (parts) light_->changeParts(*scene_, *tracer_, settings_, threads);
    if (other) light_->changeLight(*scene_, *tracer_, settings_);
    if (!parts && !other) light_->rebind(*scene_, *tracer_, settings_);
    // Edits may come sooner than they are followed, for as long as someone likes.
    std::erase_if(before_, [&](const auto& of) { return of.first.get() != light_->sceneBefore(); });
}

int WalkLight::turns(double scale) const {
    struct After {
        int frames, turns;
    };
    constexpr After kAfter[] = {{8, 4}, {24, 8}};
    for (const After& after : kAfter)
        if (frames_ < after.frames) return after.turns;
    // So few of them that turns of frames of about one size do not mix.
    constexpr int kOfSmallFrames[] = {8, 12, 24};
    const double wanted = kTurns * scale * scale;
    for (const int turns : kOfSmallFrames)
        if (turns >= wanted) return turns;
    return kTurns;
}

bool WalkLight::learn(const rtcore::View& view, double times, rtcore::RenderControl& control) {
    const rtcore::GatherBudget budget{.rays = static_cast<std::uint32_t>(kBudget.rays * times),
                                      .paths = static_cast<std::uint32_t>(kBudget.paths * times),
                                      .maxTimes = times < kAtLeisure ? 1 : rtcore::GatherBudget::kMaxTimes,
                                      .compared = 2 * kBudget.compared};
    constexpr int kMaxPixels = 1 << 16;
    int apart = 1; // pixels each way
    while (view.settings.width / apart * (view.settings.height / apart) > kMaxPixels) ++apart;
    std::vector<rtcore::SampleId> pixels;
    for (int y = 0; y < view.settings.height; y += apart) {
        for (int x = 0; x < view.settings.width; x += apart)
            pixels.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0});
    }
    return steps_.step(view, pixels, budget, control, *light_);
}

bool WalkLight::learnRest(const rtcore::View& view, rtcore::RenderControl& control) {
    constexpr rtcore::GatherBudget kOfRest{8 * kBudget.rays, 8 * kBudget.paths, 4};
    return steps_.learnEnough(view, kOfRest, control, *light_);
}

} // namespace rtserver

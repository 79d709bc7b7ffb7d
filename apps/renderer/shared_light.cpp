#include "renderer/shared_light.h"

#include "rtcore/io/light/light_file.h"
#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

namespace renderer {

bool SharedLight::lights(const rtcore::RenderSettings& settings) {
    return settings.indirect.mode == rtcore::IndirectMode::Live &&
           (settings.integrator == rtcore::Integrator::Whitted || rtcore::mixesSteadyImage(settings));
}

std::shared_ptr<const rtcore::IndirectState>
SharedLight::of(const LitScene& lit, const std::function<std::vector<LightView>()>& views) {
    Switches switches{lit.scene.lights, lit.scene.activeEnvironment};
    if (!switches_) {
        const bool makes =
            !options_.light || (options_.hasFrames() && !std::filesystem::exists(*options_.light));
        light_ = makes ? learn(lit, views()) : read(lit);
        switches_ = std::move(switches);
        return light_;
    }
    return switches == *switches_ ? light_ : nullptr;
}

void SharedLight::tellUnused() {
    if (!options_.light || std::exchange(toldUnused_, true)) return;
    progress_.tell(rtcore::say("warning: {0}", rtcore::lightIsUnused(*options_.light)));
}

std::shared_ptr<const rtcore::IndirectState> SharedLight::read(const LitScene& lit) const {
    const rtcore::LightKey key = rtcore::lightKeyOf(lit.scene, lit.tracer.bounds(), lit.settings);
    rtcore::LightFile file = rtcore::readLightFile(*options_.light, key);
    if (file.match == rtcore::LightMatch::Same)
        return std::make_shared<const rtcore::IndirectState>(std::move(file.light));
    const bool sameSurfaces = file.match == rtcore::LightMatch::OtherLight;
    throw rtcore::FileError(
        rtcore::FailureKind::BadData, options_.light->string(),
        sameSurfaces ? rtcore::form("is of the same surfaces by another light; make it anew by --make-light")
                     : rtcore::form("is of other surfaces; make one of this scene by --make-light"));
}

std::shared_ptr<const rtcore::IndirectState> SharedLight::learn(const LitScene& lit,
                                                                const std::vector<LightView>& views) const {
    if (views.size() < 2) return nullptr;
    rtcore::LearnedLight light;
    light.begin(lit.scene, lit.tracer, lit.settings);
    if (learnViews(light, lit, views, {}, options_.threads, progress_).stopped)
        throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    auto learned = std::make_shared<const rtcore::IndirectState>(light.state());
    if (options_.light) keep(lit, *learned);
    return learned;
}

void SharedLight::keep(const LitScene& lit, const rtcore::IndirectState& light) const {
    const rtcore::LightKey key = rtcore::lightKeyOf(lit.scene, lit.tracer.bounds(), lit.settings);
    rtcore::writeLightFile(*options_.light, key, light);
    progress_.print(fmt::format("wrote {}", options_.light->string()));
}

} // namespace renderer

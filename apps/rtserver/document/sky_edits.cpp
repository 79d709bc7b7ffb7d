#include "rtserver/document/sky_edits.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/sky/scene_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rtserver {

namespace {

/// The active one, of files. Throws std::runtime_error where there is none.
std::size_t shownFile(const rtcore::Scene& scene) {
    if (scene.environment() == nullptr) throw rtcore::Refusal("no environment map is shown");
    return static_cast<std::size_t>(scene.activeEnvironment);
}

bool showsSky(const rtcore::Scene& scene) {
    const auto sky = rtcore::skyEnvironmentOf(scene);
    return sky && std::cmp_equal(scene.activeEnvironment, *sky);
}

void lightBySky(Document& document) { document.assign({{"skyLight.on", true}}); }

/// The light beside the viewer that a model without lights was given is none of the sky's; without both it
/// would be dark.
void switchHeadlight(const Document& document, rtcore::Scene& edited, bool on) {
    const rtcore::LoadedScene& loaded = document.world().loaded;
    if (!loaded.preset) return;
    const auto light = std::ranges::find(edited.lights, rtcore::kHeadlightName, &rtcore::SceneLight::name);
    if (light != edited.lights.end()) {
        light->light.on = on ? 1 : 0;
    } else if (on && edited.lights.empty()) {
        rtcore::addHeadlight(edited, loaded.tree.bounds, document.camera());
    }
}

// For users they are counted from 1.
[[noreturn]] void refuseEnvironment(int environment, std::size_t count) {
    using rtcore::say;
    const rtcore::Sentence has = count == 0   ? say("none")
                                 : count == 1 ? say("only number {0}", 1)
                                              : say("numbers {0} to {1}", 1, count);
    throw rtcore::BadValue(say("there is no environment {0}; the scene has {1}", environment + 1, has));
}

} // namespace

void setSky(Document& document, const std::optional<rtcore::Sky>& sky) {
    rtcore::Scene edited = *document.scene();
    const bool first = !edited.sky && sky;
    rtcore::setSky(edited, sky);
    if (first || !sky) switchHeadlight(document, edited, !sky);
    document.publish(std::move(edited));
    if (first) lightBySky(document);
}

void setLightingPreset(Document& document, rtcore::LightingPreset preset) {
    rtcore::Scene edited = *document.scene();
    const rtcore::LoadedScene& loaded = document.world().loaded;
    const rtcore::Mesh& mesh = edited.model.mesh;
    const rtcore::Survey found = rtcore::survey(loaded.tree, mesh, rtcore::axesOf(edited));
    const rtcore::PresetLighting lights =
        rtcore::presetLighting(preset, loaded.tree, mesh, found, document.camera());
    rtcore::lightBy(edited, lights);
    document.publish(std::move(edited));
    document.assign(rtcore::settingsOf(preset, found));
}

void setEnvironment(Document& document, int environment) {
    rtcore::Scene edited = *document.scene();
    if (environment < 0 || std::cmp_greater_equal(environment, edited.environments.size()))
        refuseEnvironment(environment, edited.environments.size());
    edited.activeEnvironment = environment;
    document.publish(std::move(edited));
}

void addEnvironment(Document& document, const rtcore::EnvironmentFile& file,
                    rtcore::Environment environment) {
    for (const std::filesystem::path& each : file.files) document.addInput(each);
    rtcore::Scene edited = *document.scene();
    rtcore::setSky(edited, std::nullopt);
    edited.activeEnvironment = static_cast<int>(rtcore::addEnvironment(edited, file, std::move(environment)));
    switchHeadlight(document, edited, false);
    document.publish(std::move(edited));
    lightBySky(document);
}

void leaveEnvironment(Document& document) {
    rtcore::Scene edited = *document.scene();
    rtcore::setSky(edited, std::nullopt);
    if (!edited.environments.empty()) edited.activeEnvironment = rtcore::kNoEnvironment;
    switchHeadlight(document, edited, true);
    document.publish(std::move(edited));
}

void rotateEnvironment(Document& document, float degrees) {
    rtcore::Scene edited = *document.scene();
    if (showsSky(edited)) throw rtcore::Refusal("the sky is turned by 'sky north'");
    rtcore::setEnvironmentRotation(edited, shownFile(edited), degrees);
    document.publish(std::move(edited));
}

void scaleEnvironment(Document& document, float factor) {
    rtcore::Scene edited = *document.scene();
    if (showsSky(edited)) {
        rtcore::Sky sky = *edited.sky;
        sky.strength = factor;
        return setSky(document, sky);
    }
    rtcore::setEnvironmentIntensity(edited, shownFile(edited), factor);
    document.publish(std::move(edited));
}

} // namespace rtserver

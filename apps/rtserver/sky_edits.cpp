// What surrounds the scene that is shown.
#include "rtserver/document.h"

#include "rtcore/look/look.h"
#include "rtcore/sky/scene_sky.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rtserver {

namespace {

/// The active one, of files. Throws std::runtime_error where there is none.
std::size_t shownFile(const rtcore::Scene& scene) {
    if (scene.environment() == nullptr) throw std::runtime_error("no environment map is shown");
    return static_cast<std::size_t>(scene.activeEnvironment);
}

bool showsSky(const rtcore::Scene& scene) {
    const auto sky = rtcore::skyEnvironmentOf(scene);
    return sky && std::cmp_equal(scene.activeEnvironment, *sky);
}

} // namespace

void ServerState::lightBySky() { assign({{"skyLight.on", true}}); }

void ServerState::setLook(rtcore::Look look) {
    rtcore::Scene edited = *scene_;
    const rtcore::LoadedScene& loaded = world_->loaded;
    const rtcore::Mesh& mesh = edited.model.mesh;
    const rtcore::Survey found = rtcore::survey(loaded.tree, mesh, rtcore::axesOf(edited));
    const rtcore::LookLights lights = rtcore::lookLights(look, loaded.tree, mesh, found, camera_);
    rtcore::lightBy(edited, lights);
    publish(std::move(edited));
    assign(rtcore::settingsOf(look, found));
}

// The light beside the viewer that a model was given is none of the sky's; without both it would be dark.
void ServerState::setSky(const std::optional<rtcore::Sky>& sky) {
    rtcore::Scene edited = *scene_;
    const bool first = !edited.sky && sky;
    rtcore::setSky(edited, sky);
    if (first || !sky) switchHeadlight(edited, !sky);
    publish(std::move(edited));
    if (first) lightBySky();
}

void ServerState::switchHeadlight(rtcore::Scene& scene, bool on) const {
    if (!world_->loaded.look) return;
    const auto light = std::ranges::find(scene.lights, rtcore::kHeadlightName, &rtcore::SceneLight::name);
    if (light != scene.lights.end()) {
        light->light.on = on ? 1 : 0;
    } else if (on && scene.lights.empty()) {
        rtcore::addHeadlight(scene, world_->loaded.tree.bounds, camera_);
    }
}

void ServerState::addEnvironment(const rtcore::EnvironmentFile& file, rtcore::Environment environment) {
    for (const std::filesystem::path& each : file.files) world_->inputs.add(each);
    rtcore::Scene edited = *scene_;
    rtcore::setSky(edited, std::nullopt);
    edited.activeEnvironment = static_cast<int>(rtcore::addEnvironment(edited, file, std::move(environment)));
    switchHeadlight(edited, false);
    publish(std::move(edited));
    lightBySky();
}

void ServerState::leaveEnvironment() {
    rtcore::Scene edited = *scene_;
    rtcore::setSky(edited, std::nullopt);
    if (!edited.environments.empty()) edited.activeEnvironment = rtcore::kNoEnvironment;
    switchHeadlight(edited, true);
    publish(std::move(edited));
}

void ServerState::rotateEnvironment(float degrees) {
    rtcore::Scene edited = *scene_;
    if (showsSky(edited)) throw std::runtime_error("the sky is turned by 'sky north'");
    rtcore::setEnvironmentRotation(edited, shownFile(edited), degrees);
    publish(std::move(edited));
}

void ServerState::scaleEnvironment(float factor) {
    rtcore::Scene edited = *scene_;
    if (showsSky(edited)) {
        rtcore::Sky sky = *edited.sky;
        sky.strength = factor;
        return setSky(sky);
    }
    rtcore::setEnvironmentIntensity(edited, shownFile(edited), factor);
    publish(std::move(edited));
}

} // namespace rtserver

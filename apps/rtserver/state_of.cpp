#include "rtserver/state_of.h"

#include <cstddef>
#include <filesystem>
#include <utility>

namespace rtserver {

namespace {

std::string nameOf(const rtcore::EnvironmentFile& environment) {
    const bool named = !environment.name.empty() || environment.files.empty();
    return named ? environment.name : environment.files.front().stem().string();
}

} // namespace

std::string scenePathOf(const Session& session) {
    return std::filesystem::absolute(session.world().source).lexically_normal().string();
}

std::vector<app::NamedSwitch> lightsOf(const Session& session) {
    const rtcore::Scene& scene = session.world().loaded.scene;
    std::vector<app::NamedSwitch> all;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const std::string name = i < scene.lightNames.size() ? scene.lightNames[i] : std::string();
        all.push_back({scene.lights[i].on != 0, name});
    }
    return all;
}

std::vector<app::NamedSwitch> environmentsOf(const Session& session) {
    const rtcore::LoadedScene& loaded = session.world().loaded;
    std::vector<app::NamedSwitch> all;
    for (std::size_t i = 0; i < loaded.scene.environments.size(); ++i) {
        const bool described = loaded.sceneFile && i < loaded.sceneFile->environments.size();
        const std::string name = described ? nameOf(loaded.sceneFile->environments[i]) : std::string();
        all.push_back({std::cmp_equal(loaded.scene.activeEnvironment, i), name});
    }
    return all;
}

app::ServerState serverStateOf(const Session& session) {
    app::ServerState state{.scene = scenePathOf(session),
                           .lights = lightsOf(session),
                           .environments = environmentsOf(session),
                           .camera = session.camera(),
                           .settings = rtcore::settingAssignments(session.settings(), true)};
    state.camera.nameOffset = 0;
    return state;
}

} // namespace rtserver

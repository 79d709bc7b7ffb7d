#include "rtserver/state_report_of.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>

namespace rtserver {

namespace {

std::string nameOf(const rtcore::EnvironmentFile& environment) {
    const bool named = !environment.name.empty() || environment.files.empty();
    return named ? environment.name : environment.files.front().stem().string();
}

} // namespace

std::string scenePathOf(const ServerState& state) {
    return std::filesystem::absolute(state.world().source).lexically_normal().string();
}

std::vector<app::NamedSwitch> lightsOf(const ServerState& state) {
    const rtcore::Scene& scene = *state.scene();
    std::vector<app::NamedSwitch> all;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const std::string name = i < scene.lightNames.size() ? scene.lightNames[i] : std::string();
        all.push_back({scene.lights[i].on != 0, name});
    }
    return all;
}

std::vector<app::NamedSwitch> environmentsOf(const ServerState& state) {
    const rtcore::Scene& scene = *state.scene();
    const std::optional<rtcore::SceneFile>& file = state.world().loaded.sceneFile;
    std::vector<app::NamedSwitch> all;
    for (std::size_t i = 0; i < scene.environments.size(); ++i) {
        const bool described = file && i < file->environments.size();
        const std::string name = described ? nameOf(file->environments[i]) : std::string();
        all.push_back({std::cmp_equal(scene.activeEnvironment, i), name});
    }
    return all;
}

app::StateReport stateReportOf(const ServerState& state) {
    app::StateReport report{.scene = scenePathOf(state),
                            .up = state.scene()->up,
                            .metresPerUnit = state.metresPerUnit(),
                            .lights = lightsOf(state),
                            .environments = environmentsOf(state),
                            .camera = state.camera(),
                            .settings = rtcore::settingAssignments(state.settings(), true)};
    report.camera.nameOffset = 0;
    const EditHistory& history = state.history();
    if (history.last() != nullptr) report.undo = history.last()->label;
    if (history.next() != nullptr) report.redo = history.next()->label;
    report.edits = static_cast<int>(history.position());
    return report;
}

} // namespace rtserver

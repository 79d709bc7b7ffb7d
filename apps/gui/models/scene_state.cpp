#include "gui/models/scene_state.h"

#include "common/commands/command_lines.h"
#include "common/commands/state_report.h"
#include "common/settings/settings_merge.h"

#include "rtcore/platform/error.h"
#include "rtcore/settings/settings_table.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace gui {

namespace {

void assign(SceneState& state, const std::vector<rtcore::SettingAssignment>& assignments) {
    for (const rtcore::SettingAssignment& each : assignments)
        state.settings[QString::fromStdString(each.name)] =
            QString::fromStdString(rtcore::settingText(each.value));
}

QList<NamedSwitch> switchesOf(const std::vector<app::NamedSwitch>& switches) {
    QList<NamedSwitch> list;
    for (const app::NamedSwitch& each : switches) list.append({each.on, QString::fromStdString(each.name)});
    return list;
}

} // namespace

bool isPictureSize(const QString& setting) {
    return setting == QLatin1String("width") || setting == QLatin1String("height");
}

std::optional<Placement> readPlacement(const QString& answer) {
    try {
        const app::StateReport state = app::parseStateReport(answer.toStdString());
        Placement placement{
            .scene = QString::fromStdString(state.scene), .camera = state.camera, .state = {}};
        assign(placement.state, state.settings);
        placement.state.lights = switchesOf(state.lights);
        placement.state.environments = switchesOf(state.environments);
        return placement;
    } catch (const rtcore::FileError&) {
        return std::nullopt;
    }
}

std::optional<rtcore::CameraFile> readCameraText(const QString& text) {
    try {
        return rtcore::parseCameraFile(text.toStdString(), "text");
    } catch (const rtcore::FileError&) {
        return std::nullopt;
    }
}

SceneState withCameraFile(SceneState state, const rtcore::CameraFile& file) {
    assign(state, app::settingsOf(file));
    if (file.lights && std::ssize(*file.lights) <= state.lights.size()) {
        for (qsizetype i = 0; i < std::ssize(*file.lights); ++i)
            state.lights[i].on = (*file.lights)[static_cast<std::size_t>(i)];
    }
    if (file.environment && *file.environment < state.environments.size()) {
        for (qsizetype i = 0; i < state.environments.size(); ++i)
            state.environments[i].on = i == *file.environment;
    }
    return state;
}

std::string cameraCommand(const rtcore::Camera& camera) {
    const auto numbers = [](rtcore::Vec3 v) { return std::array{v.x, v.y, v.z}; };
    const bool orthographic = camera.kind == rtcore::CameraKind::Orthographic;
    return app::command::camera({.eye = numbers(camera.eye),
                                 .forward = numbers(camera.forward),
                                 .width = orthographic ? camera.orthographicWidth : camera.horizontalFov,
                                 .orthographic = orthographic,
                                 .up = numbers(camera.up),
                                 .aspect = camera.aspect});
}

std::vector<std::string> commandsBetween(const SceneState& from, const SceneState& to) {
    std::vector<std::string> commands;
    for (auto setting = to.settings.begin(); setting != to.settings.end(); ++setting) {
        if (from.settings.value(setting.key()) != setting.value())
            commands.push_back(app::command::set(setting.key().toStdString(), setting.value().toStdString()));
    }
    for (qsizetype i = 0; i < std::min(from.lights.size(), to.lights.size()); ++i) {
        if (from.lights[i].on != to.lights[i].on)
            commands.push_back(app::command::light(static_cast<int>(i) + 1, to.lights[i].on));
    }
    for (qsizetype i = 0; i < std::min(from.environments.size(), to.environments.size()); ++i) {
        if (to.environments[i].on && !from.environments[i].on)
            commands.push_back(app::command::environment(static_cast<int>(i) + 1));
    }
    return commands;
}

} // namespace gui

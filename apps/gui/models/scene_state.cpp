#include "gui/models/scene_state.h"

#include "common/commands/state_report.h"

#include "rtcore/platform/error.h"
#include "rtcore/scene/up_axis.h"
#include "rtcore/settings/settings_table.h"

#include <algorithm>

namespace gui {

namespace {

QList<NamedSwitch> switchesOf(const std::vector<app::NamedSwitch>& switches) {
    QList<NamedSwitch> list;
    for (const app::NamedSwitch& each : switches) list.append({each.on, QString::fromStdString(each.name)});
    return list;
}

QList<ShownLight> lightsOf(const std::vector<app::ReportedLight>& lights) {
    QList<ShownLight> list;
    for (const app::ReportedLight& each : lights)
        list.append({each.id, each.on, QString::fromStdString(each.name), each.description, each.power});
    return list;
}

std::vector<ShownFlight> flightsOf(const std::vector<app::ReportedFlight>& flights) {
    std::vector<ShownFlight> list;
    for (const app::ReportedFlight& each : flights)
        list.push_back({QString::fromStdString(each.name), each.seconds, each.timing, each.closed,
                        each.turntable, each.keyCount, each.keyTimes});
    return list;
}

} // namespace

const ShownLight* lightOf(const SceneState& state, int id) {
    const auto found = std::ranges::find(state.lights, id, &ShownLight::id);
    return found == state.lights.end() ? nullptr : &*found;
}

double parallelWidth(const SceneState& state, const QSizeF& image) {
    const double width{state.parallelWidth};
    if (!(state.framedAspect > 0) || image.isEmpty()) return width;
    return width * std::max(1.0, image.width() / image.height() / double{state.framedAspect});
}

bool isPictureSize(const QString& setting) {
    return setting == QLatin1String("width") || setting == QLatin1String("height");
}

std::optional<StateAnswer> readState(const QString& answer) {
    try {
        const app::StateReport report = app::parseStateReport(answer.toStdString());
        StateAnswer result{.scene = QString::fromStdString(report.scene), .state = {}};
        for (const rtcore::SettingAssignment& each : report.settings) {
            result.state.settings[QString::fromStdString(each.name)] =
                QString::fromStdString(rtcore::settingText(each.value));
        }
        result.state.up = QString::fromStdString(std::string(rtcore::axisName(report.up)));
        result.state.metresPerUnit = report.metresPerUnit;
        result.state.origin = report.origin;
        result.state.lights = lightsOf(report.lights);
        result.state.sun = report.sun;
        result.state.environments = switchesOf(report.environments);
        if (report.map) result.state.map = ShownMap{report.map->rotation, report.map->strength};
        result.state.sky = report.sky;
        result.state.bounds = report.bounds;
        result.state.sections = report.sections;
        result.state.measures = report.measures;
        result.state.measureCount = report.measureCount;
        result.state.notes = report.notes;
        result.state.noteCount = report.noteCount;
        result.state.notesShortened = report.notesShortened;
        if (report.camera.kind == rtcore::CameraKind::Orthographic) {
            result.state.parallelWidth = report.camera.orthographicWidth;
            result.state.framedAspect = report.camera.aspect;
        }
        result.state.undo = QString::fromStdString(report.undo);
        result.state.redo = QString::fromStdString(report.redo);
        for (const std::string& name : report.bookmarks)
            result.state.bookmarks.append(QString::fromStdString(name));
        for (const std::string& view : report.bookmarkViews)
            result.state.bookmarkViews.append(QString::fromStdString(view));
        for (const std::string& name : report.variants)
            result.state.variants.append(QString::fromStdString(name));
        result.state.variant = QString::fromStdString(report.variant);
        result.state.flights = flightsOf(report.flights);
        result.state.modified = report.modified;
        result.state.edits = report.edits;
        result.state.indoors = report.indoors;
        return result;
    } catch (const rtcore::FileError&) {
        return std::nullopt;
    }
}

} // namespace gui

#include "rtserver/commands/state_report_of.h"

#include "rtcore/io/text/camera_section.h"
#include "rtcore/io/text/toml_writer.h"
#include "rtcore/motion/flight_course.h"
#include "rtcore/motion/flight_edits.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/sky/scene_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

std::string nameOf(const rtcore::EnvironmentFile& environment) {
    if (environment.name.empty() && !environment.parts.empty()) return environment.parts.front();
    const bool named = !environment.name.empty() || environment.files.empty();
    return named ? environment.name : environment.files.front().stem().string();
}

std::optional<app::ReportedMap> mapOf(const Document& document) {
    const rtcore::Scene& scene = *document.scene();
    const rtcore::Environment* const shown = scene.environment();
    if (shown == nullptr || std::cmp_greater_equal(scene.activeEnvironment, scene.fileEnvironments()))
        return {};
    return app::ReportedMap{shown->rotation(), shown->intensity};
}

} // namespace

std::string scenePathOf(const Document& document) {
    return std::filesystem::absolute(document.world().source).lexically_normal().string();
}

std::vector<app::ReportedLight> lightsOf(const Document& document) {
    const rtcore::Scene& scene = *document.scene();
    std::vector<app::ReportedLight> all;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const rtcore::LightDescription light = rtcore::describeLight(scene, i);
        all.push_back({light.id, light.light.on != 0, light.name, light});
        if (traitsOf(light.light).beam == rtcore::Beam::Measured)
            all.back().power = rtcore::powerOf(scene.lights[i].light);
    }
    return all;
}

std::vector<app::NamedSwitch> environmentsOf(const Document& document) {
    const rtcore::Scene& scene = *document.scene();
    std::vector<app::NamedSwitch> all;
    for (std::size_t i = 0; i < scene.environments.size(); ++i) {
        const bool described = i < scene.environmentFiles.size();
        const std::string name =
            described ? nameOf(scene.environmentFiles[i]) : scene.environments[i]->name();
        all.push_back({std::cmp_equal(scene.activeEnvironment, i), name});
    }
    return all;
}

namespace {

/// Of the camera as files have it, so that it is the same in the next run: FNV-1a.
std::string wordOf(const rtcore::Camera& camera) {
    constexpr std::uint64_t kOffset = 0xCBF29CE484222325, kPrime = 0x100000001B3;
    rtcore::TomlWriter writer;
    rtcore::writeCamera(writer, camera);
    std::uint64_t hash = kOffset;
    for (const char c : writer.text()) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
    return fmt::format("{:016x}", hash);
}

/// The report of a step to the asking client, which is told the persons of its own steps alone.
app::ReportedEdit reportOf(const EditStep* step, std::uint64_t client) {
    if (step == nullptr) return {};
    const bool own = client != 0 && step->by.client == client;
    return {step->number, own ? step->by.person : 0};
}

app::ReportedFlight reportOf(const rtcore::Flight& flight, rtcore::Vec3 up, std::size_t keys) {
    app::ReportedFlight report{.name = flight.name,
                               .seconds = secondsOf(flight),
                               .timing = flight.timing,
                               .closed = flight.closed,
                               .turntable = flight.turns != 0,
                               .keyCount = static_cast<int>(flight.keys.size())};
    if (keys == 0) return report;
    constexpr double kThousand = 1000;
    const rtcore::FlightCourse course(flight, up);
    for (std::size_t key = 0; key < keys; ++key)
        report.keyTimes.push_back(static_cast<int>(std::lround(kThousand * course.timeOf(key))));
    return report;
}

std::vector<app::ReportedFlight> flightsOf(const Document& document) {
    std::vector<app::ReportedFlight> reports;
    std::size_t room = app::kMaxReportedKeys;
    for (const rtcore::Flight& flight : document.flights()) {
        const std::size_t keys = std::min(room, flight.keys.size());
        reports.push_back(reportOf(flight, document.scene()->up, keys));
        room -= keys;
    }
    return reports;
}

} // namespace

app::StateReport stateReportOf(const Document& document, std::uint64_t client) {
    app::StateReport report{.scene = scenePathOf(document),
                            .up = document.scene()->up,
                            .metresPerUnit = document.scene()->metresPerUnit,
                            .origin = document.scene()->origin,
                            .lights = lightsOf(document),
                            .environments = environmentsOf(document),
                            .map = mapOf(document),
                            .sky = document.scene()->sky,
                            .bounds = document.world().loaded.tree.bounds,
                            .sections = document.scene()->sections,
                            .measures = document.measures(),
                            .measureCount = static_cast<int>(document.measures().all.size()),
                            .notes = document.notes(),
                            .noteCount = static_cast<int>(document.notes().size()),
                            .camera = document.camera(),
                            .settings = rtcore::settingAssignments(document.settings(), true)};
    if (const auto sun = rtcore::sunOf(*document.scene()))
        report.sun = document.scene()->lights[*sun].notes.id;
    report.camera.nameOffset = 0;
    const EditHistory& history = document.history();
    if (history.last() != nullptr) report.undo = history.last()->label;
    if (history.next() != nullptr) report.redo = history.next()->label;
    report.undoEdit = reportOf(history.last(), client);
    report.redoEdit = reportOf(history.next(), client);
    report.modified = document.modified();
    report.indoors = document.world().loaded.indoors;
    for (const rtcore::SceneBookmark& bookmark : document.bookmarks()) {
        report.bookmarks.push_back(bookmark.name);
        report.bookmarkViews.push_back(wordOf(bookmark.camera));
    }
    report.flights = flightsOf(document);
    for (const rtcore::SceneVariant& variant : document.variants().all)
        report.variants.push_back(variant.name);
    report.variant = document.variants().active;
    report.edits = static_cast<int>(history.position());
    return report;
}

} // namespace rtserver

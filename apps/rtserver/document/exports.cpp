#include "rtserver/document/exports.h"

#include "rtserver/document/material_tables.h"

#include "rtcore/io/text/pattern.h"
#include "rtcore/io/variants/variant_switch.h"
#include "rtcore/scene/part_list.h"
#include "rtcore/settings/settings_table.h"
#include "rtcore/sky/scene_sky.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

// A model by itself has what the loader gives it.
rtcore::SceneFile descriptionOf(const World& world) {
    if (world.loaded.sceneFile) return *world.loaded.sceneFile;
    rtcore::SceneFile file;
    file.creaseAngle = world.import.creaseAngle.value_or(rtcore::kCreaseAngle);
    file.flipTextures = world.import.flipTextures.value_or(false);
    file.pose = world.import.pose.value_or(rtcore::PoseChoice{});
    file.deflection = world.import.deflection.value_or(rtcore::kDeflection);
    return file;
}

/// Those of the set, or, where these are fewer, all and then the others.
void addParts(const rtcore::Model& model, const rtcore::PartSet& set,
              std::optional<bool> rtcore::PartDescription::*key, rtcore::SceneFile& file) {
    if (set == nullptr) return;
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(model);
    const auto in = static_cast<std::size_t>(std::count_if(
        parts.begin(), parts.end(), [&](const rtcore::NamedPart& part) { return isIn(part, set); }));
    const bool mainlyIn = 2 * in > parts.size();
    const auto add = [&](std::string pattern, std::optional<int> number, bool value) {
        rtcore::PartDescription part{std::move(pattern), number, {}, {}};
        part.*key = value;
        file.parts.push_back(std::move(part));
    };
    if (mainlyIn) add("*", {}, true);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (isIn(parts[i], set) == mainlyIn) continue;
        if (parts[i].name.empty() || rtcore::isPattern(parts[i].name))
            add("", static_cast<int>(i) + 1, !mainlyIn);
        else
            add(std::string(parts[i].name), {}, !mainlyIn);
    }
}

void addParts(const rtcore::Scene& scene, rtcore::SceneFile& file) {
    file.parts.clear();
    addParts(scene.model, scene.hiddenParts, &rtcore::PartDescription::hidden, file);
    addParts(scene.model, scene.uncutParts, &rtcore::PartDescription::uncut, file);
}

void addLights(const rtcore::Scene& scene, rtcore::SceneFile& file) {
    const auto sun = rtcore::sunOf(scene);
    const bool skyBringsSun = !rtcore::isSunEdited(scene);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (sun != i || !skyBringsSun) file.lights.push_back(rtcore::describeLight(scene, i));
    }
    if (sun)
        file.sun = {scene.lights[*sun].notes.id, scene.lights[*sun].light.on != 0};
    else
        file.sun = {scene.sky && !scene.sky->studio ? rtcore::nextLightId(scene) : 0,
                    !scene.sky || scene.sky->studio}; // removed, it comes back off
}

/// The scene that the file says, of which its variants are: what is shown, where there are none.
rtcore::VariantScene baseOf(const Document& document) {
    rtcore::VariantScene base{*document.scene(), document.settings().skyLight.on};
    const VariantBook& book = document.variants();
    if (!book.all.empty())
        switchVariant(base, *book.base, differences(*book.base, base), rtcore::SceneVariant());
    return base;
}

void addVariants(const Document& document, const rtcore::VariantScene& base, rtcore::SceneFile& file) {
    const VariantBook& book = document.variants();
    file.variants = book.all;
    file.activeVariant = book.active;
    file.shown.reset();
    const rtcore::VariantScene shown{*document.scene(), document.settings().skyLight.on};
    rtcore::VariantScene active = base;
    switchVariant(active, base, rtcore::SceneVariant(), shownVariant(file));
    if (!book.all.empty() && !differences(active, shown).empty()) file.shown = differences(base, shown);
}

// All but the settings. Materials are those of the description and what was edited since; the rest is taken
// from the scene.
rtcore::SceneFile describe(const Document& document) {
    const World& world = document.world();
    const rtcore::VariantScene base = baseOf(document);
    const rtcore::Scene& scene = base.scene;
    rtcore::SceneFile file = descriptionOf(world);
    file.model = world.loaded.modelPath;
    static_cast<rtcore::SceneLook&>(file) = scene;
    if (scene.environments.empty()) file.activeEnvironment = 0;
    if (world.import.creaseAngle) file.creaseAngle = *world.import.creaseAngle;
    if (world.import.flipTextures) file.flipTextures = *world.import.flipTextures;
    if (world.import.pose) file.pose = *world.import.pose;
    if (world.import.deflection) file.deflection = *world.import.deflection;
    file.settings.reset();
    file.modelLights = file.defaultLight = false;
    file.lights.clear();
    addLights(scene, file);
    file.environments = scene.environmentFiles;
    addMaterialEdits(scene, file.materials);
    addParts(scene, file);
    file.cameraFile.reset();
    file.camera = document.camera();
    file.camera->nameOffset = 0;
    file.bookmarks = document.bookmarks();
    file.measures = document.measures();
    file.notes = document.notes();
    file.flights = document.flights();
    addVariants(document, base, file);
    return file;
}

/// Those of the base.
rtcore::RenderSettings settingsOf(const Document& document) {
    rtcore::RenderSettings settings = document.settings();
    settings.skyLight.on = baseOf(document).skyLight;
    return settings;
}

rtcore::RenderSettings settingsWith(const std::vector<rtcore::SettingAssignment>& assignments) {
    rtcore::RenderSettings settings;
    rtcore::applySettings(settings, assignments);
    return settings;
}

std::vector<rtcore::SettingAssignment> changed(const rtcore::RenderSettings& from,
                                               const rtcore::RenderSettings& to) {
    const auto before = rtcore::settingAssignments(from, true);
    std::vector<rtcore::SettingAssignment> all = rtcore::settingAssignments(to, true);
    std::erase_if(all, [&](const rtcore::SettingAssignment& each) {
        return std::find(before.begin(), before.end(), each) != before.end();
    });
    return all;
}

} // namespace

rtcore::CameraFile cameraFileOf(const Document& document, float exposure) {
    const rtcore::Scene& scene = *document.scene();
    const rtcore::RenderSettings& settings = document.settings();
    rtcore::CameraFile file;
    file.camera = document.camera();
    file.origin = scene.origin;
    file.camera.nameOffset = 0;
    file.width = settings.width;
    file.height = settings.height;
    file.antialiasing = settings.antialiasing;
    file.bloom = settings.bloom.radius;
    file.exposure = exposure;
    for (const rtcore::SceneLight& each : scene.lights)
        (each.light.on != 0 ? file.lightsOn : file.lightsOff).push_back(each.notes.id);
    if (scene.environment() != nullptr) file.environment = scene.activeEnvironment;
    return file;
}

rtcore::SceneFile sceneFileOf(const Document& document) {
    rtcore::SceneFile file = describe(document);
    file.output.reset(); // a copy of a scene does not overwrite the image of the first
    file.live = rtcore::settingAssignments(settingsOf(document), true);
    file.still = file.live;
    return file;
}

rtcore::SceneFile savedSceneOf(const Document& document) {
    const rtcore::LoadedScene& loaded = document.world().loaded;
    const rtcore::RenderSettings before = settingsWith(loaded.live);
    rtcore::RenderSettings live = settingsOf(document);
    live.width = before.width;
    live.height = before.height;
    rtcore::RenderSettings still = settingsWith(loaded.still);
    rtcore::applySettings(still, changed(before, live));
    rtcore::SceneFile file = describe(document);
    file.live = rtcore::settingAssignments(live, false);
    file.still = rtcore::settingAssignments(still, false);
    return file;
}

} // namespace rtserver

#include "common/settings/selection_options.h"

#include "common/settings/named_numbers.h"

#include "rtcore/settings/plain_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace app {

namespace {

constexpr std::size_t kMaxTold = 8;

/// "it has 'floor', 'box' and 3 more".
std::string someOf(std::span<const std::string> all) {
    if (all.empty()) return "it has none";
    std::string text = "it has ";
    const std::size_t told = std::min(all.size(), kMaxTold);
    for (std::size_t i = 0; i < told; ++i) {
        const bool last = i + 1 == told && told == all.size();
        text += (i == 0 ? "" : last ? " and " : ", ") + all[i];
    }
    return told == all.size() ? text : fmt::format("{} and {} more", text, all.size() - told);
}

std::string calledBy(std::size_t number, std::string_view name) {
    return name.empty() ? fmt::format("number {}", number) : rtcore::inQuotes(name);
}

void chooseParts(const char* option, const std::string& text, std::span<const rtcore::NamedPart> parts,
                 std::vector<std::uint8_t>& chosen) {
    const std::vector<std::size_t> found =
        numbersNamed(text, parts.size(), [&](std::size_t i) { return parts[i].name; });
    for (const std::size_t i : found) chosen[i] = 1;
    if (!found.empty()) return;
    std::vector<std::string> all;
    for (std::size_t i = 0; i < parts.size(); ++i) all.push_back(calledBy(i + 1, parts[i].name));
    throw UsageError(fmt::format("option '{}': no part of the model is {}; {}", option,
                                 rtcore::inQuotes(text), someOf(all)));
}

std::vector<std::size_t> lightsNamed(const std::string& text, const rtcore::Scene& scene) {
    if (text.empty()) return {};
    const auto nameOf = [&](std::size_t i) -> std::string_view { return scene.lights[i].name; };
    std::vector<std::size_t> found = fitting(text, scene.lights.size(), nameOf);
    const std::optional<std::int64_t> id = parseInteger(text);
    if (!found.empty() || !id || *id < 1 || *id > rtcore::kMaxLightId) return found;
    if (const auto light = rtcore::lightWithId(scene, static_cast<int>(*id))) found.push_back(*light);
    return found;
}

[[noreturn]] void refuseLight(const std::string& text, const rtcore::Scene& scene) {
    std::vector<std::string> all;
    for (const rtcore::SceneLight& each : scene.lights)
        all.push_back(std::to_string(each.notes.id) +
                      (each.name.empty() ? "" : ' ' + rtcore::inQuotes(each.name)));
    throw UsageError(fmt::format("option '--lights': no light of the scene is {}; {}", rtcore::inQuotes(text),
                                 someOf(all)));
}

} // namespace

Selection readSelection(const Arguments& arguments) {
    Selection selection;
    selection.isolated = arguments.all("isolate");
    for (const Occurrence& given : arguments.options()) {
        if (given.name == "hide" || given.name == "show")
            selection.parts.push_back({given.value, given.name == "hide"});
    }
    selection.sections = readSections(arguments);
    selection.uncut = arguments.all("section-except");
    selection.lights = arguments.text("lights");
    return selection;
}

void selectParts(const Selection& selection, rtcore::Scene& scene) {
    if (selection.isolated.empty() && selection.parts.empty() && selection.uncut.empty()) return;
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(scene.model);
    std::vector<std::uint8_t> chosen(parts.size());
    for (const std::string& text : selection.isolated) chooseParts("--isolate", text, parts, chosen);
    rtcore::HiddenParts hidden = scene.hiddenParts;
    if (!selection.isolated.empty()) hidden = allButParts(scene.model, parts, chosen);
    for (const Selection::Part& part : selection.parts) {
        std::ranges::fill(chosen, std::uint8_t{0});
        chooseParts(part.hide ? "--hide" : "--show", part.text, parts, chosen);
        hidden = withParts(scene.model, parts, chosen, part.hide, hidden);
    }
    scene.hiddenParts = hidden;
    if (selection.uncut.empty()) return;
    std::ranges::fill(chosen, std::uint8_t{0});
    for (const std::string& text : selection.uncut) chooseParts("--section-except", text, parts, chosen);
    scene.uncutParts = withParts(scene.model, parts, chosen, true, scene.uncutParts);
}

void selectLights(const Selection& selection, rtcore::Scene& scene) {
    if (!selection.lights) return;
    const std::string& list = *selection.lights;
    for (rtcore::SceneLight& each : scene.lights) each.light.on = list == "all" ? 1 : 0;
    if (list == "all" || list == "none") return;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        const std::string text = list.substr(begin, end - begin);
        const std::vector<std::size_t> found = lightsNamed(text, scene);
        if (found.empty()) refuseLight(text, scene);
        for (const std::size_t light : found) scene.lights[light].light.on = 1;
        begin = end + 1;
    }
}

} // namespace app

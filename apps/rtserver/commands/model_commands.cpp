// Commands for what the model consists of: its materials and its parts.
#include "rtserver/commands/command_call.h"
#include "rtserver/commands/model_objects.h"
#include "rtserver/document/model_edits.h"

#include "common/cli/command_line.h"

#include "rtcore/io/text/scn.h"
#include "rtcore/look/material_presets.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/survey/seen_object.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

constexpr int kMaskWidth = 512; ///< pixels, at most

const rtcore::Scene& sceneOf(const Call& call) { return *call.document().scene(); }
int firstOf(const Call& call) { return call.size() > 0 ? integer(call[0]) : 1; }

// --- Materials ---

Result materials(const Call& call) { return {.answer = materialLines(sceneOf(call), firstOf(call))}; }

Result materialGet(const Call& call) {
    const std::vector<std::size_t> all = materialsNamed(sceneOf(call), call[0]);
    return {.answer =
                materialText(sceneOf(call), call.document().world().loaded.scene.materials, all.front())};
}

Result materialSet(const Call& call) {
    const std::vector<std::size_t> all = materialsNamed(sceneOf(call), call[0]);
    if (call[1] == "diffuseTexture")
        throw app::UsageError("diffuseTexture names a file, which only a .scn file can give");
    try {
        editMaterials(call.document(), all, rtcore::parseMaterialKey(call[1], call.arguments.subspan(2)));
    } catch (const rtcore::FileError& error) {
        throw app::UsageError(rtcore::sentenceOf(error));
    }
    return {};
}

// All of TO are looked up before anything changes.
Result materialCopy(const Call& call) {
    const std::size_t from = materialsNamed(sceneOf(call), call[0]).front();
    std::vector<std::size_t> to;
    for (const std::string& text : call.arguments.subspan(1)) {
        const std::vector<std::size_t> more = materialsNamed(sceneOf(call), text);
        to.insert(to.end(), more.begin(), more.end());
    }
    copyMaterial(call.document(), from, to);
    return {};
}

Result materialPreset(const Call& call) {
    const std::vector<std::size_t> all = materialsNamed(sceneOf(call), call[0]);
    giveMaterials(call.document(), all, rtcore::materialPresetNamed(call[1]).look);
    return {};
}

Result presets(const Call&) {
    std::string text;
    for (const rtcore::MaterialPreset& each : rtcore::materialPresets())
        text.append(text.empty() ? "" : "\n").append(each.name);
    return {.answer = std::move(text)};
}

Result materialReset(const Call& call) {
    resetMaterials(call.document(), materialsNamed(sceneOf(call), call[0]));
    return {};
}

// --- Parts ---

Result parts(const Call& call) { return {.answer = partLines(sceneOf(call), firstOf(call))}; }

void setHidden(const Call& call, bool hide) {
    const rtcore::Scene& scene = sceneOf(call);
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(scene.model);
    const std::vector<std::uint8_t> chosen = partsNamed(parts, call.arguments);
    hideParts(call.document(), withParts(scene.model, parts, chosen, hide, scene.hiddenParts));
}

Result partHide(const Call& call) {
    setHidden(call, true);
    return {};
}

Result partShow(const Call& call) {
    setHidden(call, false);
    return {};
}

Result partIsolate(const Call& call) {
    const rtcore::Scene& scene = sceneOf(call);
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(scene.model);
    hideParts(call.document(), allButParts(scene.model, parts, partsNamed(parts, call.arguments)));
    return {};
}

Result partShowAll(const Call& call) {
    hideParts(call.document(), nullptr);
    return {};
}

// --- What is seen ---

Result seen(const Call& call) {
    const rtcore::RenderSettings& settings = call.document().settings();
    const rtcore::CameraRays view(call.document().camera(), settings.width, settings.height);
    const auto object = rtcore::seenObject(sceneOf(call), *call.document().tracer(), view,
                                           number(call[0]) * static_cast<float>(settings.width),
                                           number(call[1]) * static_cast<float>(settings.height));
    if (!object) throw rtcore::Refusal("nothing of the model is seen there");
    return {.answer = seenText(sceneOf(call), *object)};
}

/// By number in Model::parts: whether it is a piece of that part.
std::vector<bool> piecesOf(const rtcore::Scene& scene, std::size_t part) {
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(scene.model);
    if (part >= parts.size()) throw app::UsageError("the model has no such part; 'parts' lists them");
    std::vector<bool> pieces(scene.model.parts.size());
    for (const std::uint32_t piece : parts[part].pieces) pieces[piece] = true;
    return pieces;
}

Result mask(const Call& call) {
    const rtcore::Scene& scene = sceneOf(call);
    const auto index = static_cast<std::size_t>(integer(call[1]) - 1);
    const bool byPart = call[0] == "part";
    const std::vector<bool> pieces = byPart ? piecesOf(scene, index) : std::vector<bool>();
    if (!byPart && index >= scene.materials.size())
        throw app::UsageError("the model has no such material; 'materials' lists them");
    const rtcore::RenderSettings& settings = call.document().settings();
    const int width = std::min(settings.width, kMaskWidth);
    const int height = std::max(1, settings.height * width / settings.width);
    const rtcore::CameraRays view(call.document().camera(), width, height);
    std::vector<bool> mask;
    for (const auto& object : seenObjects(scene, *call.document().tracer(), view, width, height)) {
        const bool of =
            object && (byPart ? object->piece && pieces[*object->piece] : object->material == index);
        mask.push_back(of);
    }
    return {.answer = maskText(mask, width, height)};
}

constexpr std::array kModelFunctions{
    CommandFunction{app::CommandId::Materials, materials},
    CommandFunction{app::CommandId::MaterialGet, materialGet},
    CommandFunction{app::CommandId::MaterialPresets, presets},
    CommandFunction{app::CommandId::MaterialSet, materialSet},
    CommandFunction{app::CommandId::MaterialCopy, materialCopy},
    CommandFunction{app::CommandId::MaterialPreset, materialPreset},
    CommandFunction{app::CommandId::MaterialReset, materialReset},
    CommandFunction{app::CommandId::Parts, parts},
    CommandFunction{app::CommandId::PartHide, partHide},
    CommandFunction{app::CommandId::PartShow, partShow},
    CommandFunction{app::CommandId::PartIsolate, partIsolate},
    CommandFunction{app::CommandId::PartShowAll, partShowAll},
    CommandFunction{app::CommandId::Seen, seen},
    CommandFunction{app::CommandId::Mask, mask},
};

} // namespace

std::span<const CommandFunction> modelFunctions() { return kModelFunctions; }

} // namespace rtserver

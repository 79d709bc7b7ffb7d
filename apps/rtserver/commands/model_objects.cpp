#include "rtserver/commands/model_objects.h"

#include "ipc/layout/limits.h"

#include "common/cli/command_line.h"
#include "common/settings/named_numbers.h"

#include "rtcore/io/text/scn.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/material_edit.h"
#include "rtcore/scene/material_numbers.h"
#include "rtcore/scene/material_textures.h"
#include "rtcore/scene/metallic_roughness.h"
#include "rtcore/settings/plain_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

namespace rtserver {

namespace {

std::string_view materialName(const rtcore::Scene& scene, std::size_t index) {
    return scene.model.name(scene.materials[index].nameOffset);
}

constexpr const char* kNoMaterial = rtcore::form("no material of the model is {0}; 'materials' lists them");
constexpr const char* kNoPart = rtcore::form("no part of the model is {0}; 'parts' lists them");

/// At least one; `unknown` is a form.
std::vector<std::size_t> named(const std::string& text, std::size_t count, const char* unknown,
                               const app::NameOf& nameOf) {
    std::vector<std::size_t> all = app::numbersNamed(text, count, nameOf);
    if (!all.empty()) return all;
    throw app::UsageError(rtcore::say(unknown, rtcore::inQuotes(text)));
}

/// Lines as long as there is room; `lineOf` gives those from 0 on.
template <typename LineOf>
std::string lines(int first, std::size_t count, LineOf lineOf) {
    std::string text;
    for (auto i = static_cast<std::size_t>(first - 1); i < count; ++i) {
        const std::string line = lineOf(i);
        if (text.size() + 1 + line.size() > ipc::kMaxAnswerText) break;
        text += (text.empty() ? "" : "\n") + line;
    }
    return text;
}

std::string withName(std::string text, std::string_view name) {
    return name.empty() ? text : text + ' ' + rtcore::printable(name);
}

} // namespace

std::vector<std::size_t> materialsNamed(const rtcore::Scene& scene, const std::string& text) {
    return named(text, scene.materials.size(), kNoMaterial,
                 [&](std::size_t i) { return materialName(scene, i); });
}

std::vector<std::uint8_t> partsNamed(std::span<const rtcore::NamedPart> parts,
                                     std::span<const std::string> texts) {
    std::vector<std::uint8_t> chosen(parts.size());
    for (const std::string& text : texts) {
        for (const std::size_t i :
             named(text, parts.size(), kNoPart, [&](std::size_t k) { return parts[k].name; }))
            chosen[i] = 1;
    }
    return chosen;
}

std::string materialLines(const rtcore::Scene& scene, int first) {
    const auto isEdited = [&](std::size_t i) {
        return std::any_of(scene.materialEdits.begin(), scene.materialEdits.end(),
                           [&](const auto& edit) { return std::cmp_equal(*edit.number, i + 1); });
    };
    return lines(first, scene.materials.size(), [&](std::size_t i) {
        return withName(fmt::format("{} {}", i + 1, isEdited(i) ? "edited" : "-"), materialName(scene, i));
    });
}

std::string partLines(const rtcore::Scene& scene, int first) {
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(scene.model);
    return lines(first, parts.size(), [&](std::size_t i) {
        const char* const shown = isIn(parts[i], scene.hiddenParts) ? "hidden" : "shown";
        return withName(fmt::format("{} {} {}", i + 1, shown, parts[i].triangles), parts[i].name);
    });
}

std::string materialText(const rtcore::Scene& scene, std::span<const rtcore::Material> loaded,
                         std::size_t index) {
    const rtcore::Material& m = scene.materials[index];
    const rtcore::Material& own = loaded[index];
    rtcore::MaterialOverride all;
    all.pattern = rtcore::printable(materialName(scene, index));
    const rtcore::TextureMeans means = rtcore::roughnessMeans(scene.model, m);
    all.diffuse = m.diffuse;
    all.specular = m.specular;
    all.shininess = m.shininess;
    all.roughness = rtcore::roughnessOf(m) * means.roughness;
    all.metallic = m.metallic * means.metallic;
    all.reflectivity = m.mirror * m.mirrorScale;
    all.fresnel = m.fresnel != 0;
    all.transmission = m.transmission;
    for (const rtcore::MaterialNumber& number : rtcore::kMaterialNumbers)
        all.*number.change = m.*number.field;
    all.emission = m.emission;
    if (rtcore::hasTextures(own)) {
        all.textures = rtcore::hasTextures(m);
        all.flipTextures = m.flipTextures != 0;
    }
    std::string text = rtcore::formatMaterial(all);
    text.erase(0, text.find_first_not_of('\n'));
    if (text.ends_with('\n')) text.pop_back();
    return text;
}

std::string seenText(const rtcore::Scene& scene, const rtcore::SeenObject& seen) {
    std::string part = "part 0";
    if (seen.piece) {
        const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(scene.model);
        const std::string_view name = scene.model.name(scene.model.parts[*seen.piece].nameOffset);
        const auto at =
            std::find_if(parts.begin(), parts.end(), [&](const auto& each) { return each.name == name; });
        part = withName(fmt::format("part {}", at - parts.begin() + 1), name);
    }
    return part + '\n' +
           withName(fmt::format("material {}", seen.material + 1), materialName(scene, seen.material));
}

std::string maskText(const std::vector<bool>& mask, int width, int height) {
    for (int step = 1;; ++step) {
        const int w = (width + step - 1) / step, h = (height + step - 1) / step;
        std::string text = fmt::format("{} {}", w, h);
        bool value = false;
        int run = 0;
        const auto end = [&] { fmt::format_to(std::back_inserter(text), " {}", run); };
        for (int y = 0; y < h; ++y) {
            for (int x = 0; x < w; ++x) {
                const auto at = static_cast<std::size_t>(y * step) * static_cast<std::size_t>(width) +
                                static_cast<std::size_t>(x * step);
                if (mask[at] != value) {
                    end();
                    value = !value;
                    run = 0;
                }
                ++run;
            }
        }
        end();
        if (text.size() <= ipc::kMaxAnswerText) return text;
    }
}

} // namespace rtserver

#include "rtcore/io/import/gltf/extensions.h"

#include "rtcore/io/import/gltf/draco_mesh.h"
#include "rtcore/io/import/gltf/images.h"
#include "rtcore/io/import/gltf/instances.h"
#include "rtcore/io/import/gltf/meshopt_view.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/import_report.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore::gltf {

namespace {

/// Those from KHR_animation_pointer on change nothing that is seen in a still scene.
constexpr std::array<std::string_view, 25> kRead{"KHR_lights_punctual",
                                                 "KHR_materials_emissive_strength",
                                                 "KHR_materials_ior",
                                                 "KHR_materials_specular",
                                                 "KHR_materials_pbrSpecularGlossiness",
                                                 "KHR_materials_transmission",
                                                 "KHR_materials_unlit",
                                                 "KHR_materials_volume",
                                                 "KHR_texture_transform",
                                                 "KHR_mesh_quantization",
                                                 "KHR_node_visibility",
                                                 "KHR_materials_clearcoat",
                                                 "EXT_mesh_gpu_instancing",
                                                 "EXT_lights_ies",
                                                 "EXT_texture_webp",
                                                 "MSFT_texture_dds",
                                                 "KHR_animation_pointer",
                                                 "FB_ngon_encoding",
                                                 "KHR_technique_webgl",
                                                 "KHR_techniques_webgl",
                                                 "KHR_xmp",
                                                 "KHR_xmp_json_ld",
                                                 "MSFT_lod",
                                                 "KHR_audio_emitter",
                                                 "KHR_node_selectability"};

struct Row {
    std::string_view extension;
    const char* words;
};

/// Of those that say how positions are stored.
constexpr std::array kGeometry{Row{kDracoExtension, form("export without it (gltf-pipeline without -d)")},
                               Row{kMeshoptExtension, import_forms::kWithoutMeshopt},
                               Row{"KHR_meshopt_compression", import_forms::kWithoutMeshopt},
                               Row{"KHR_gaussian_splatting", form("make a mesh of it")}};

constexpr std::array kRemedies{Row{"KHR_texture_basisu", import_forms::kWithoutBasis},
                               Row{"EXT_texture_avif", import_forms::kPlainImages}};

constexpr std::array kLosses{
    Row{"KHR_materials_sheen", form("the sheen of cloth")},
    Row{"KHR_materials_anisotropy", form("the drawn-out highlights of brushed metal")},
    Row{"KHR_materials_iridescence", form("the colours of thin films")},
    Row{"KHR_materials_dispersion", form("the colours that glass parts light into")},
    Row{"KHR_materials_diffuse_transmission", form("light that passes through leaves and paper")},
    Row{"KHR_materials_variants", form("all variants of its materials but the first")},
    Row{"KHR_texture_basisu", form("images of Basis Universal, whose materials are plain")},
    Row{"EXT_texture_avif", form("images of AVIF, whose materials are plain")},
    Row{"EXT_lights_image_based", form("the light of its surroundings")}};

const char* wordsFor(std::span<const Row> rows, const std::string& name) {
    const auto at = std::ranges::find(rows, std::string_view(name), &Row::extension);
    return at != rows.end() ? at->words : nullptr;
}

bool isRead(const std::string& name) {
    if (name == kDracoExtension) return readsDraco();
    if (name == kMeshoptExtension) return readsMeshopt();
    return std::ranges::find(kRead, std::string_view(name)) != kRead.end();
}

std::vector<std::string> unreadIn(const Json& root, const char* list) {
    std::vector<std::string> names;
    for (const Json& entry : member(root, list)) {
        const std::string name = entry.is_string() ? entry.get<std::string>() : std::string();
        if (!name.empty() && !isRead(name) && std::ranges::find(names, name) == names.end())
            names.push_back(name);
    }
    return names;
}

Sentence needing(const std::vector<std::string>& names) {
    const char* remedy = wordsFor(kGeometry, names[0]);
    if (remedy == nullptr) remedy = wordsFor(kRemedies, names[0]);
    if (remedy == nullptr) remedy = import_forms::kWithout;
    if (names.size() == 1) return say(import_forms::kNeedsOne, names[0], remedy);
    std::string others = names[1];
    for (std::size_t i = 2; i < names.size(); ++i) others += " and " + names[i];
    return say(import_forms::kNeedsMore, names[0], others, remedy);
}

std::vector<std::string> unreadRequirements(const Json& root) {
    std::vector<std::string> names = unreadIn(root, "extensionsRequired");
    std::erase_if(names, [](const std::string& name) { return name.starts_with("KHR_materials_"); });
    return names;
}

} // namespace

Needs needsOf(const Json& root) {
    const std::vector<std::string> names = unreadRequirements(root);
    if (names.empty()) return {};
    const bool fatal = std::ranges::any_of(
        names, [](const std::string& name) { return wordsFor(kGeometry, name) != nullptr; });
    return fatal ? Needs{needing(names), std::nullopt} : Needs{std::nullopt, needing(names)};
}

std::optional<Sentence> ignoredOf(const Json& root) {
    std::vector<std::string> names = unreadIn(root, "extensionsUsed");
    const std::vector<std::string> required = unreadRequirements(root); // which are told as such
    std::erase_if(names, [&](const std::string& name) {
        // Beside images that all read, those of other formats are not needed.
        const bool ofImages = name == "KHR_texture_basisu" || name == "EXT_texture_avif";
        return (ofImages && !needsImagesOf(root, name)) ||
               std::ranges::find(required, name) != required.end();
    });
    if (names.empty()) return std::nullopt;
    std::optional<Sentence> lost;
    for (const std::string& name : names) {
        const char* const words = wordsFor(kLosses, name);
        if (words != nullptr) lost = lost ? say(import_forms::kComma, *lost, words) : Sentence(words);
    }
    return lost ? say(import_forms::kIgnoredLost, firstOf(names), *lost)
                : say(import_forms::kIgnored, firstOf(names));
}

} // namespace rtcore::gltf

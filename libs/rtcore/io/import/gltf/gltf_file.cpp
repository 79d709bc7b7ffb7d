#include "rtcore/io/import/gltf/gltf_file.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/platform/files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kGlbHead = 20; ///< magic, version, length; length and kind of the first chunk

std::string_view gltfText(const FileBytes& file) {
    return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

/// The JSON of a .glb is its first chunk.
std::string_view jsonOf(const std::filesystem::path& path, std::string_view text) {
    if (!text.starts_with("glTF")) return path.extension() == ".gltf" ? text : std::string_view();
    std::uint32_t version = 0, length = 0;
    if (text.size() < kGlbHead) return {};
    std::memcpy(&version, text.data() + 4, sizeof version);
    std::memcpy(&length, text.data() + 12, sizeof length);
    return version == 2 ? text.substr(kGlbHead, length) : std::string_view();
}

/// A member that may be missing; throws Json::exception when the parent is no object.
const Json& member(const Json& object, const char* name) {
    static const Json none;
    const auto at = object.find(name);
    return at != object.end() ? *at : none;
}

std::uint64_t countOf(const Json& accessors, const Json& index) {
    constexpr std::uint64_t kMax = std::uint64_t{1} << 32U;
    return std::min(accessors.at(index.get<std::size_t>()).at("count").get<std::uint64_t>(), kMax);
}

std::uint64_t trianglesOf(const Json& primitive, const Json& accessors) {
    const Json& indices = member(primitive, "indices");
    const Json& corners = indices.is_null() ? member(primitive.at("attributes"), "POSITION") : indices;
    if (corners.is_null()) return 0;
    const std::uint64_t count = countOf(accessors, corners);
    const int mode = primitive.value("mode", 4);
    if (mode == 4) return count / 3;
    return (mode == 5 || mode == 6) && count > 2 ? count - 2 : 0; // strip, fan
}

/// The meshes of the nodes that the shown scene reaches, each once.
std::set<std::size_t> shownMeshes(const Json& root) {
    const Json &scenes = member(root, "scenes"), &nodes = member(root, "nodes");
    const auto shown = root.value("scene", std::size_t{0});
    std::set<std::size_t> meshes, visited;
    std::vector<std::size_t> open;
    const auto addAll = [&](const Json& numbers) {
        for (const Json& number : numbers) open.push_back(number.get<std::size_t>());
    };
    if (shown < scenes.size()) addAll(member(scenes[shown], "nodes"));
    while (!open.empty()) {
        const std::size_t number = open.back();
        open.pop_back();
        if (number >= nodes.size() || !visited.insert(number).second) continue;
        const Json& mesh = member(nodes[number], "mesh");
        if (!mesh.is_null()) meshes.insert(mesh.get<std::size_t>());
        addAll(member(nodes[number], "children"));
    }
    return meshes;
}

/// Without those that no node of the scene shows: they are not read.
std::uint64_t declaredTriangles(const Json& root) {
    std::uint64_t triangles = 0;
    for (const std::size_t mesh : shownMeshes(root)) {
        for (const Json& primitive : member(root, "meshes").at(mesh).at("primitives"))
            triangles += trianglesOf(primitive, member(root, "accessors"));
    }
    return triangles;
}

/// Without those numbers of vertices of which some colours have an alpha and some have none.
std::set<std::uint64_t> countsOfColoursWithAlpha(const Json& root) {
    std::set<std::uint64_t> with, without;
    const Json& accessors = member(root, "accessors");
    for (const Json& mesh : member(root, "meshes")) {
        for (const Json& primitive : mesh.at("primitives")) {
            const Json& colour = member(primitive.at("attributes"), "COLOR_0");
            if (colour.is_null()) continue;
            const bool alpha = accessors.at(colour.get<std::size_t>()).value("type", "") == "VEC4";
            (alpha ? with : without).insert(countOf(accessors, colour));
        }
    }
    for (const std::uint64_t count : without) with.erase(count);
    return with;
}

std::vector<std::string> missingBuffersOf(const Json& root, const std::filesystem::path& folder) {
    std::vector<std::string> missing;
    for (const Json& buffer : member(root, "buffers")) {
        const std::string uri = buffer.value("uri", "");
        std::error_code error;
        if (uri.empty() || uri.starts_with("data:")) continue;
        if (!std::filesystem::exists(folder / uri, error)) missing.push_back(uri);
    }
    return missing;
}

std::vector<float> emissiveStrengthsOf(const Json& root) {
    std::vector<float> strengths;
    for (const Json& material : member(root, "materials")) {
        const Json& extension = member(member(material, "extensions"), "KHR_materials_emissive_strength");
        strengths.push_back(extension.is_null() ? 1.0F : extension.value("emissiveStrength", 1.0F));
    }
    return strengths;
}

/// Those behind the compression do not change what is seen.
bool isKnown(const std::string& extension) {
    static constexpr std::array kKnown{"KHR_lights_punctual",
                                       "KHR_materials_emissive_strength",
                                       "KHR_materials_ior",
                                       "KHR_materials_pbrSpecularGlossiness",
                                       "KHR_materials_transmission",
                                       "KHR_materials_unlit",
                                       "KHR_materials_volume",
                                       "KHR_texture_transform",
                                       "KHR_draco_mesh_compression",
                                       "KHR_animation_pointer",
                                       "FB_ngon_encoding",
                                       "KHR_technique_webgl",
                                       "KHR_xmp",
                                       "KHR_xmp_json_ld",
                                       "KHR_techniques_webgl"};
    return std::find(kKnown.begin(), kKnown.end(), extension) != kKnown.end();
}

std::vector<std::string> unknownIn(const Json& extensions) {
    std::vector<std::string> unknown;
    for (const Json& name : extensions) {
        const auto extension = name.get<std::string>();
        if (!isKnown(extension)) unknown.push_back(extension);
    }
    return unknown;
}

/// Without extensions of materials, which are ignored even if required: the rest of the model is right.
std::vector<std::string> unreadRequirementsOf(const Json& root) {
    std::vector<std::string> unread = unknownIn(member(root, "extensionsRequired"));
    std::erase_if(unread, [](const std::string& name) { return name.starts_with("KHR_materials_"); });
    return unread;
}

bool storesPositions(const std::string& extension) {
    return extension == "KHR_mesh_quantization" || extension == "EXT_meshopt_compression" ||
           extension == "KHR_meshopt_compression";
}

/// The version that its asset states; "" where it states none.
std::string versionOf(const Json& root) {
    if (!root.is_object() || !member(root, "asset").is_object()) return "";
    const Json& version = member(member(root, "asset"), "version");
    return version.is_string() ? version.get<std::string>() : "";
}

/// Damage to the head of a .glb. Files that are cut off are another matter (cut_off.h).
std::optional<Sentence> damageOfBinary(std::string_view text) {
    std::uint32_t version = 0;
    if (text.size() < kGlbHead) return {};
    std::memcpy(&version, text.data() + 4, sizeof version);
    if (version != 2)
        return say("it is glTF {0} in a binary file, which is not read; export it as glTF 2.0", version);
    if (text.substr(16, 4) != "JSON")
        return say("its first chunk holds no JSON; it is damaged: copy or export it again");
    std::uint32_t length = 0;
    std::memcpy(&length, text.data() + 12, sizeof length);
    if (length > text.size() - kGlbHead)
        return say("its first chunk is longer than the file; it is damaged: copy or export it again");
    return {};
}

} // namespace

Sentence remedyFor(const std::string& extension) {
    using Row = std::pair<std::string_view, const char*>;
    static constexpr std::array kRemedies{Row{"KHR_mesh_quantization", import_forms::kWithoutQuantization},
                                          Row{"EXT_meshopt_compression", import_forms::kWithoutMeshopt},
                                          Row{"KHR_meshopt_compression", import_forms::kWithoutMeshopt},
                                          Row{"KHR_texture_basisu", import_forms::kWithoutBasis},
                                          Row{"EXT_texture_webp", import_forms::kWithoutWebp},
                                          Row{"EXT_texture_avif", import_forms::kPlainImages},
                                          Row{"MSFT_texture_dds", import_forms::kPlainImages},
                                          Row{"EXT_mesh_gpu_instancing", import_forms::kWithoutInstancing}};
    for (const auto& [name, remedy] : kRemedies)
        if (extension == name) return remedy;
    return import_forms::kWithout;
}

std::optional<GltfFile> readGltfFile(const std::filesystem::path& path) {
    const FileBytes file = openFileBytes(path);
    const std::string_view text = jsonOf(path, gltfText(file));
    if (text.empty()) return {};
    try {
        const Json root = Json::parse(text);
        if (member(member(root, "asset"), "version").get<std::string>().substr(0, 1) != "2") return {};
        const std::vector<std::string> requirements = unreadRequirementsOf(root);
        std::vector<std::string> ignored = unknownIn(member(root, "extensionsUsed"));
        std::erase_if(ignored, [&](const std::string& name) { // told once
            return std::find(requirements.begin(), requirements.end(), name) != requirements.end();
        });
        return GltfFile{missingBuffersOf(root, path.parent_path()),
                        emissiveStrengthsOf(root),
                        ignored,
                        requirements,
                        std::any_of(requirements.begin(), requirements.end(), storesPositions),
                        member(root, "asset").value("generator", ""),
                        declaredTriangles(root),
                        countsOfColoursWithAlpha(root)};
    } catch (const Json::exception&) {
        return {};
    }
}

std::optional<Sentence> gltfDamage(const std::filesystem::path& path) {
    const FileBytes file = openFileBytes(path);
    const std::string_view whole = gltfText(file);
    if (whole.starts_with("glTF"))
        if (auto damage = damageOfBinary(whole)) return damage;
    const std::string_view text = jsonOf(path, whole);
    if (text.empty()) return {};
    try {
        const std::string version = versionOf(Json::parse(text));
        if (version.empty()) return say("its JSON does not say which version of glTF it is; export it again");
        if (version[0] != '1' && version[0] != '2')
            return say("it is glTF {0}, which is not read; export it as glTF 2.0", version);
    } catch (const Json::parse_error& error) {
        if (error.byte > text.size() && text.size() == whole.size())
            return say("it is cut off: its JSON does not end within {0} bytes; copy it again", text.size());
        return say("its JSON is damaged at byte {0}; copy or export it again",
                   error.byte + static_cast<std::size_t>(text.data() - whole.data()));
    }
    return {};
}

} // namespace rtcore

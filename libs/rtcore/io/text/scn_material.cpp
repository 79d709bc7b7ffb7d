#include "rtcore/io/text/scn_sections.h"
#include "rtcore/io/text/text_file.h"

#include <charconv>
#include <limits>
#include <system_error>
#include <utility>

namespace rtcore {

namespace {

constexpr Limits kShininess{.minimum = 0, .maximum = 100'000};
constexpr Limits kIndexOfRefraction{.minimum = 1, .maximum = 5};

void readChanges(StrictTable& table, const std::filesystem::path& folder, MaterialOverride& material) {
    material.diffuse = table.colour("diffuse", kShare);
    material.specular = table.colour("specular", kShare);
    material.shininess = table.number("shininess", kShininess);
    material.roughness = table.number("roughness", kShare);
    material.metallic = table.number("metallic", kShare);
    material.reflectivity = table.colourOrNumber("reflectivity", kShare);
    material.fresnel = table.boolean("fresnel");
    material.opacity = table.number("opacity", kShare);
    material.transmission = table.colour("transmission", kShare);
    material.attenuationDistance = table.number("attenuationDistance", kNotNegative);
    material.indexOfRefraction = table.number("indexOfRefraction", kIndexOfRefraction);
    material.emission = table.colour("emission", kNotNegative);
    material.textures = table.boolean("textures");
    material.flipTextures = table.boolean("flipTextures");
    material.diffuseTexture = table.path("diffuseTexture", folder);
}

constexpr TextPosition kNowhere{0, 0};

TextValue valueOf(const std::string& word) {
    if (word == "true" || word == "false") return {kNowhere, word == "true"};
    double number = 0;
    const char* const end = word.data() + word.size();
    const auto [at, error] = std::from_chars(word.data(), end, number);
    if (error == std::errc() && at == end) return {kNowhere, number};
    return {kNowhere, word};
}

TextValue valueOf(std::span<const std::string> words) {
    if (words.size() == 1) return valueOf(words.front());
    TextArray all;
    for (const std::string& word : words) all.push_back(valueOf(word));
    return {kNowhere, std::move(all)};
}

} // namespace

MaterialOverride parseMaterialKey(const std::string& key, std::span<const std::string> words) {
    const std::string noFile;
    TextTable table;
    table.entries.push_back({key, kNowhere, valueOf(words)});
    const TextValue content{kNowhere, std::move(table)};
    MaterialOverride material;
    StrictTable change(content, noFile);
    readChanges(change, {}, material);
    change.finish();
    return material;
}

std::string formatMaterial(const MaterialOverride& material) {
    TomlWriter writer;
    writeMaterial(writer, material, {});
    return writer.text();
}

NameOrNumber readNameOrNumber(StrictTable& table, std::string_view what) {
    return {table.text("name"), table.integer("number", 1, std::numeric_limits<int>::max()), what};
}

void NameOrNumber::check(const StrictTable& table) const {
    table.needVersion(2, "number");
    if (name && number) table.fail("number", "name and number are both given; leave one out");
    if (!number) table.require("name", name);
    if (name && name->empty())
        table.fail("name", "name is empty; give " + std::string(what) + "'s name or a pattern, \"*\"");
}

MaterialOverride readMaterial(StrictTable& table, const std::filesystem::path& folder) {
    const NameOrNumber which = readNameOrNumber(table, "a material");
    MaterialOverride material;
    readChanges(table, folder, material);
    for (const char* key : {"roughness", "metallic", "textures", "flipTextures"}) table.needVersion(2, key);
    table.finish();

    which.check(table);
    material.pattern = which.name.value_or("");
    material.number = which.number;
    // The limit is widened by rounding: 0.9 and 0.1 must do.
    const bool both = material.diffuse && material.specular;
    if (both && maxComponent(*material.diffuse + *material.specular) > 1.000001F)
        table.fail("specular",
                   "diffuse and specular together exceed 1; a surface gives back no more light than it gets");
    return material;
}

void writeMaterial(TomlWriter& writer, const MaterialOverride& material,
                   const std::filesystem::path& folder) {
    writer.section("[[material]]");
    material.number ? writer.add("number", *material.number) : writer.add("name", material.pattern);
    writer.add("diffuse", material.diffuse);
    writer.add("specular", material.specular);
    writer.add("shininess", material.shininess);
    writer.add("roughness", material.roughness);
    writer.add("metallic", material.metallic);
    writer.add("reflectivity", material.reflectivity);
    writer.add("fresnel", material.fresnel);
    writer.add("opacity", material.opacity);
    writer.add("transmission", material.transmission);
    writer.add("attenuationDistance", material.attenuationDistance);
    writer.add("indexOfRefraction", material.indexOfRefraction);
    writer.add("emission", material.emission);
    writer.add("textures", material.textures);
    writer.add("flipTextures", material.flipTextures);
    if (material.diffuseTexture)
        writer.add("diffuseTexture", pathToUtf8(pathSeenFrom(folder, *material.diffuseTexture)));
}

} // namespace rtcore

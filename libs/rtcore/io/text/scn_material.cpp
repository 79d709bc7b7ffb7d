#include "rtcore/io/text/scn_sections.h"
#include "rtcore/io/text/text_file.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/material_numbers.h"
#include "rtcore/settings/number_text.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

namespace rtcore {

namespace {

using Override = MaterialOverride;

/// A key that changes a material, beside `diffuseTexture`.
struct MaterialKey {
    std::string_view name;
    std::variant<std::optional<Colour> Override::*, std::optional<float> Override::*,
                 std::optional<bool> Override::*>
        member;
    Limits limits = kUnitRange; ///< of numbers and of each part of a colour
    bool alsoNumber = false;    ///< a colour that may be one number, which is grey
    int version = 1;            ///< of files that have it
    bool whole = false;         ///< a number without a fraction
};

std::vector<MaterialKey> makeKeys() {
    std::vector<MaterialKey> keys{{"diffuse", &Override::diffuse},
                                  {"specular", &Override::specular},
                                  {"shininess", &Override::shininess, {.minimum = 0, .maximum = 100'000}},
                                  {"roughness", &Override::roughness, kUnitRange, false, 2},
                                  {"metallic", &Override::metallic, kUnitRange, false, 2},
                                  {"reflectivity", &Override::reflectivity, kUnitRange, true},
                                  {"fresnel", &Override::fresnel},
                                  {"transmission", &Override::transmission}};
    for (const MaterialNumber& each : kMaterialNumbers)
        keys.push_back({each.key,
                        each.change,
                        {.minimum = each.minimum, .maximum = each.maximum},
                        false,
                        each.version,
                        each.whole});
    keys.insert(keys.end(), {{"emission", &Override::emission, kNotNegative},
                             {"textures", &Override::textures, kUnitRange, false, 2},
                             {"flipTextures", &Override::flipTextures, kUnitRange, false, 2}});
    return keys;
}

/// In the order in which they are written.
const std::vector<MaterialKey>& keys() {
    static const std::vector<MaterialKey> all = makeKeys();
    return all;
}

struct Reader {
    StrictTable& table;
    const MaterialKey& key;
    MaterialOverride& material;

    void operator()(std::optional<Colour> Override::*member) const {
        material.*member =
            key.alsoNumber ? table.colourOrNumber(key.name, key.limits) : table.colour(key.name, key.limits);
    }
    void operator()(std::optional<float> Override::*member) const {
        const std::optional<float> value = material.*member = table.number(key.name, key.limits);
        if (!key.whole || !value || *value == std::floor(*value)) return;
        const Sentence range = say("a whole number from {0} to {1}", static_cast<int>(key.limits.minimum),
                                   static_cast<int>(key.limits.maximum));
        table.fail(key.name, say("{0} is {1}, but takes {2}", key.name, shortestText(*value), range));
    }
    void operator()(std::optional<bool> Override::*member) const {
        material.*member = table.boolean(key.name);
    }
};

struct Writer {
    TomlWriter& writer;
    const MaterialKey& key;
    const MaterialOverride& material;

    void operator()(std::optional<float> Override::*member) const {
        const std::optional<float>& value = material.*member;
        if (key.whole && value)
            writer.add(key.name, static_cast<int>(*value));
        else
            writer.add(key.name, value);
    }
    void operator()(auto member) const { writer.add(key.name, material.*member); }
};

void readChanges(StrictTable& table, const std::filesystem::path& folder, MaterialOverride& material) {
    for (const MaterialKey& key : keys()) std::visit(Reader{table, key, material}, key.member);
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

std::span<const std::string_view> materialKeys() {
    static const auto names = [] {
        std::vector<std::string_view> all;
        for (const MaterialKey& key : keys()) all.push_back(key.name);
        return all;
    }();
    return names;
}

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
    if (name && number)
        table.fail("number", say("{0} and {1} are both given; leave one out", std::string("name"),
                                 std::string("number")));
    if (!number) table.require("name", name);
    if (name && name->empty())
        table.fail("name", say("name is empty; give {0}'s name or a pattern, \"*\"", what));
}

MaterialOverride readMaterial(StrictTable& table, const std::filesystem::path& folder) {
    const NameOrNumber which = readNameOrNumber(table, "a material");
    MaterialOverride material;
    readChanges(table, folder, material);
    for (const MaterialKey& key : keys())
        if (key.version > 1) table.needVersion(key.version, key.name);
    table.finish();

    which.check(table);
    material.pattern = which.name.value_or("");
    material.number = which.number;
    // The limit is widened by rounding: 0.9 and 0.1 must do.
    const bool both = material.diffuse && material.specular;
    if (both && maxComponent(*material.diffuse + *material.specular) > 1.000001F)
        table.fail(
            "specular",
            say("diffuse and specular together exceed 1; a surface gives back no more light than it gets"));
    return material;
}

void writeMaterial(TomlWriter& writer, const MaterialOverride& material, const std::filesystem::path& folder,
                   std::string_view header) {
    writer.section(header);
    material.number ? writer.add("number", *material.number) : writer.add("name", material.pattern);
    for (const MaterialKey& key : keys()) std::visit(Writer{writer, key, material}, key.member);
    if (material.diffuseTexture)
        writer.add("diffuseTexture", pathToUtf8(pathSeenFrom(folder, *material.diffuseTexture)));
}

} // namespace rtcore

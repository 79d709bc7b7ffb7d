#include "rtcore/io/text/scn_sections.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <limits>
#include <set>

namespace rtcore {

namespace {

VariantSurroundings readSurroundings(StrictTable& table) {
    VariantSurroundings result;
    result.background = table.colour("background", kNotNegative).value_or(Colour{});
    result.ambient = table.colour("ambient", kNotNegative).value_or(Colour{});
    result.environment = table.integer("environment", kNoEnvironment, std::numeric_limits<int>::max());
    if (auto sky = table.table("sky")) {
        result.sunId = sky->integer("sunId", 1, kMaxLightId).value_or(0);
        result.sky = readSky(*sky);
    }
    result.skyLight = table.boolean("skyLight").value_or(result.sky || result.environment.value_or(-1) >= 0);
    table.finish();
    return result;
}

void readVariantLights(StrictTable& table, const std::filesystem::path& folder, SceneVariant& variant) {
    std::set<int> ids;
    for (StrictTable& each : table.tables("light")) {
        const LightDescription light = readLight(each, folder);
        if (light.id == 0) each.failMissing("id");
        if (!ids.insert(light.id).second) each.fail("id", say("two lights have the id {0}", light.id));
        variant.lights.push_back(light);
    }
    const auto removed = table.integers("removedLights", 1, kMaxLightId);
    if (!removed) return;
    variant.removedLights = *removed;
    for (const int id : *removed)
        if (!ids.insert(id).second)
            table.fail("removedLights", say("light {0} is given twice, or is a [[light]] as well", id));
}

SceneVariant readContent(StrictTable& table, const std::filesystem::path& folder) {
    SceneVariant variant;
    for (StrictTable& each : table.tables("material")) {
        variant.materials.push_back(readMaterial(each, folder));
        if (variant.materials.back().diffuseTexture)
            each.fail("diffuseTexture",
                      say("a variant takes no textures from files; give it to a [[material]] "
                          "of the scene"));
    }
    for (StrictTable& each : table.tables("part")) {
        variant.parts.push_back(readPart(each));
        if (variant.parts.back().uncut)
            each.fail("uncut", say("a variant hides and shows parts; give this to a [[part]] of the scene"));
    }
    readVariantLights(table, folder, variant);
    if (auto surroundings = table.table("surroundings"))
        variant.surroundings = readSurroundings(*surroundings);
    return variant;
}

void writeSurroundings(TomlWriter& writer, const VariantSurroundings& all, const std::string& header) {
    writer.section("[" + header + "]");
    writer.add("background", all.background);
    writer.add("ambient", all.ambient);
    writer.add("skyLight", all.skyLight);
    writer.add("environment", all.environment);
    if (!all.sky) return;
    writeSky(writer, *all.sky, "[" + header + ".sky]");
    if (all.sunId != 0) writer.add("sunId", all.sunId);
}

} // namespace

SceneVariants::const_iterator findVariant(const SceneVariants& variants, std::string_view name) {
    return std::ranges::find(variants, name, &SceneVariant::name);
}

std::optional<Sentence> problemOfVariantName(const std::string& name) {
    if (name.empty()) return say("name is empty; a variant is known by its name");
    if (name.size() > kMaxVariantName || printable(name) != name)
        return say("the name of a variant is UTF-8 of at most {0} bytes, without control characters",
                   kMaxVariantName);
    return std::nullopt;
}

SceneVariants readVariants(StrictTable& root, const std::filesystem::path& folder) {
    SceneVariants variants;
    for (StrictTable& table : root.tables("variant")) {
        root.needVersion(2, "variant");
        if (variants.size() == kMaxVariants)
            table.fail("name", say("there are more than {0} variants; leave some out", kMaxVariants));
        const auto name = table.text("name");
        SceneVariant variant = readContent(table, folder);
        table.finish();
        variant.name = table.require("name", name);
        if (const auto problem = problemOfVariantName(variant.name)) table.fail("name", *problem);
        if (findVariant(variants, variant.name) != variants.end())
            table.fail("name", say("another variant is called {0}, too", inQuotes(variant.name)));
        variants.push_back(std::move(variant));
    }
    return variants;
}

std::optional<SceneVariant> readShown(StrictTable& root, const std::filesystem::path& folder) {
    auto table = root.table("shown");
    if (!table) return std::nullopt;
    root.needVersion(2, "shown");
    SceneVariant shown = readContent(*table, folder);
    table->finish();
    return shown;
}

void writeVariant(TomlWriter& writer, const SceneVariant& variant, const std::filesystem::path& folder,
                  const LocalOrigin& zero) {
    const bool shown = variant.name.empty();
    const std::string header = shown ? "shown" : "variant";
    const auto listOf = [&](const char* what) { return "[[" + header + "." + what + "]]"; };
    writer.section(shown ? "[shown]" : "[[variant]]");
    if (!shown) writer.add("name", variant.name);
    if (!variant.removedLights.empty()) writer.add("removedLights", variant.removedLights);
    for (const MaterialOverride& each : variant.materials)
        writeMaterial(writer, each, folder, listOf("material"));
    for (const PartDescription& each : variant.parts) writePart(writer, each, listOf("part"));
    for (const LightDescription& each : variant.lights)
        writeLight(writer, each, folder, zero, listOf("light"));
    if (variant.surroundings) writeSurroundings(writer, *variant.surroundings, header + ".surroundings");
}

std::string formatVariant(const SceneVariant& variant, const LocalOrigin& zero) {
    TomlWriter writer;
    writeVariant(writer, variant, {}, zero);
    return writer.text();
}

} // namespace rtcore

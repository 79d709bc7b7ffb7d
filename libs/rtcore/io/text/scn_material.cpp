#include "rtcore/io/text/scn_sections.h"
#include "rtcore/io/text/text_file.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr Limits kShininess{.minimum = 0, .maximum = 100'000};
constexpr Limits kIndexOfRefraction{.minimum = 1, .maximum = 5};

/// `colour` cut down to what `taken` leaves of 1.
Colour remainder(Colour colour, Colour taken) {
    return {std::min(colour.r, 1 - taken.r), std::min(colour.g, 1 - taken.g),
            std::min(colour.b, 1 - taken.b)};
}

template <typename T, typename Field>
void apply(const std::optional<T>& value, Field& field) {
    if (value) field = static_cast<Field>(*value);
}

} // namespace

void MaterialOverride::applyTo(Material& material) const {
    apply(diffuse, material.diffuse);
    apply(specular, material.specular);
    if (diffuse && !specular) material.specular = remainder(material.specular, *diffuse);
    if (specular && !diffuse) material.diffuse = remainder(material.diffuse, *specular);
    apply(shininess, material.shininess);
    apply(reflectivity, material.mirror);
    if (reflectivity) material.mirrorScale = 1;
    apply(fresnel, material.fresnel);
    apply(opacity, material.opacity);
    apply(transmission, material.transmission);
    apply(attenuationDistance, material.attenuationDistance);
    apply(indexOfRefraction, material.indexOfRefraction);
    apply(emission, material.emission);
}

MaterialOverride readMaterial(StrictTable& table, const std::filesystem::path& folder) {
    const auto name = table.text("name");
    MaterialOverride material;
    material.diffuse = table.colour("diffuse", kShare);
    material.specular = table.colour("specular", kShare);
    material.shininess = table.number("shininess", kShininess);
    material.reflectivity = table.colourOrNumber("reflectivity", kShare);
    material.fresnel = table.boolean("fresnel");
    material.opacity = table.number("opacity", kShare);
    material.transmission = table.colour("transmission", kShare);
    material.attenuationDistance = table.number("attenuationDistance", kNotNegative);
    material.indexOfRefraction = table.number("indexOfRefraction", kIndexOfRefraction);
    material.emission = table.colour("emission", kNotNegative);
    material.diffuseTexture = table.path("diffuseTexture", folder);
    table.finish();

    material.pattern = table.require("name", name);
    if (material.pattern.empty())
        table.fail("name", "name is empty; give a material's name or a pattern, \"*\"");
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
    writer.add("name", material.pattern);
    writer.add("diffuse", material.diffuse);
    writer.add("specular", material.specular);
    writer.add("shininess", material.shininess);
    writer.add("reflectivity", material.reflectivity);
    writer.add("fresnel", material.fresnel);
    writer.add("opacity", material.opacity);
    writer.add("transmission", material.transmission);
    writer.add("attenuationDistance", material.attenuationDistance);
    writer.add("indexOfRefraction", material.indexOfRefraction);
    writer.add("emission", material.emission);
    if (material.diffuseTexture)
        writer.add("diffuseTexture", pathToUtf8(pathSeenFrom(folder, *material.diffuseTexture)));
}

} // namespace rtcore

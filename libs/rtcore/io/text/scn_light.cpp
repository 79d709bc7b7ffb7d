#include "rtcore/io/text/cosine.h"
#include "rtcore/io/text/scn_sections.h"
#include "rtcore/io/text/text_file.h"
#include "rtcore/platform/sentence.h"

#include "rtcore/math/blackbody.h"
#include "rtcore/scene/model_photometry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rtcore {

namespace {

constexpr auto kKinds = [] {
    std::array<std::string_view, kLightKinds> names;
    for (std::size_t i = 0; i < kLightKinds; ++i) names[i] = kLightTraits[i].name;
    return names;
}();
constexpr Limits kTemperature{.minimum = kMinTemperature, .maximum = kMaxTemperature};
constexpr Limits kDiscAngle{.minimum = 0, .maximum = 180};
constexpr Limits kHalfAngle{.minimum = 0, .maximum = 180};

/// A direction that is of unit length but for rounding stays as it is, so that written directions read back
/// alike.
Vec3 unitDirection(Vec3 direction) {
    const float squared = dot(direction, direction);
    return std::fabs(squared - 1) < 1e-6F ? direction : normalize(direction);
}

/// Half-angles in degrees.
struct Cone {
    std::optional<double> inner, outer;
};

void setCone(const StrictTable& table, const Cone& cone, Light& light) {
    const double outer = table.require("outerAngle", cone.outer);
    light.cosInner = cosineOfDegrees(cone.inner.value_or(0));
    light.cosOuter = cosineOfDegrees(outer);
    if (light.cosOuter < light.cosInner) return;
    const char* const key = cone.inner ? "innerAngle" : "outerAngle";
    table.fail(key, say("innerAngle must be below outerAngle, by enough to tell them apart"));
}

/// A vector that is perpendicular but for rounding stays as it is, so that what was written reads back alike.
void setRight(const StrictTable& table, const std::optional<Vec3>& given, Light& light) {
    const Vec3 right = unitDirection(given.value_or(basisAround(light.direction).tangent));
    const float slant = dot(right, light.direction);
    light.right = std::fabs(slant) < 1e-6F ? right : normalize(right - light.direction * slant);
    if (right == Vec3{} || std::fabs(slant) > 0.999F)
        table.fail("right", say("right is zero or along direction; give where the width of the light points "
                                "to, or C = 0 of a luminaire"));
}

/// What belongs to a luminaire.
struct Luminaire {
    std::optional<std::filesystem::path> file;
    std::optional<int> ofModel;
    std::optional<float> lumens;
};

/// Without an intensity it is as bright as its file says.
void setLuminaire(const StrictTable& table, const Luminaire& luminaire, bool intensity,
                  LightDescription& to) {
    const bool some = luminaire.file || luminaire.ofModel;
    if (traitsOf(to.light).beam != Beam::Measured && (some || luminaire.lumens))
        table.fail(luminaire.file      ? "file"
                   : luminaire.ofModel ? "modelLuminaire"
                                       : "lumens",
                   say("only a light of the kind ies has a file and lumens"));
    if (luminaire.file && luminaire.ofModel)
        table.fail("modelLuminaire", say("it shines either by a file or as a luminaire of the model"));
    if (luminaire.file && luminaire.file->empty())
        table.fail("file", say("file is empty; name an IES or EULUMDAT file"));
    if (luminaire.lumens && !some)
        table.fail("lumens", say("lumens are those of a file; name it by file, or give an intensity"));
    to.file = luminaire.file.value_or("");
    to.modelLuminaire = luminaire.ofModel.value_or(0);
    to.lumens = luminaire.lumens;
    if (some && !intensity && !to.lumens) to.lumens = 0.0F;
}

/// Which of the model's luminaires it is, counted from 1; 0: none.
int luminaireOf(const Model& model, const Light& light) {
    if (light.photometry == 0) return 0;
    const std::vector<std::uint32_t> numbers = photometriesOf(model.lights);
    const auto at = std::ranges::find(numbers, light.photometry);
    return at != numbers.end() ? static_cast<int>(at - numbers.begin()) + 1 : 0;
}

} // namespace

Light tintedLight(const LightDescription& description) {
    Light light = description.light;
    if (description.temperature > 0) light.intensity *= blackbodyColour(description.temperature);
    return light;
}

LightDescription describeLight(const Scene& scene, std::size_t i) {
    const auto& [light, name, notes, ofSky] = scene.lights[i];
    LightDescription result{name, light, notes.id, notes.temperature, notes.file};
    if (notes.file.empty()) result.modelLuminaire = luminaireOf(scene.model, light);
    if (notes.temperature > 0) result.light.intensity = notes.untinted;
    result.light.nameOffset = 0;
    return result;
}

void putLight(Scene& scene, std::size_t i, const LightDescription& description) {
    scene.lights.resize(std::max(scene.lights.size(), i + 1));
    SceneLight& to = scene.lights[i];
    to.ofSky = to.ofSky && description.name == to.name && description.light.kind == to.light.kind;
    to.light = tintedLight(description);
    to.name = description.name;
    to.notes = {description.id, description.temperature,
                description.temperature > 0 ? description.light.intensity : Colour{}, description.file};
}

LightDescription readLight(StrictTable& table, const std::filesystem::path& folder) {
    const auto id = table.integer("id", 1, kMaxLightId);
    if (id) table.needVersion(2, "id");
    const auto temperature = table.number("temperature", kTemperature);
    if (temperature) table.needVersion(2, "temperature");
    const auto name = table.text("name");
    const auto kind = table.choice("kind", kKinds);
    const auto position = table.position("position");
    const auto direction = table.vector("direction");
    const auto intensity = table.colour("intensity", kNotNegative);
    const auto radius = table.number("radius", kNotNegative);
    // Through double, since a cosine near 0 has more digits than an angle in floats.
    const Cone cone{table.preciseNumber("innerAngle", kHalfAngle),
                    table.preciseNumber("outerAngle", kHalfAngle)};
    const auto angle = table.preciseNumber("angle", kDiscAngle);
    const auto right = table.vector("right");
    const auto width = table.number("width", kNotNegative), height = table.number("height", kNotNegative);
    const Luminaire luminaire{table.path("file", folder),
                              table.integer("modelLuminaire", 1, static_cast<int>(kMaxModelPhotometries)),
                              table.number("lumens", kNotNegative)};
    if (luminaire.file) table.needVersion(2, "file");
    if (luminaire.ofModel) table.needVersion(2, "modelLuminaire");
    const auto mirrored = table.boolean("mirrored");
    const auto on = table.boolean("on");
    table.finish();

    LightDescription result;
    Light& light = result.light;
    result.name = name.value_or("");
    result.id = id.value_or(0);
    result.temperature = temperature.value_or(0.0F);
    light.kind = static_cast<LightKind>(table.require("kind", kind));
    const LightTraits& traits = traitsOf(light);
    if (traits.position) light.position = table.require("position", position);
    if (traits.direction) light.direction = unitDirection(table.require("direction", direction));
    if (light.direction == Vec3{})
        table.fail("direction", say("direction is zero; give where the light shines to"));
    light.intensity = intensity.value_or(light.intensity);
    light.radius = radius.value_or(light.radius);
    if (traits.radius && !radius) table.require("radius", radius);
    if (traits.beam == Beam::Cone) setCone(table, cone, light);
    if (traits.turns()) setRight(table, right, light);
    if (traits.sides) {
        light.width = table.require("width", width);
        light.height = table.require("height", height);
    }
    setLuminaire(table, luminaire, intensity.has_value(), result);
    if (traits.disc) light.discSine = sineOfHalf(angle.value_or(0));
    if (isAreaLight(light.kind)) light.mirrored = mirrored.value_or(false) ? 1 : 0;
    light.on = on.value_or(true) ? 1 : 0;
    return result;
}

void writeLight(TomlWriter& writer, const LightDescription& description, const std::filesystem::path& folder,
                const LocalOrigin& zero, std::string_view header) {
    const Light& light = description.light;
    const LightTraits& traits = traitsOf(light);
    writer.section(header);
    if (description.id > 0) writer.add("id", description.id);
    if (!description.name.empty()) writer.add("name", description.name);
    writer.add("kind", traits.name);
    if (traits.position) writer.addPosition("position", light.position, zero);
    if (traits.direction) writer.add("direction", light.direction);
    if (!description.file.empty())
        writer.add("file", pathToUtf8(pathSeenFrom(folder, description.file)));
    else if (description.modelLuminaire > 0)
        writer.add("modelLuminaire", description.modelLuminaire);
    writer.add("intensity", light.intensity);
    if (description.lumens) writer.add("lumens", *description.lumens);
    if (description.temperature > 0) writer.add("temperature", description.temperature);
    if (traits.position) writer.add("radius", light.radius);
    if (traits.beam == Beam::Cone) {
        writer.add("innerAngle", degreesOfCosine(light.cosInner));
        writer.add("outerAngle", degreesOfCosine(light.cosOuter));
    }
    if (traits.turns()) writer.add("right", light.right);
    if (traits.sides) {
        writer.add("width", light.width);
        writer.add("height", light.height);
    }
    if (light.discSine > 0) writer.add("angle", degreesOfHalfSine(light.discSine));
    if (light.mirrored != 0) writer.add("mirrored", true);
    writer.add("on", light.on != 0);
}

} // namespace rtcore

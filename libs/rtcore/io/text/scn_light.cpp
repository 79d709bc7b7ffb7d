#include "rtcore/io/text/cosine.h"
#include "rtcore/io/text/scn_sections.h"

#include <array>
#include <cmath>

namespace rtcore {

namespace {

constexpr std::array<std::string_view, 3> kKinds{"point", "directional", "spot"};
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
    table.fail(key, "innerAngle must be below outerAngle, by enough to tell them apart");
}

} // namespace

LightDescription readLight(StrictTable& table) {
    const auto name = table.text("name");
    const auto kind = table.choice("kind", kKinds);
    const auto position = table.vector("position");
    const auto direction = table.vector("direction");
    const auto intensity = table.colour("intensity", kNotNegative);
    const auto radius = table.number("radius", kNotNegative);
    // Through double, since a cosine near 0 has more digits than an angle in floats.
    const Cone cone{table.preciseNumber("innerAngle", kHalfAngle),
                    table.preciseNumber("outerAngle", kHalfAngle)};
    const auto on = table.boolean("on");
    table.finish();

    LightDescription result;
    Light& light = result.light;
    result.name = name.value_or("");
    light.kind = static_cast<LightKind>(table.require("kind", kind));
    if (light.kind != LightKind::Directional) light.position = table.require("position", position);
    if (light.kind != LightKind::Point)
        light.direction = unitDirection(table.require("direction", direction));
    if (light.direction == Vec3{})
        table.fail("direction", "direction is zero; give where the light shines to");
    light.intensity = intensity.value_or(light.intensity);
    light.radius = radius.value_or(light.radius);
    if (light.kind == LightKind::Spot) setCone(table, cone, light);
    light.on = on.value_or(true) ? 1 : 0;
    return result;
}

void writeLight(TomlWriter& writer, const LightDescription& description) {
    const Light& light = description.light;
    writer.section("[[light]]");
    if (!description.name.empty()) writer.add("name", description.name);
    writer.add("kind", kKinds.at(static_cast<std::size_t>(light.kind)));
    if (light.kind != LightKind::Directional) writer.add("position", light.position);
    if (light.kind != LightKind::Point) writer.add("direction", light.direction);
    writer.add("intensity", light.intensity);
    if (light.kind != LightKind::Directional) writer.add("radius", light.radius);
    if (light.kind == LightKind::Spot) {
        writer.add("innerAngle", degreesOfCosine(light.cosInner));
        writer.add("outerAngle", degreesOfCosine(light.cosOuter));
    }
    writer.add("on", light.on != 0);
}

} // namespace rtcore

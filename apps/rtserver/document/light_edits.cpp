#include "rtserver/document/light_edits.h"

#include "rtcore/io/photometry/luminaire.h"
#include "rtcore/io/text/cosine.h"
#include "rtcore/math/blackbody.h"
#include "rtcore/math/constants.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/simd/portable_math.h"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace rtserver {

namespace {

using rtcore::Colour;
using rtcore::kPi;
using rtcore::Light;
using rtcore::LightDescription;
using rtcore::LightKind;
using rtcore::Vec3;

/// The sizes of a new light.
struct UsualSizes {
    float radius, ball, width, height;
};
constexpr UsualSizes kUsualMetres{0.06F, 0.01F, 0.6F, 0.3F};
constexpr UsualSizes kUsualDiagonals{0.01F, 0.002F, 0.1F,
                                     0.05F}; ///< of the model, where the unit is not known
constexpr double kUsualLumens = 800;
constexpr float kReach = 0.1F;            ///< diagonals: so far away it brings an irradiance of pi, then
constexpr float kInner = 25, kOuter = 35; ///< degrees
constexpr double kMaxDisc = 180;          ///< degrees

/// The word of its kind, in the place of a form.
rtcore::Sentence kindOf(const Light& light) { return traitsOf(light).name.data(); }

Vec3 unitOr(Vec3 direction, Vec3 otherwise) {
    const Vec3 unit = normalize(direction);
    return unit == Vec3{} ? otherwise : unit;
}

float squareDistance(Vec3 a, Vec3 b, const SceneExtent& extent) {
    const float nearest = 0.01F * extent.size;
    return std::fmax(dot(a - b, a - b), nearest * nearest);
}

/// Adds values that the kind needs and the light lacks; those without a use become as in a file without them.
void complete(Light& light, const SceneExtent& extent) {
    const Light usual;
    const rtcore::LightTraits& traits = traitsOf(light);
    const UsualSizes& sizes = extent.metresPerUnit ? kUsualMetres : kUsualDiagonals;
    const float unit = extent.metresPerUnit ? 1 / *extent.metresPerUnit : extent.size;
    if (!traits.position) {
        light.position = usual.position;
        light.radius = usual.radius;
    } else if (light.radius == 0) {
        light.radius = (traits.radius ? sizes.radius : sizes.ball) * unit;
    }
    if (!traits.direction) light.direction = usual.direction;
    const bool cone = traits.beam == rtcore::Beam::Cone;
    light.cosInner = cone ? rtcore::cosineOfDegrees(double{kInner}) : usual.cosInner;
    light.cosOuter = cone ? rtcore::cosineOfDegrees(double{kOuter}) : usual.cosOuter;
    light.right = traits.turns() ? basisAround(light.direction).tangent : usual.right;
    light.width = traits.sides ? sizes.width * unit : usual.width;
    light.height = traits.sides ? sizes.height * unit : usual.height;
    if (!traits.disc) light.discSine = usual.discSine;
    if (!isAreaLight(light.kind)) light.mirrored = usual.mirrored;
    if (traits.beam != rtcore::Beam::Measured) light.photometry = usual.photometry;
}

void scale(LightDescription& light, float factor) {
    const Colour scaled = light.light.intensity * factor;
    if (!isFinite(scaled)) throw rtcore::BadValue("so much light cannot be counted");
    light.light.intensity = scaled;
}

void setDisc(Light& light, double degrees, bool another) {
    if (another || degrees > kMaxDisc)
        throw rtcore::BadValue("a directional light takes one angle, in degrees, at most 180");
    light.discSine = rtcore::sineOfHalf(degrees);
}

} // namespace

LightDescription newLight(LightKind kind, const LightPlace& place, const SceneExtent& extent) {
    LightDescription result;
    Light& light = result.light;
    light.kind = kind;
    light.position = place.position;
    light.direction = unitOr(place.direction, extent.downwards);
    const float reach = kReach * extent.size;
    light.intensity = rtcore::kWhite * (traitsOf(kind).position ? kPi * reach * reach : kPi);
    complete(light, extent);
    if (extent.metresPerUnit && traitsOf(kind).position)
        setPower(result, static_cast<float>(rtcore::powerOfWatts(light, kUsualLumens / rtcore::kLumensPerWatt,
                                                                 double{*extent.metresPerUnit})));
    return result;
}

float powerOf(const LightDescription& light) { return rtcore::powerOf(tintedLight(light)); }

void setPower(LightDescription& light, float watts) {
    if (!(powerOf(light) > 0)) light.light.intensity = rtcore::kWhite;
    scale(light, watts / powerOf(light));
}

void setColour(LightDescription& light, Colour colour) {
    if (!(luminance(colour) > 0))
        throw rtcore::BadValue("black is no colour of a light; switch it off instead");
    const float watts = powerOf(light);
    LightDescription changed = light;
    changed.temperature = 0;
    changed.light.intensity = colour / luminance(colour);
    scale(changed, watts / powerFactor(light.light));
    light = changed;
}

void setTemperature(LightDescription& light, std::optional<float> kelvin) {
    const float watts = powerOf(light);
    if (!kelvin) {
        light.light.intensity = tintedLight(light).intensity;
        light.temperature = 0;
        return;
    }
    light.temperature = *kelvin;
    light.light.intensity = rtcore::kWhite * (watts / powerFactor(light.light));
}

void setKind(LightDescription& light, LightKind kind, const SceneExtent& extent) {
    if (kind == light.light.kind) return;
    LightDescription changed = light;
    Light& now = changed.light;
    now.kind = kind;
    const bool had = traitsOf(light.light).position, has = traitsOf(kind).position;
    if (has && !had) now.position = extent.centre - now.direction * (0.5F * extent.size);
    if (traitsOf(kind).direction && !traitsOf(light.light).direction)
        now.direction = has ? extent.downwards : unitOr(extent.centre - now.position, extent.downwards);
    const float square = squareDistance(now.position, extent.centre, extent);
    complete(now, extent);
    changed.file.clear();
    changed.modelLuminaire = 0;
    if (had == has) {
        scale(changed, powerFactor(light.light) / powerFactor(now));
    } else {
        scale(changed, has ? square : 1 / square);
    }
    light = changed;
}

void setSize(LightDescription& light, double size, std::optional<double> height) {
    const rtcore::LightTraits& traits = traitsOf(light.light);
    if (traits.disc) return setDisc(light.light, size, height.has_value());
    if (traits.sides != height.has_value())
        throw rtcore::BadValue(rtcore::say(traits.sides ? "a {0} light takes WIDTH and HEIGHT"
                                                        : "a {0} light takes a radius alone",
                                           kindOf(light.light)));
    if (traits.sides) {
        light.light.width = static_cast<float>(size);
        light.light.height = static_cast<float>(*height);
    } else {
        light.light.radius = static_cast<float>(size);
    }
}

void setMirrored(LightDescription& light, bool on) {
    if (on && !isAreaLight(light.light.kind))
        throw rtcore::Refusal(
            rtcore::say("a {0} light has no surface that mirrors show", kindOf(light.light)));
    light.light.mirrored = on ? 1 : 0;
}

void setAngles(LightDescription& light, float inner, float outer) {
    if (traitsOf(light.light).beam != rtcore::Beam::Cone)
        throw rtcore::Refusal(rtcore::say("a {0} light has no cone", kindOf(light.light)));
    const float cosInner = rtcore::cosineOfDegrees(static_cast<double>(inner)),
                cosOuter = rtcore::cosineOfDegrees(static_cast<double>(outer));
    if (!(cosOuter < cosInner))
        throw rtcore::BadValue("the inner angle must be below the outer one, by enough to tell them apart");
    light.light.cosInner = cosInner;
    light.light.cosOuter = cosOuter;
}

void setFile(LightDescription& light, const std::filesystem::path& file, const SceneExtent& extent,
             float metresPerUnit, std::vector<rtcore::Sentence>& warnings) {
    LightDescription changed = light;
    setKind(changed, LightKind::Ies, extent);
    changed.file = file;
    changed.modelLuminaire = 0;
    changed.lumens = 0.0F;
    readLuminaire(changed, metresPerUnit, warnings);
    light = changed;
}

void setTurn(LightDescription& light, double degrees) {
    if (!traitsOf(light.light).turns())
        throw rtcore::Refusal(rtcore::say("a {0} light is the same however it is turned about its direction",
                                          kindOf(light.light)));
    const float radians = static_cast<float>(degrees) * (kPi / 180);
    const Vec3 across = cross(light.light.right, light.light.direction);
    const Vec3 turned =
        normalize(light.light.right * rtcore::portableCos(radians) + across * rtcore::portableSin(radians));
    constexpr float kRounding = 2e-7F; // what a quarter of a turn leaves of a component
    const auto clean = [](float each) { return std::fabs(each) < kRounding ? 0 : each; };
    light.light.right = {clean(turned.x), clean(turned.y), clean(turned.z)};
}

void setPosition(LightDescription& light, Vec3 position) {
    if (!traitsOf(light.light).position)
        throw rtcore::Refusal("a directional light has no position; 'light aim' turns it");
    light.light.position = position;
}

void setDirection(LightDescription& light, Vec3 direction) {
    if (!traitsOf(light.light).direction)
        throw rtcore::Refusal(
            rtcore::say("a {0} light shines to all sides; 'light kind' changes that", kindOf(light.light)));
    const Vec3 unit = normalize(direction);
    if (unit == Vec3{}) throw rtcore::BadValue("the direction is zero; give where the light shines to");
    light.light.direction = unit;
    if (!traitsOf(light.light).turns()) return;
    const Vec3 right = normalize(light.light.right - unit * dot(light.light.right, unit));
    light.light.right = right == Vec3{} ? basisAround(unit).tangent : right;
}

} // namespace rtserver

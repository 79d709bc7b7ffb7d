#include "rtcore/io/bsp/model_check.h"

#include "rtcore/scene/material_numbers.h"
#include "rtcore/scene/material_textures.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

using Finding = std::optional<std::string>;

/// By how much a sum of albedos may exceed 1, and the length of a direction differ from it.
constexpr float kRounding = 1e-3F;

/// The aspect of an image one pixel wide and as high as images may be.
constexpr float kMinAspect = 1.0F / kMaxImageSide;

bool within(float value, float lo, float hi) { return value >= lo && value <= hi; } // false for NaN
bool within(Colour c, float lo, float hi) {
    return within(c.r, lo, hi) && within(c.g, lo, hi) && within(c.b, lo, hi);
}
bool within(Vec3 v, float lo, float hi) {
    return within(v.x, lo, hi) && within(v.y, lo, hi) && within(v.z, lo, hi);
}
bool isSwitch(std::uint32_t value) { return value <= 1; }
bool isPlace(Vec3 v) { return within(v, -kLargestNumber, kLargestNumber); }
bool isUnit(Vec3 v) { return isPlace(v) && std::fabs(length(v) - 1) < kRounding; }

std::string outside(const MaterialNumber& number) {
    if (number.maximum == kUnlimitedNumber) return fmt::format("{} is out of range", number.key);
    return fmt::format("{} is not in {}..{}", number.key, number.minimum, number.maximum);
}

const char* problemOf(const Material& m, const Model& model) {
    if (!within(m.diffuse, 0, 1)) return "diffuse is not in 0..1";
    if (!within(m.specular, 0, 1)) return "specular is not in 0..1";
    if (!hasRoughness(m) && !within(m.diffuse + m.specular, 0, 1 + kRounding))
        return "diffuse and specular together exceed 1";
    if (!within(m.shininess, 0, 100000)) return "shininess is not in 0..100000";
    if (!within(m.mirror, 0, 1)) return "mirror is not in 0..1";
    if (!within(m.mirrorScale, 0, 1)) return "mirrorScale is not in 0..1";
    if (!within(m.transmission, 0, 1)) return "transmission is not in 0..1";
    if (!within(m.emission, 0, kLargestNumber)) return "emission is out of range";
    if (!isSwitch(m.fresnel) || !isSwitch(m.alphaFromAlpha)) return "a switch is neither 0 nor 1";
    if (!within(m.alphaCutoff, 0, 1)) return "alphaCutoff is not in 0..1";
    if (!within(m.roughness, 0, 1) && m.roughness != kNoRoughness) return "roughness is not in 0..1";
    if (!within(m.metallic, 0, 1)) return "metallic is not in 0..1";
    if (!isSwitch(m.emissionLights) || !isSwitch(m.flipTextures)) return "a switch is neither 0 nor 1";
    if (!within(m.normalScale, -kLargestNumber, kLargestNumber)) return "normalScale is out of range";
    if (!isSwitch(m.vertexAlpha) || !isSwitch(m.tintsEmission) || !isSwitch(m.frontOnly))
        return "a switch is neither 0 nor 1";
    for (const auto texture : kMaterialTextures) {
        const std::uint32_t t = m.*texture;
        if (t != kNoTexture && t >= model.textures.size()) return "it names a texture that does not exist";
    }
    return m.nameOffset < model.strings.size() ? nullptr : "its name lies outside of the strings";
}

const char* problemOf(const Texture& t, const Model& model) {
    if (t.width == 0 || t.height == 0) return "it is empty";
    if (t.width > static_cast<std::uint32_t>(kMaxImageSide) ||
        t.height > static_cast<std::uint32_t>(kMaxImageSide)) {
        return "it is too wide or too high";
    }
    const std::uint64_t texels = std::uint64_t{t.width} * t.height;
    if (texels > kMaxImagePixels) return "it has too many texels";
    if (t.wrapU > TextureWrap::MirroredRepeat || t.wrapV > TextureWrap::MirroredRepeat)
        return "it wraps in no known way";
    if (t.filter > TextureFilter::Nearest) return "it is filtered in no known way";
    const std::uint64_t available = model.texels.size();
    if (t.firstTexel > available || texels > available - t.firstTexel) return "it ends outside of the texels";
    return nullptr;
}

const char* problemOf(const Light& l, const Model& model) {
    if (static_cast<std::size_t>(l.kind) >= kLightKinds) return "it is of no known kind";
    const LightTraits& traits = traitsOf(l);
    if (!isPlace(l.position)) return "position is out of range";
    if (!isPlace(l.direction)) return "direction is out of range";
    if (traits.direction && !isUnit(l.direction)) return "direction is not of unit length";
    if (!isPlace(l.right) || !within(l.width, 0, kLargestNumber) || !within(l.height, 0, kLargestNumber))
        return "its sides are out of range";
    if (traits.sides && !(isUnit(l.right) && std::fabs(dot(l.right, l.direction)) < 1e-3F))
        return "its width is not perpendicular to its direction";
    if (!within(l.intensity, 0, kLargestNumber)) return "intensity is out of range";
    if (!within(l.radius, 0, kLargestNumber)) return "radius is out of range";
    if (!within(l.cosInner, -1, 1) || !within(l.cosOuter, -1, 1)) return "a cosine is not in -1..1";
    if (traits.beam == Beam::Cone && !(l.cosOuter < l.cosInner))
        return "the outer angle is not wider than the inner";
    if (!within(l.discSine, 0, 1)) return "its disc is out of range";
    if (!isSwitch(l.on) || !isSwitch(l.mirrored)) return "a switch is neither 0 nor 1";
    return l.nameOffset < model.strings.size() ? nullptr : "its name lies outside of the strings";
}

const char* problemOf(const Camera& c, const Model& model) {
    if (!isPlace(c.eye)) return "eye is out of range";
    const Vec3 forward = normalize(c.forward), up = normalize(c.up); // zero for zero and for NaN
    if (forward == Vec3{} || up == Vec3{}) return "forward or up is zero or not a number";
    if (!(length(cross(forward, up)) > 1e-6F)) return "forward and up are parallel";
    if (!(c.horizontalFov > 0 && c.horizontalFov < 180)) return "the field of view is not in 0..180 degrees";
    if (c.kind > CameraKind::Orthographic) return "it is of no known kind";
    if (c.kind == CameraKind::Orthographic && !(c.orthographicWidth > 0)) return "its width is not above 0";
    if (!within(c.orthographicWidth, 0, kLargestNumber)) return "its width is out of range";
    if (c.aspect != 0 && !within(c.aspect, kMinAspect, 1 / kMinAspect)) return "its aspect is out of range";
    return c.nameOffset < model.strings.size() ? nullptr : "its name lies outside of the strings";
}

template <typename Record>
Finding checkEach(const char* section, std::span<const Record> records, const Model& model) {
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (const char* problem = problemOf(records[i], model)) {
            return fmt::format("{}: element {}: {}", section, i, problem);
        }
    }
    return {};
}

} // namespace

std::optional<std::string> checkMaterials(const Model& model) {
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
        for (const MaterialNumber& number : kMaterialNumbers) {
            const float maximum = std::min(number.maximum, kLargestNumber);
            if (within(model.materials[i].*number.field, number.minimum, maximum)) continue;
            return fmt::format("materials: element {}: {}", i, outside(number));
        }
    }
    return checkEach("materials", model.materials, model);
}
std::optional<std::string> checkTextures(const Model& model) {
    return checkEach("textures", model.textures, model);
}
std::optional<std::string> checkLights(const Model& model) {
    return checkEach("lights", model.lights, model);
}
std::optional<std::string> checkCameras(const Model& model) {
    return checkEach("cameras", model.cameras, model);
}

} // namespace rtcore

#include "rtcore/io/bsp/model_check.h"

#include "rtcore/scene/material_numbers.h"
#include "rtcore/scene/material_textures.h"
#include "rtcore/scene/model_photometry.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

using Finding = std::optional<Sentence>;

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

Sentence outOfRange(std::string_view key) { return say("{0} is out of range", key); }
Sentence outOf(std::string_view key, float lo, float hi) {
    return say("{0} is not in {1}..{2}", key, fmt::format("{}", lo), fmt::format("{}", hi));
}
Sentence outOf(const MaterialNumber& number) {
    if (number.maximum == kUnlimitedNumber) return outOfRange(number.key);
    return outOf(number.key, number.minimum, number.maximum);
}

Finding problemOf(const Material& m, const Model& model) {
    if (!within(m.diffuse, 0, 1)) return outOf("diffuse", 0, 1);
    if (!within(m.specular, 0, 1)) return outOf("specular", 0, 1);
    if (!hasRoughness(m) && !within(m.diffuse + m.specular, 0, 1 + kRounding))
        return form("diffuse and specular together exceed 1");
    if (!within(m.shininess, 0, 100000)) return outOf("shininess", 0, 100000);
    if (!within(m.mirror, 0, 1)) return outOf("mirror", 0, 1);
    if (!within(m.mirrorScale, 0, 1)) return outOf("mirrorScale", 0, 1);
    if (!within(m.transmission, 0, 1)) return outOf("transmission", 0, 1);
    if (!within(m.emission, 0, kLargestNumber)) return outOfRange("emission");
    if (!isSwitch(m.fresnel) || !isSwitch(m.alphaFromAlpha)) return form("a switch is neither 0 nor 1");
    if (!within(m.alphaCutoff, 0, 1)) return outOf("alphaCutoff", 0, 1);
    if (!within(m.roughness, 0, 1) && m.roughness != kNoRoughness) return outOf("roughness", 0, 1);
    if (!within(m.metallic, 0, 1)) return outOf("metallic", 0, 1);
    if (!isSwitch(m.emissionLights) || !isSwitch(m.flipTextures)) return form("a switch is neither 0 nor 1");
    if (!within(m.normalScale, -kLargestNumber, kLargestNumber)) return outOfRange("normalScale");
    if (!isSwitch(m.vertexAlpha) || !isSwitch(m.tintsEmission) || !isSwitch(m.frontOnly))
        return form("a switch is neither 0 nor 1");
    for (const auto texture : kMaterialTextures) {
        const std::uint32_t t = m.*texture;
        if (t != kNoTexture && t >= model.textures.size())
            return form("it names a texture that does not exist");
    }
    if (m.nameOffset < model.strings.size()) return {};
    return form("its name lies outside of the strings");
}

Finding problemOf(const Texture& t, const Model& model) {
    if (t.width == 0 || t.height == 0) return form("it is empty");
    if (t.width > static_cast<std::uint32_t>(kMaxImageSide) ||
        t.height > static_cast<std::uint32_t>(kMaxImageSide)) {
        return form("it is too wide or too high");
    }
    const std::uint64_t texels = std::uint64_t{t.width} * t.height;
    if (texels > kMaxImagePixels) return form("it has too many texels");
    if (t.wrapU > TextureWrap::MirroredRepeat || t.wrapV > TextureWrap::MirroredRepeat)
        return form("it wraps in no known way");
    if (t.filter > TextureFilter::Nearest) return form("it is filtered in no known way");
    if (t.storage > TextureStorage::Blocks) return form("it is stored in no known way");
    if (t.texcoordSet > model.mesh.furtherSets())
        return form("it lies by texture coordinates that do not exist");
    const std::uint64_t available = t.inBlocks() ? model.blocks.size() : model.texels.size();
    const std::uint64_t needed =
        t.inBlocks() ? std::uint64_t{blocksOf(t.width)} * blocksOf(t.height) : texels;
    if (t.firstTexel > available || needed > available - t.firstTexel)
        return form("it ends outside of the texels");
    return {};
}

Finding problemOf(const Light& l, const Model& model) {
    if (static_cast<std::size_t>(l.kind) >= kLightKinds) return form("it is of no known kind");
    const LightTraits& traits = traitsOf(l);
    if (!isPlace(l.position)) return outOfRange("position");
    if (!isPlace(l.direction)) return outOfRange("direction");
    if (traits.direction && !isUnit(l.direction)) return form("direction is not of unit length");
    if (!isPlace(l.right) || !within(l.width, 0, kLargestNumber) || !within(l.height, 0, kLargestNumber))
        return form("its sides are out of range");
    if (traits.turns() && !(isUnit(l.right) && std::fabs(dot(l.right, l.direction)) < 1e-3F))
        return form("its width is not perpendicular to its direction");
    if (!within(l.intensity, 0, kLargestNumber)) return outOfRange("intensity");
    if (!within(l.radius, 0, kLargestNumber)) return outOfRange("radius");
    if (!within(l.cosInner, -1, 1) || !within(l.cosOuter, -1, 1)) return form("a cosine is not in -1..1");
    if (traits.beam == Beam::Cone && !(l.cosOuter < l.cosInner))
        return form("the outer angle is not wider than the inner");
    if (!within(l.discSine, 0, 1)) return form("its disc is out of range");
    if (!isSwitch(l.on) || !isSwitch(l.mirrored)) return form("a switch is neither 0 nor 1");
    if (l.photometry != 0 && (traits.beam != Beam::Measured || keptWeb(l.photometry) == nullptr))
        return form("it names a photometric file, which is not in it");
    if (l.nameOffset < model.strings.size()) return {};
    return form("its name lies outside of the strings");
}

Finding problemOf(const Camera& c, const Model& model) {
    if (!isPlace(c.eye)) return outOfRange("eye");
    const Vec3 forward = normalize(c.forward), up = normalize(c.up); // zero for zero and for NaN
    if (forward == Vec3{} || up == Vec3{}) return form("forward or up is zero or not a number");
    if (!(length(cross(forward, up)) > 1e-6F)) return form("forward and up are parallel");
    if (!(c.horizontalFov > 0 && c.horizontalFov < 180))
        return form("the field of view is not in 0..180 degrees");
    if (c.kind > CameraKind::Orthographic) return form("it is of no known kind");
    if (c.kind == CameraKind::Orthographic && !(c.orthographicWidth > 0))
        return form("its width is not above 0");
    if (!within(c.orthographicWidth, 0, kLargestNumber)) return form("its width is out of range");
    if (c.aspect != 0 && !within(c.aspect, kMinAspect, 1 / kMinAspect))
        return form("its aspect is out of range");
    if (c.nameOffset < model.strings.size()) return {};
    return form("its name lies outside of the strings");
}

Sentence inElement(std::string_view section, std::size_t index, const Sentence& problem) {
    return say("{0}: element {1}: {2}", section, index, problem);
}

template <typename Record>
Finding checkEach(std::string_view section, std::span<const Record> records, const Model& model) {
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (const Finding problem = problemOf(records[i], model)) return inElement(section, i, *problem);
    }
    return {};
}

} // namespace

std::optional<Sentence> checkMaterials(const Model& model) {
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
        for (const MaterialNumber& number : kMaterialNumbers) {
            const float maximum = std::min(number.maximum, kLargestNumber);
            const float value = model.materials[i].*number.field;
            const bool whole = !number.whole || value == std::floor(value);
            if (within(value, number.minimum, maximum) && whole) continue;
            return inElement("materials", i, outOf(number));
        }
    }
    return checkEach("materials", model.materials, model);
}
std::optional<Sentence> checkTextures(const Model& model) {
    return checkEach("textures", model.textures, model);
}
std::optional<Sentence> checkLights(const Model& model) {
    if (const Finding problem = checkEach("lights", model.lights, model)) return problem;
    const std::vector<std::uint32_t> luminaires = photometriesOf(model.lights);
    std::size_t numbers = 0;
    for (const std::uint32_t each : luminaires) numbers += numbersOf(*keptWeb(each)).size();
    if (luminaires.size() <= kMaxModelPhotometries && numbers <= kMaxModelWebNumbers) return {};
    return form("lights: they name more photometric files than a model may have");
}
std::optional<Sentence> checkCameras(const Model& model) {
    return checkEach("cameras", model.cameras, model);
}

} // namespace rtcore

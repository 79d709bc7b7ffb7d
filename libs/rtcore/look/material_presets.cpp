#include "rtcore/look/material_presets.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/nearest_name.h"

#include <algorithm>
#include <array>
#include <vector>

namespace rtcore {

namespace {

// Reflectances at normal incidence, linear. Measured: Adobe, "Metal material references" (Standard Material);
// steel, as iron, and brass: Google, "Material properties" (Filament), decoded from sRGB.
constexpr Colour kAluminium{0.9157F, 0.9226F, 0.9236F}, kSteel{0.5271F, 0.5089F, 0.491F},
    kChromium{0.5496F, 0.5561F, 0.5531F}, kGold{1, 0.7099F, 0.3148F}, kCopper{1, 0.6504F, 0.5274F},
    kSilver{0.9868F, 0.983F, 0.9667F}, kBrass{0.9047F, 0.7758F, 0.4179F};
/// Tables have none: the mean of copper and brass, between which its colour lies.
constexpr Colour kBronze{0.9524F, 0.7131F, 0.4727F};

constexpr float kWindowIndex = 1.52F; ///< of soda-lime glass

/// What is no metal and not transparent. All words are said, so that nothing of another material stays.
MaterialOverride solid(Colour colour, float roughness, float coat = 0, float coatRoughness = 0) {
    MaterialOverride look;
    look.diffuse = colour;
    look.roughness = roughness;
    look.metallic = 0.0F;
    look.coat = coat;
    look.coatRoughness = coatRoughness;
    look.opacity = 1.0F;
    look.transmission = kWhite;
    look.attenuationDistance = 0.0F;
    look.indexOfRefraction = 1.5F;
    look.emission = Colour{};
    look.textures = false;
    return look;
}

MaterialOverride metalOfColour(Colour reflectance, float roughness) {
    MaterialOverride look = solid(reflectance, roughness);
    look.metallic = 1.0F;
    return look;
}

MaterialOverride glassOfTint(Colour tint, float roughness) {
    MaterialOverride look = solid({}, roughness);
    look.opacity = 0.0F;
    look.transmission = tint;
    look.indexOfRefraction = kWindowIndex;
    return look;
}

std::array<MaterialPreset, kMaterialPresets> makePresets() {
    return {{
        {form("white-paint"), solid({0.82F, 0.82F, 0.8F}, 0.6F)},
        {form("grey-paint"), solid({0.22F, 0.22F, 0.22F}, 0.6F)},
        {form("black-paint"), solid({0.03F, 0.03F, 0.03F}, 0.6F)},
        {form("aluminium"), metalOfColour(kAluminium, 0.35F)},
        {form("steel"), metalOfColour(kSteel, 0.3F)},
        {form("chrome"), metalOfColour(kChromium, 0.05F)},
        {form("gold"), metalOfColour(kGold, 0.2F)},
        {form("copper"), metalOfColour(kCopper, 0.25F)},
        {form("brass"), metalOfColour(kBrass, 0.25F)},
        {form("bronze"), metalOfColour(kBronze, 0.35F)},
        {form("clear-glass"), glassOfTint({0.97F, 0.98F, 0.97F}, 0)},
        {form("frosted-glass"), glassOfTint({0.97F, 0.98F, 0.97F}, 0.4F)},
        {form("tinted-glass"), glassOfTint({0.35F, 0.45F, 0.4F}, 0)},
        {form("mirror"), metalOfColour(kSilver, 0)},
        {form("oak"), solid({0.42F, 0.25F, 0.12F}, 0.55F, 0.5F, 0.3F)},
        {form("walnut"), solid({0.13F, 0.068F, 0.037F}, 0.5F, 0.5F, 0.3F)},
        {form("linen"), solid({0.62F, 0.55F, 0.44F}, 0.95F)},
        {form("leather"), solid({0.12F, 0.05F, 0.025F}, 0.5F)},
        {form("marble"), solid({0.76F, 0.74F, 0.7F}, 0.4F, 1, 0.08F)},
        {form("granite"), solid({0.2F, 0.19F, 0.185F}, 0.5F, 1, 0.12F)},
        {form("concrete"), solid({0.42F, 0.41F, 0.385F}, 0.9F)},
        {form("plastic"), solid({0.45F, 0.45F, 0.44F}, 0.3F)},
        {form("rubber"), solid({0.035F, 0.035F, 0.035F}, 0.85F)},
        {form("ceramic"), solid({0.8F, 0.79F, 0.76F}, 0.5F, 1, 0.04F)},
    }};
}

} // namespace

std::span<const MaterialPreset> materialPresets() {
    static const std::array<MaterialPreset, kMaterialPresets> all = makePresets();
    return all;
}

const MaterialPreset& materialPresetNamed(std::string_view name) {
    const std::span<const MaterialPreset> all = materialPresets();
    const auto found = std::ranges::find_if(all, [&](const auto& each) { return each.name == name; });
    if (found != all.end()) return *found;
    std::vector<std::string_view> names;
    for (const MaterialPreset& each : all) names.emplace_back(each.name);
    throw BadValue(unknownNameMessage(form("preset"), name, names));
}

} // namespace rtcore

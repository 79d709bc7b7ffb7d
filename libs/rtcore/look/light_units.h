/// The units of a scene's light: the sky's own, that of lights, and none. (docs/shading.md, "Measured light")
#pragma once

#include "rtcore/platform/sentence.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

#include <optional>
#include <vector>

namespace rtcore {

/// A scene lit by a part of its light, and the luminance that a radiance of 1 stands for in it, cd/m^2.
struct LightOfUnit {
    Scene scene;
    double luminanceOfOne = kLumensPerWatt;
};

/// The computed sky and its sun, in units of kLuminanceOfOne; and all the rest, by 683 lumens for a watt.
/// Together they are all of the light. Nothing for a part without light.
struct LightByUnit {
    std::optional<LightOfUnit> sky, rest;
};
LightByUnit lightByUnit(const Scene& scene);

/// Whether all that the scene has of light is without an absolute unit, and what that is, for people.
struct UnitlessLight {
    bool all = false;
    std::vector<Sentence> what; ///< empty: all light has a unit
};
/// Nothing records in which unit a light was given, so it is told by what there is. Absolute are the computed
/// sky with its sun as it makes it, at strength 1; luminaires of photometric files; other lights of the
/// scene, which are in watts. Not so: ambient light, a background, environments of files, a studio, fog that
/// gives off light, emission that materials have from the model's file, lights as the model's file brought
/// them, and those of looks, by their names.
UnitlessLight unitlessLight(const Scene& scene, const RenderSettings& settings);

} // namespace rtcore

/// The units of a scene's light: the sky's own, that of lights, and none. (docs/shading.md, "Measured light")
#pragma once

#include "rtcore/platform/sentence.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/scene/luminance_unit.h"
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

/// For an image of both: the scene with the rest dimmed, so that a radiance of 1 is kLuminanceOfOne of all
/// its light but that of environments of files, which have no unit. Nothing where one of the two is missing.
std::optional<Scene> inUnitOfSky(const Scene& scene);

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

/// That of images of the scene, or of inUnitOfSky() it where there is one.
LuminanceUnit unitOfImages(const Scene& scene, const RenderSettings& settings);
/// What is to be told where false colours do not show true numbers, or not of all light; else empty.
Sentence unitWarning(const UnitlessLight& light);

} // namespace rtcore

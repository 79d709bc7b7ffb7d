/// Edits of one light by commands. Lights are as .scn files describe them.
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/platform/sentence.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace rtserver {

/// Where a light is put or looks to.
struct LightPlace {
    rtcore::Vec3 position;
    rtcore::Vec3 direction{0, -1, 0}; ///< where a light that has a direction shines to, unit length
};

/// The properties of a scene by which lights are sized and their strengths chosen.
struct SceneExtent {
    rtcore::Vec3 centre; ///< of the model
    float size = 1;      ///< its diagonal, scene units, above 0
    rtcore::Vec3 downwards{0, -1, 0};
    std::optional<float> metresPerUnit = {}; ///< nothing: sizes and strengths follow the model's
};

/// A light as it is added: white, of 800 lm, and as large as electric lights are; a directional one throws pi
/// W/m^2.
rtcore::LightDescription newLight(rtcore::LightKind kind, const LightPlace& place, const SceneExtent& extent);

/// All that it gives off, W, each weighted as its luminance is; of a directional light, which has no end, the
/// irradiance on a surface that faces it, W/m^2. A spot's is that of its cone, with half of its rim.
float powerOf(const rtcore::LightDescription& light);

// They throw std::invalid_argument for a wrong value and std::runtime_error for what lights of that kind
// lack, with a text for users, and leave the light as it was.

/// Keeps the colour, or makes it white where it was black. `watts` is above 0, as powerOf() counts.
void setPower(rtcore::LightDescription& light, float watts);
/// Keeps the power, and drops the temperature. `colour` is not black.
void setColour(rtcore::LightDescription& light, rtcore::Colour colour);
/// Takes the colour of a black body and keeps the power. Nothing: the colour that the light has by its
/// temperature becomes its own.
void setTemperature(rtcore::LightDescription& light, std::optional<float> kelvin);
/// Keeps the power; between directional lights and others, the irradiance in the middle of the model. Values
/// that the new kind needs and the old one lacked are those of a new light.
void setKind(rtcore::LightDescription& light, rtcore::LightKind kind, const SceneExtent& extent);
/// A rectangle takes two numbers, a directional light the angle under which its disc is seen, degrees; the
/// others a radius. Scene units, not negative.
void setSize(rtcore::LightDescription& light, double size, std::optional<double> height);
/// Half-angles of a spot, degrees.
void setAngles(rtcore::LightDescription& light, float inner, float outer);
/// Whether mirrors show it: of spheres and rectangles.
void setMirrored(rtcore::LightDescription& light, bool on);
/// Makes it a luminaire of that photometric file, as bright as the file says in a scene of that unit, of the
/// colour that it has. Appends what of the file does not count. Throws as readLuminaire() as well.
void setFile(rtcore::LightDescription& light, const std::filesystem::path& file, const SceneExtent& extent,
             float metresPerUnit, std::vector<rtcore::Sentence>& warnings);
/// Turns a rectangle or a luminaire about its direction, counter-clockwise as one looks along it.
void setTurn(rtcore::LightDescription& light, double degrees);
void setPosition(rtcore::LightDescription& light, rtcore::Vec3 position);
/// `direction` need not be of unit length. A rectangle turns with as little roll as may be.
void setDirection(rtcore::LightDescription& light, rtcore::Vec3 direction);

} // namespace rtserver

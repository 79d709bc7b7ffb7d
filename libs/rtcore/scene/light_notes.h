/// What a scene knows of its lights beside what shines: their ids, and how their colour came about.
#pragma once

#include "rtcore/math/colour.h"

#include <cstddef>
#include <optional>

namespace rtcore {

struct Scene;

inline constexpr int kMostLightId = 1'000'000'000;

struct LightNotes {
    int id = 0;            ///< 1..kMostLightId, unique in the scene: it stays while others come and go
    float temperature = 0; ///< kelvin, that of the light's colour; 0: it has a colour of its own
    Colour untinted = {};  ///< with a temperature: Light::intensity before that, which is the product of both
    bool ofSky = false;    ///< it is the light of the scene's sky, which sets it (sky/scene_sky.h)
    friend bool operator==(const LightNotes&, const LightNotes&) = default;
};

/// Gives every light a name, maybe "", and an id: those that have none, in their order, the number of their
/// place, counted from 1, or the next one that is free.
void numberLights(Scene& scene);

/// Of a scene whose lights are numbered: which one has that id.
std::optional<std::size_t> lightWithId(const Scene& scene, int id);
/// Takes one away, with its name and what is noted of it.
void eraseLight(Scene& scene, std::size_t light);
/// For one more light: above all that there are and were, so that none follows in the place of one that was
/// removed.
int nextLightId(const Scene& scene);

} // namespace rtcore

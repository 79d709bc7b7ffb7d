/// The lights of a scene: what shines, and what the scene knows of it beside that.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/scene/light.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rtcore {

struct Scene;

inline constexpr int kMaxLightId = 1'000'000'000;

/// Which light it is, and how its colour came about.
struct LightNotes {
    int id = 0;            ///< 1..kMaxLightId, unique in the scene: it stays while others come and go
    float temperature = 0; ///< kelvin, that of the light's colour; 0: it has a colour of its own
    Colour untinted = {};  ///< with a temperature: Light::intensity before that, which is the product of both
    std::filesystem::path file = {}; ///< of a luminaire: that of its distribution; "": none
    friend bool operator==(const LightNotes&, const LightNotes&) = default;
};

struct SceneLight {
    Light light;
    std::string name;   ///< may be ""
    LightNotes notes;   ///< its id is 0 until numberLights() was called
    bool ofSky = false; ///< it is the light of the scene's sky, which sets it (sky/scene_sky.h); one at most

    SceneLight() = default;
    SceneLight(const Light& shining, std::string called = {}) : light(shining), name(std::move(called)) {}
    friend bool operator==(const SceneLight&, const SceneLight&) = default;
};

/// The lights alone, in their order.
std::vector<Light> lightsOf(std::span<const SceneLight> lights);
/// Whether these lists shine alike: names, ids and the like may differ.
bool shineAlike(std::span<const SceneLight> a, std::span<const SceneLight> b);

/// Gives an id to every light that has none: in their order, the number of their place, counted from 1, or
/// the next one that is free.
void numberLights(Scene& scene);

/// The index of the light with that id, in a scene whose lights are numbered.
std::optional<std::size_t> lightWithId(const Scene& scene, int id);
void eraseLight(Scene& scene, std::size_t light);
/// The id for one more light: above all that there are and were, so that none follows in the place of one
/// that was removed.
int nextLightId(const Scene& scene);

} // namespace rtcore

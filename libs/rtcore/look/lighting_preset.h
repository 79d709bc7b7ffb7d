/// Lighting for models that bring none. (docs/shading.md)
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/look/lighting_preset_name.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/settings_table.h"
#include "rtcore/survey/survey.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// Nothing where no look has that name.
std::optional<LightingPreset> lightingPresetNamed(std::string_view name);

/// Name of the point light of LightingPreset::Headlight.
inline constexpr const char* kHeadlightName = "default";

/// Whether lights of presets have that name: the headlight, those under ceilings and around objects.
bool isPresetLightName(std::string_view name);

/// Background and ambient light of a model without a scene file.
inline constexpr Colour kPlainBackground{0.03F, 0.036F, 0.048F}, kPlainAmbient{0.15F, 0.15F, 0.15F};

struct PresetLighting {
    std::optional<Sky> sky;
    std::vector<SceneLight> lights; ///< without the sun, and without ids
    Colour background = kPlainBackground, ambient = kPlainAmbient;
};

/// Seen by `camera`. `sky`: the one to be shown; otherwise one whose sun shows the model well (sunOfView()).
/// The same for the same input. Some 0.05 s.
PresetLighting presetLighting(LightingPreset preset, const KdTree& tree, const Mesh& mesh,
                              const Survey& survey, const Camera& camera, const std::optional<Sky>& sky = {});

/// In place of all lights of the scene, of its sky and of the environment that is shown; environments of
/// files stay there to be chosen.
void lightBy(Scene& scene, const PresetLighting& preset);

/// Settings for it, in the walk and in stills.
std::vector<SettingAssignment> settingsOf(LightingPreset preset, const Survey& survey);
/// Those of them that suit other light of its kind, too: how it is exposed, what is made of it, and whether
/// surfaces light each other.
std::vector<SettingAssignment> settingsOf(LightingPreset preset);

/// Whether the scene is lit by that: nothing was edited but what is switched on.
bool isLitBy(const Scene& scene, const PresetLighting& preset);

/// The light of LightingPreset::Headlight, behind the lights that the scene has.
void addHeadlight(Scene& scene, const Box3& bounds, const Camera& camera);

/// Whether LightingPreset::Sky has a ground below the model: what one stands neither in, as in a room, nor
/// before, as before a stage, and what has no ground of its own, unless that takes too much memory.
bool wantsGround(const Mesh& mesh, const Survey& survey);

/// The radiance of an even background that lights what an object's own lights leave in the dark, where that
/// is much of what the camera sees: weak beside what is well lit. None where they light it well.
std::optional<Colour> fillLight(const Scene& scene, const KdTree& tree, const Camera& camera);

/// Those of roomLights(), behind the lights that the scene has.
void addRoomLights(Scene& scene, const KdTree& tree, const Survey& survey);

} // namespace rtcore

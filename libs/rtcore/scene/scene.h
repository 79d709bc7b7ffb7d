/// A scene ready to be rendered, apart from its kd-tree. Immutable while rays are traced: an edit copies it,
/// changes the copy and puts that in its place, which revisions.h counts. Copies are cheap: they share the
/// model's arrays, environments and closed surfaces; only materials and lights are copied.
#pragma once

#include "rtcore/scene/camera.h"
#include "rtcore/scene/closed_surfaces.h"
#include "rtcore/scene/environment.h"
#include "rtcore/scene/environment_source.h"
#include "rtcore/scene/glass_solids.h"
#include "rtcore/scene/local_origin.h"
#include "rtcore/scene/material_override.h"
#include "rtcore/scene/model.h"
#include "rtcore/scene/part_list.h"
#include "rtcore/scene/scene_light.h"
#include "rtcore/scene/section_planes.h"
#include "rtcore/scene/sky.h"
#include "rtcore/scene/sky_ground.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rtcore {

enum class FogKind { None, Homogeneous, Exponential };

/// Participating medium between the surfaces. It takes light away by absorbing and scattering it, and adds
/// what it scatters of the lights and of the surroundings, the same to all sides, and what it emits.
struct Fog {
    FogKind kind = FogKind::None;
    float density = 0;               ///< extinction per scene unit (at `groundHeight`); 0 = no fog
    float scaleHeight = 1;           ///< exponential: height over which the density falls to 1/e
    float groundHeight = 0;          ///< exponential: height along the up axis where `density` holds
    Colour colour{0.5F, 0.5F, 0.5F}; ///< radiance that a ray tends to inside the fog, without lights
    Colour albedo{1, 1, 1};          ///< 0..1: fraction of the extinction that scatters light
    float surroundings = 0;          ///< factor on what it scatters of the environment, beside `colour`
    Colour emission;                 ///< radiance emitted per scene unit (at `groundHeight`)
};

/// How big the player is and how it moves in walk-through mode; metres and seconds.
struct WalkParameters {
    float height = 1.8F;
    float speed = 1.6F; ///< twice as fast with Shift
    float jumpHeight = 0.6F;
    float stepHeight = 0.4F;
    float gravity = 9.81F;
};

/// SceneLook::activeEnvironment where none is active.
inline constexpr int kNoEnvironment = -1;

/// The surroundings of the surfaces and the rules for walking, as a scene file states them beside the model.
struct SceneLook {
    Colour background; ///< radiance where there is no environment
    Colour ambient;    ///< radiance that reaches every surface from all directions, unshadowed
    Fog fog;
    WalkParameters walk;
    SectionPlanes sections;
    Vec3 up{0, 1, 0}; ///< one of the six axes
    float metresPerUnit = 1;
    LocalOrigin origin; ///< the scene's zero, in the coordinates of the model's file
    std::optional<Sky> sky;
    /// Index into the scene's environments, of which the sky is the last; ignored when there are none.
    int activeEnvironment = 0;
};

struct Scene : SceneLook {
    Model model;
    /// The model's with the scene's overrides; indexed by ShadingTriangle::material.
    std::vector<Material> materials;
    std::vector<MaterialOverride> materialEdits; ///< made since it was loaded, one for a material, by number
    std::vector<SceneLight> lights;
    int removedLightId = 0; ///< the highest of those that were removed: nextLightId() is above it
    std::vector<std::shared_ptr<const Environment>> environments; ///< of files, then that of `sky`
    std::vector<EnvironmentFile> environmentFiles; ///< what those of files were loaded from, where known
    std::shared_ptr<const SkyGround> ground;       ///< below the model, once a sky was to show one
    HiddenParts hiddenParts;                       ///< of the model; visibleTree() is of what is left
    PartSet uncutParts;                            ///< of the model: sections leave them whole
    ClosedSurfaces closed;                         ///< findClosedSurfaces() of the mesh with these materials
    std::shared_ptr<const GlassSolids> solids;     ///< findGlassSolids() of the same

    /// The mesh of all that may be seen: the model's, and behind its triangles those of the ground.
    const Mesh& mesh() const { return ground ? ground->mesh : model.mesh; }
    /// The material of a ShadingTriangle of mesh().
    const Material& material(std::uint32_t number) const {
        return number < materials.size() ? materials[number] : ground->material;
    }
    /// Whether the triangle's surface bounds a solid.
    bool isClosed(std::uint32_t triangle) const {
        return closed != nullptr && triangle < closed->size() && (*closed)[triangle] != 0;
    }
    /// How many of the environments are of files; the sky's stands behind them.
    std::size_t fileEnvironments() const { return environments.size() - (sky ? 1 : 0); }
    /// Whether there is one, and the sky around it that it belongs to.
    bool showsGround() const {
        const bool underSky = sky && static_cast<std::size_t>(activeEnvironment) + 1 == environments.size();
        return ground != nullptr && underSky && sky->ground;
    }
    const Environment* environment() const {
        const auto i = static_cast<std::size_t>(activeEnvironment);
        return activeEnvironment >= 0 && i < environments.size() ? environments[i].get() : nullptr;
    }
};

} // namespace rtcore

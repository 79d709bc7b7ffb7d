/// .scn: a scene in text - which model, and what else it takes to make images of it (docs/formats.md).
#pragma once

#include "rtcore/io/text/pattern.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/light.h"
#include "rtcore/scene/material.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/settings_table.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// One [[light]].
struct LightDescription {
    std::string name; ///< may be ""
    Light light;      ///< direction of unit length, cosOuter < cosInner; nameOffset is 0
    friend bool operator==(const LightDescription&, const LightDescription&) = default;
};

/// One [[material]]: what it changes in every material whose name fits.
struct MaterialOverride {
    std::string pattern; ///< matchesPattern(); not ""
    std::optional<Colour> diffuse, specular, transmission, emission;
    std::optional<Colour> reflectivity; ///< the material's `mirror`, with a mirrorScale of 1
    std::optional<float> shininess, opacity, attenuationDistance, indexOfRefraction;
    std::optional<bool> fresnel;
    std::optional<std::filesystem::path> diffuseTexture; ///< loaded by the scene loader

    /// All but the texture. Where the sum of diffuse and specular would exceed 1, the one that is not
    /// overridden gives way.
    void applyTo(Material& material) const;
    friend bool operator==(const MaterialOverride&, const MaterialOverride&) = default;
};

enum class EnvironmentKind {
    Equirectangular, ///< one file
    Cross,           ///< one file, six faces unfolded
    Strip,           ///< one file, six faces in a row
    Faces,           ///< six files: +X -X +Y -Y +Z -Z
};

/// One [[environment]].
struct EnvironmentFile {
    EnvironmentKind kind = EnvironmentKind::Equirectangular;
    std::vector<std::filesystem::path> files; ///< six for Faces, else one
    std::string name;                         ///< may be ""
    float intensity = 1;                      ///< factor, >= 0
    friend bool operator==(const EnvironmentFile&, const EnvironmentFile&) = default;
};

/// All paths are absolute or relative to the current folder. Lengths are in scene units.
struct SceneFile : SceneLook {
    std::filesystem::path model; ///< a .bsp or a model
    std::optional<std::filesystem::path> settings, output;
    bool modelLights = true;      ///< use the model's own lights beside `lights`
    float creaseAngle = 40;       ///< degrees, for models without normals
    bool flipTextures = false;    ///< of a model that is imported: turn its textures upside down
    std::optional<Camera> camera; ///< at most one of these two; nameOffset is 0
    std::optional<std::filesystem::path> cameraFile; ///< a .cam
    std::vector<LightDescription> lights;
    std::vector<MaterialOverride> materials; ///< in order; later ones win
    std::vector<EnvironmentFile> environments;
    std::vector<SettingAssignment> live, still; ///< as in a .set, which has precedence
};

/// Throws FileError: NoInput, or BadData with line and column. The files that the scene names are not looked
/// at.
SceneFile readSceneFile(const std::filesystem::path& path);
/// The same from memory; `path` gives the folder of relative paths and is named in errors.
SceneFile parseSceneFile(std::string_view text, const std::filesystem::path& path);

/// Replaces the file. Paths below its folder are written relative to it, others absolute.
/// Throws FileError CannotWrite, also when a value is one that readSceneFile would refuse.
void writeSceneFile(const std::filesystem::path& path, const SceneFile& scene);
/// The text that writeSceneFile writes to `path`.
std::string formatSceneFile(const SceneFile& scene, const std::filesystem::path& path);

} // namespace rtcore

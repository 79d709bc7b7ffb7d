/// From a path that the user named - a .scn, a .bsp or any model - to a scene with its kd-tree.
#pragma once

#include "rtcore/accel/builder.h"
#include "rtcore/accel/kd_tree.h"
#include "rtcore/io/import/model_import.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/look/lighting_preset.h"
#include "rtcore/look/material_names.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/scene.h"
#include "rtcore/survey/model_units.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rtcore {

enum class LoadPhase { ReadingScene, ImportingModel, BuildingTree, LoadingImages, Done };

/// A model of more triangles gets a fast tree where few rays are traced.
inline constexpr std::size_t kFastTreeTriangles = 200'000;

/// The user's choice of what lights a scene. An environment excludes a sky and a preset.
struct LightingOptions {
    /// In place of the scene's sky and of its active environment.
    std::optional<std::filesystem::path> environment = {}; ///< of any shape that openEnvironment() knows
    std::optional<Sky> sky = {};
    /// In place of all of the scene's lights, too; `sky` belongs to LightingPreset::Sky.
    std::optional<LightingPreset> preset = {};
    /// For models without lights; a .scn asks for LightingPreset::Headlight.
    LightingPreset usual = LightingPreset::Headlight;
};

struct LoadOptions {
    BuildOptions build; ///< for models that have no tree yet
    ImportOptions import;
    std::optional<std::filesystem::path> model; ///< in place of the one that a .scn names; ignored for others
    /// A .bsp that was made of the model: read in its place, which goes on to be named, where it can be read.
    std::optional<std::filesystem::path> cachedModel;
    LightingOptions lighting;
    /// Primary rays that the scene is loaded for, when they are known and few: a large model then gets a fast
    /// tree, whose images are the same. 0 = many.
    std::uint64_t primaryRays = 0;
    std::function<void(LoadPhase)> onPhase; ///< called at the start of each phase, in the calling thread
    BuildProgress* buildProgress = nullptr;
};

struct LoadedScene {
    Scene scene;
    KdTree tree;
    /// The .scn's, else the first of the model's that shows it, else defaultCamera().
    Camera camera;
    SceneBookmarks bookmarks;           ///< the .scn's, else the other cameras of the model
    std::optional<SceneFile> sceneFile; ///< when a .scn was named
    /// skyLight.on where there is a sky, the .scn's own settings, those of the .set that it names, what a
    /// look that the user names needs.
    std::vector<SettingAssignment> live, still;
    std::vector<Sentence> warnings; ///< each one line, with the file's name
    std::filesystem::path modelPath;
    /// The model's own and those that it names, absolute; empty where a cachedModel was read in its place.
    std::vector<std::filesystem::path> modelFiles;
    std::vector<std::filesystem::path> files; ///< all that were read, as far as known; some may stand twice
    std::vector<OpenGlass> openGlass;         ///< of the model with the scene's materials
    BuildTimes buildTimes;                    ///< zero when the tree came from a .bsp
    ModelUnits units;                         ///< what Scene::up and Scene::metresPerUnit are, and why
    ModelOrigin origin;                       ///< of the model
    bool ownCamera = true;                    ///< false: defaultCamera()
    bool indoors = false;                     ///< the camera has walls around it (isEnclosed())
    /// Guesses at the materials of a model without a .scn, for the user of the scene to apply and to report.
    std::vector<MaterialGuess> guesses;
    /// By which lightBy() lit it, for that camera; nothing: it has light of its own.
    std::optional<LightingPreset> preset;
    bool fastTree = false; ///< since LoadOptions::primaryRays are few: an exact tree serves more rays better
};

/// Content is sniffed before the extension is believed: a .bsp by its magic, a .scn by its extension or a
/// line that sets `version`, anything else goes to the importer. Throws FileError, and
/// what buildKdTree() throws: BuildCancelled when buildProgress->cancel was set.
LoadedScene loadScene(const std::filesystem::path& path, const LoadOptions& options = {});

/// Another up axis or unit of a scene that was loaded, and what of `camera` and `scene` follows from it: the
/// camera and the light of a model that brings none, and otherwise what is up in the picture.
void applyModelUnits(LoadedScene& loaded, const ModelUnits& units, Scene& scene, Camera& camera);

} // namespace rtcore

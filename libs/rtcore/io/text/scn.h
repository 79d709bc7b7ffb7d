/// .scn: a scene in text - which model, and what else it takes to make images of it (docs/formats.md).
#pragma once

#include "rtcore/io/text/pattern.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/environment_source.h"
#include "rtcore/scene/flight.h"
#include "rtcore/scene/kept_measure.h"
#include "rtcore/scene/light.h"
#include "rtcore/scene/material_override.h"
#include "rtcore/scene/pose_choice.h"
#include "rtcore/scene/scene.h"
#include "rtcore/scene/scene_note.h"
#include "rtcore/settings/settings_table.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// The newest version, which is written; all from 1 are read.
inline constexpr int kSceneFileVersion = 2;

/// One [[light]].
struct LightDescription {
    std::string name; ///< may be ""
    Light light;      ///< direction of unit length, cosOuter < cosInner; nameOffset is 0. With a temperature,
                      ///< its intensity is that without it
    int id = 0;       ///< as in LightNotes; 0: the file says none
    float temperature = 0;           ///< kelvin; 0: none
    std::filesystem::path file = {}; ///< of a luminaire (io/photometry/luminaire.h); "": none
    /// Of a luminaire without a file: the model's own of that number, counted from 1 (model_photometry.h);
    /// 0: none.
    int modelLuminaire = 0;
    /// With one of them: all that the luminaire gives off, to which its intensity has yet to be scaled, which
    /// is its colour until then; 0: what the file says. Nothing: the intensity is as it shall be.
    std::optional<float> lumens = {};
    friend bool operator==(const LightDescription&, const LightDescription&) = default;
};

/// The light number `i` of a scene whose lights are numbered, and the way back: it takes its place, or, one
/// past the last, is added. The light of a sky stays that while it keeps its name and its kind.
LightDescription describeLight(const Scene& scene, std::size_t i);
void putLight(Scene& scene, std::size_t i, const LightDescription& description);
/// The light as it shines: the intensity multiplied by the colour of the temperature.
Light tintedLight(const LightDescription& description);

/// The state of the light of a scene's [sky].
struct SunDescription {
    int id = 0; ///< as in LightNotes; 0: the file says none. A directional [[light]] that has it is the sun,
                ///< as it was edited
    bool on = true;
    friend bool operator==(const SunDescription&, const SunDescription&) = default;
};

/// One [[part]]: which parts of the model (namedParts()) are hidden, or shown; which sections do not cut.
struct PartDescription {
    std::string pattern;       ///< matchesPattern(); "": by number
    std::optional<int> number; ///< in the order of namedParts(), counted from 1
    std::optional<bool> hidden = true;
    std::optional<bool> uncut = {}; ///< at least one of the two is there
    friend bool operator==(const PartDescription&, const PartDescription&) = default;
};

inline constexpr std::size_t kMaxVariants = 100;
inline constexpr std::size_t kMaxVariantName = 200; ///< bytes

/// What surrounds the surfaces, all of it.
struct VariantSurroundings {
    Colour background, ambient;
    bool skyLight = false; ///< the setting skyLight.on
    /// The one that is shown: of files, counted from 0, or kNoEnvironment. Nothing: the sky, if there is one.
    std::optional<int> environment = {};
    std::optional<Sky> sky = {};
    int sunId = 0; ///< of the light of that sky; 0: any
    friend bool operator==(const VariantSurroundings&, const VariantSurroundings&) = default;
};

/// One [[variant]]: what it makes of the scene's base (io/variants/variant_switch.h). What it does not name
/// is as in the base.
struct SceneVariant {
    std::string name = {};                        ///< not ""; no other of the scene has it
    std::vector<MaterialOverride> materials = {}; ///< changes of the base's; without textures from files
    std::vector<PartDescription> parts = {};      ///< hidden or shown; never `uncut`
    std::vector<LightDescription> lights = {};    ///< by their ids, which are above 0; whole
    std::vector<int> removedLights = {};          ///< ids of lights that are not there
    std::optional<VariantSurroundings> surroundings = {};

    /// Nothing but a name.
    bool empty() const {
        return materials.empty() && parts.empty() && lights.empty() && removedLights.empty() && !surroundings;
    }
    friend bool operator==(const SceneVariant&, const SceneVariant&) = default;
};
using SceneVariants = std::vector<SceneVariant>; ///< kMaxVariants at most

/// The end where none has that name.
SceneVariants::const_iterator findVariant(const SceneVariants& variants, std::string_view name);
/// Why no variant can be called so: it is empty, too long, no UTF-8, or holds control characters.
std::optional<Sentence> problemOfVariantName(const std::string& name);

/// One [[bookmark]]: a view that is kept under a name.
struct SceneBookmark {
    std::string name; ///< not ""; no other of the scene has it
    Camera camera;    ///< nameOffset is 0
    friend bool operator==(const SceneBookmark&, const SceneBookmark&) = default;
};
using SceneBookmarks = std::vector<SceneBookmark>;

/// The end where none has that name.
SceneBookmarks::const_iterator findBookmark(const SceneBookmarks& bookmarks, std::string_view name);

/// All paths are absolute or relative to the current folder. Lengths are in scene units.
struct SceneFile : SceneLook {
    std::filesystem::path model; ///< a .bsp or a model
    std::optional<std::filesystem::path> settings, output;
    bool defaultLight = true; ///< what has no light at all gets one; false: it stays dark
    bool modelLights = true;  ///< use the model's own lights beside `lights`
    float creaseAngle = 40;   ///< degrees, for models without normals
    float deflection =
        0.0005F;               ///< of a CAD file that is imported: how far triangles lie off, by the diagonal
    bool flipTextures = false; ///< of a model that is imported: turn its textures upside down
    PoseChoice pose;           ///< of a model that is imported and animated
    std::optional<Camera> camera;                    ///< at most one of these two; nameOffset is 0
    std::optional<std::filesystem::path> cameraFile; ///< a .cam
    std::vector<LightDescription> lights;
    SunDescription sun;                      ///< with a sky
    std::vector<MaterialOverride> materials; ///< in order; later ones win
    std::vector<PartDescription> parts;      ///< the same
    std::vector<EnvironmentFile> environments;
    SceneBookmarks bookmarks;
    KeptMeasures measures;
    SceneNotes notes;
    Flights flights;
    SceneVariants variants;    ///< of the base, which is what all above says
    std::string activeVariant; ///< is shown; "": none
    /// What is shown of the base, where that is not just what the active variant says; without a name.
    std::optional<SceneVariant> shown;
    std::vector<SettingAssignment> live, still; ///< as in a .set, which has precedence
};

/// Positions are seen from `zero`, that of the model (ModelOrigin), which is its `origin` then; without one,
/// from the file's own `origin`. Throws FileError: NoInput, or BadData with line and column. The files that
/// the scene names are not looked at.
SceneFile readSceneFile(const std::filesystem::path& path, const std::optional<LocalOrigin>& zero = {});
/// The same from memory; `path` gives the folder of relative paths and is named in errors.
SceneFile parseSceneFile(std::string_view text, const std::filesystem::path& path,
                         const std::optional<LocalOrigin>& zero = {});

/// The keys of a [[material]] that commands may give.
std::span<const std::string_view> materialKeys();
/// One key of a [[material]] with its value as it is typed in commands: one number or more, true, false.
/// Throws FileError BadData.
MaterialOverride parseMaterialKey(const std::string& key, std::span<const std::string> words);
/// The text of a [[material]].
std::string formatMaterial(const MaterialOverride& material);

/// The text of a [[variant]], in the coordinates in which that of the scene's zero is `zero`.
std::string formatVariant(const SceneVariant& variant, const LocalOrigin& zero);

/// The text of a [[flight]], in the coordinates in which that of the scene's zero is `zero`.
std::string formatFlight(const Flight& flight, const LocalOrigin& zero);

/// Replaces the file. Paths below its folder are written relative to it, others absolute.
/// Throws FileError CannotWrite, also when a value is one that readSceneFile would refuse.
void writeSceneFile(const std::filesystem::path& path, const SceneFile& scene);
/// The text that writeSceneFile writes to `path`; hasWrittenMark().
std::string formatSceneFile(const SceneFile& scene, const std::filesystem::path& path);

} // namespace rtcore

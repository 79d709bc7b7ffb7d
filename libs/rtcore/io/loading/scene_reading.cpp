#include "rtcore/io/loading/scene_reading.h"

#include "rtcore/io/images/environment_file.h"
#include "rtcore/io/loading/material_overrides.h"
#include "rtcore/io/loading/model_reading.h"
#include "rtcore/io/loading/sections.h"
#include "rtcore/io/photometry/luminaire.h"
#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/set.h"
#include "rtcore/io/variants/material_words.h"
#include "rtcore/io/variants/variant_switch.h"
#include "rtcore/look/shell_picture.h"
#include "rtcore/platform/error.h"
#include "rtcore/sky/scene_sky.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

class SceneReading {
  public:
    explicit SceneReading(Loading& loading) : loading_(loading), out_(loading.out) {}

    void read(const std::filesystem::path& path) {
        SceneFile file = readSceneFile(path);
        if (loading_.options.model) file.model = *loading_.options.model;
        InputFile model(file.model);
        const FileKind kind = kindOfFile(file.model, model);
        if (kind == FileKind::Scene) {
            throw FileError(
                FailureKind::BadData, path.string(),
                say("its model is a scene file too; name a .bsp or a model: {0}", file.model.string()));
        }
        ImportOptions import = loading_.options.import;
        if (!import.creaseAngle) import.creaseAngle = file.creaseAngle;
        if (!import.flipTextures) import.flipTextures = file.flipTextures;
        if (!import.pose) import.pose = file.pose;
        if (!import.deflection) import.deflection = file.deflection;
        readModel(loading_, file.model, std::move(model), kind, import);
        const LocalOrigin& zero = out_.origin.zero;
        if (zero != file.origin) seeFrom(zero, path, file);

        Scene& scene = out_.scene;
        if (file.modelLights) takeModelLights(scene);
        readLights(file);
        static_cast<SceneLook&>(scene) = file;
        loading_.describedSky = std::exchange(scene.sky, std::nullopt);
        loading_.begin(LoadPhase::LoadingImages);
        overrideMaterials(loading_, path, file);
        markParts(path, file);
        warnOfUnused(path, file);
        for (const EnvironmentFile& environment : file.environments) {
            if (environment.kind == EnvironmentKind::Parts)
                addShell(path, environment);
            else
                loading_.addFile(environment, loadEnvironment(environment));
        }
        scene.activeEnvironment = file.activeEnvironment;
        readSettings(file);
        if (file.camera) out_.camera = *file.camera;
        if (file.cameraFile) {
            out_.camera = readCameraFile(*file.cameraFile, file.origin).camera;
            out_.files.push_back(*file.cameraFile);
        }
        loading_.hasCamera = file.camera || file.cameraFile;
        out_.sceneFile = file;
    }

  private:
    /// Reads it again: its numbers have more digits than its floats.
    void seeFrom(const LocalOrigin& zero, const std::filesystem::path& path, SceneFile& file) {
        const std::filesystem::path model = std::move(file.model);
        file = readSceneFile(path, zero);
        file.model = model;
    }

    void readLights(SceneFile& file) {
        Scene& scene = out_.scene;
        const auto unit =
            static_cast<float>(loading_.options.import.metresPerUnit.value_or(double{file.metresPerUnit}));
        for (const LightDescription& light : file.lights)
            putLight(scene, scene.lights.size(), withLuminaire(light, unit));
        for (SceneVariant& variant : file.variants) completeLights(variant, unit);
        if (file.shown) completeLights(*file.shown, unit);
    }

    LightDescription withLuminaire(LightDescription light, float unit) {
        readLuminaire(light, unit, out_.warnings);
        takeLuminaire(out_.scene.model.lights, light, unit, out_.warnings);
        if (!light.file.empty()) out_.files.push_back(light.file);
        return light;
    }

    /// As the scene describes such lights; no light that is added has the number of one of them.
    void completeLights(SceneVariant& variant, float unit) {
        Scene& scene = out_.scene;
        for (LightDescription& light : variant.lights) {
            putLight(scene, scene.lights.size(), withLuminaire(light, unit));
            light = describeLight(scene, scene.lights.size() - 1);
            scene.lights.pop_back();
            scene.removedLightId = std::max(scene.removedLightId, light.id);
        }
    }

    void warnOfUnused(const std::filesystem::path& path, const SceneFile& file) {
        const Scene& scene = out_.scene;
        const std::vector<NamedPart> parts = namedParts(scene.model);
        for (const SceneVariant& variant : file.variants) {
            for (const MaterialOverride& each : variant.materials) {
                std::size_t i = 0;
                while (i < scene.materials.size() && !isFor(each, scene, i)) ++i;
                if (i == scene.materials.size()) out_.warnings.push_back(unusedMaterial(path, each));
            }
            for (const PartDescription& each : variant.parts) {
                std::size_t i = 0;
                while (i < parts.size() && !isFor(each, parts[i], i)) ++i;
                if (i == parts.size()) out_.warnings.push_back(unusedPart(path, each));
            }
        }
    }

    void markParts(const std::filesystem::path& path, const SceneFile& file) {
        if (file.parts.empty()) return;
        Scene& scene = out_.scene;
        const std::vector<NamedPart> parts = namedParts(scene.model);
        for (const PartDescription& each : file.parts) {
            std::vector<std::uint8_t> chosen(parts.size());
            for (std::size_t i = 0; i < parts.size(); ++i)
                chosen[i] = isNamed(each.pattern, each.number, i, parts[i].name) ? 1 : 0;
            if (std::find(chosen.begin(), chosen.end(), 1) == chosen.end())
                out_.warnings.push_back(unusedPart(path, each));
            if (each.hidden)
                scene.hiddenParts = withParts(scene.model, parts, chosen, *each.hidden, scene.hiddenParts);
            if (each.uncut)
                scene.uncutParts = withParts(scene.model, parts, chosen, *each.uncut, scene.uncutParts);
        }
    }

    /// Where the model has no such parts any more, it is black, so that the numbers of the others stay.
    void addShell(const std::filesystem::path& path, const EnvironmentFile& environment) {
        const Model& model = out_.scene.model;
        std::vector<std::uint8_t> pieces(model.parts.size());
        const std::vector<NamedPart> parts = namedParts(model);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const bool named = std::ranges::any_of(environment.parts, [&](const std::string& pattern) {
                return isNamed(pattern, std::nullopt, i, parts[i].name);
            });
            for (const std::uint32_t piece : parts[i].pieces) pieces[piece] |= named ? 1U : 0U;
        }
        const std::string& name = environment.parts.front();
        auto shown = pictureOfShell(out_.scene, out_.tree, pieces, name);
        if (!shown) {
            out_.warnings.push_back(
                say("{0}: {1}", path.string(),
                    say("no parts of the model that show an image are named \"{0}\"; that "
                        "environment is black",
                        name)));
            shown = Environment::fromEquirectangular(HdrImage(2, 1), name);
        }
        addEnvironment(out_.scene, environment, std::move(*shown));
    }

    /// The .scn's own settings first, then those of the .set that it names, which win.
    void readSettings(const SceneFile& file) {
        out_.live = file.live;
        out_.still = file.still;
        if (!file.settings) return;
        const SettingsFile settings = readSettingsFile(*file.settings);
        out_.files.push_back(*file.settings);
        out_.live.insert(out_.live.end(), settings.live.begin(), settings.live.end());
        out_.still.insert(out_.still.end(), settings.still.begin(), settings.still.end());
    }

    Loading& loading_;
    LoadedScene& out_;
};

} // namespace

void readDescribed(Loading& loading, const std::filesystem::path& path) { SceneReading(loading).read(path); }

} // namespace rtcore

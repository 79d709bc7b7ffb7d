#include "rtcore/io/scene_loader.h"

#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/images/environment_file.h"
#include "rtcore/io/images/image_file.h"
#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/set.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/scene/closed_surfaces.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

enum class FileKind { Scene, Bsp, Model };

/// A .scn is text in which some line sets `version`; other programs' .scn files are not. Nor is XML, where an
/// attribute `version` may stand at the beginning of a line.
bool isSceneText(std::string_view head) {
    if (head.find('\0') != std::string_view::npos) return false;
    const std::size_t text = head.find_first_not_of("\xEF\xBB\xBF \t\r\n");
    if (text != std::string_view::npos && head[text] == '<') return false;
    while (!head.empty()) {
        const std::size_t end = std::min(head.find('\n'), head.size());
        std::string_view line = head.substr(0, end);
        head.remove_prefix(std::min(end + 1, head.size()));
        if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        if (!line.starts_with("version")) continue;
        line.remove_prefix(std::string_view("version").size());
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        if (line.starts_with("=")) return true;
    }
    return false;
}

FileKind sniff(const std::filesystem::path& path, InputFile& file) {
    constexpr std::size_t kHead = 65536;
    const std::span<const std::byte> bytes = file.head(kHead);
    if (isBsp(bytes)) return FileKind::Bsp;
    const std::string_view head(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const bool text = head.find('\0') == std::string_view::npos && !head.starts_with("Caligari");
    if (isSceneText(head) || (path.extension() == ".scn" && text)) return FileKind::Scene;
    return FileKind::Model;
}

class Loader {
  public:
    explicit Loader(const LoadOptions& options) : options_(options) {}

    LoadedScene load(const std::filesystem::path& path) {
        phase(LoadPhase::ReadingScene);
        out_.files.push_back(path);
        InputFile file(path);
        const FileKind kind = sniff(path, file);
        if (kind == FileKind::Scene) {
            loadDescribed(path);
        } else {
            loadModel(path, std::move(file), kind, options_.import);
            takeModelLights();
            out_.scene.background = {0.03F, 0.036F, 0.048F};
            out_.scene.ambient = kWhite * 0.15F;
        }
        finish();
        return std::move(out_);
    }

  private:
    void phase(LoadPhase p) const {
        if (options_.onPhase) options_.onPhase(p);
    }

    void loadDescribed(const std::filesystem::path& path) {
        SceneFile file = readSceneFile(path);
        if (options_.model) file.model = *options_.model;
        InputFile model(file.model);
        const FileKind kind = sniff(file.model, model);
        if (kind == FileKind::Scene) {
            throw FileError(FailureKind::BadData, path.string(),
                            "its model is a scene file too; name a .bsp or a model: " + file.model.string());
        }
        ImportOptions import = options_.import;
        if (!import.creaseAngle) import.creaseAngle = file.creaseAngle;
        if (!import.flipTextures) import.flipTextures = file.flipTextures;
        loadModel(file.model, std::move(model), kind, import);

        Scene& scene = out_.scene;
        if (file.modelLights) takeModelLights();
        for (const LightDescription& light : file.lights) {
            scene.lights.push_back(light.light);
            scene.lightNames.push_back(light.name);
        }
        static_cast<SceneLook&>(scene) = file;
        phase(LoadPhase::LoadingImages);
        overrideMaterials(path, file);
        for (const EnvironmentFile& environment : file.environments) loadEnvironment(environment);
        readSettings(file);
        if (file.camera) out_.camera = *file.camera;
        if (file.cameraFile) {
            out_.camera = readCameraFile(*file.cameraFile).camera;
            out_.files.push_back(*file.cameraFile);
        }
        hasCamera_ = file.camera || file.cameraFile;
        out_.sceneFile = file;
    }

    void loadModel(const std::filesystem::path& path, InputFile file, FileKind kind,
                   const ImportOptions& import) {
        Scene& scene = out_.scene;
        out_.modelPath = path;
        out_.files.push_back(path);
        if (kind == FileKind::Bsp) {
            take(readBsp(file.read(), path.string()));
        } else if (!loadBuilt()) {
            phase(LoadPhase::ImportingModel);
            ImportedModel imported = importModel(path, import);
            warn(imported.report.warnings);
            out_.origin = std::move(imported.report.origin);
            out_.files.insert(out_.files.end(), imported.report.files.begin(), imported.report.files.end());
            scene.model = std::move(imported.model);
        }
        if (out_.tree.nodes.empty()) {
            phase(LoadPhase::BuildingTree);
            out_.tree = buildKdTree(scene.mesh(), buildOptions(scene.mesh().triangles.size()),
                                    &out_.buildTimes, options_.buildProgress);
        }
        scene.materials.assign(scene.model.materials.begin(), scene.model.materials.end());
        if (!scene.model.cameras.empty()) {
            out_.camera = scene.model.cameras.front();
            hasCamera_ = true;
        }
    }

    void warn(const std::vector<std::string>& warnings) {
        for (const std::string& warning : warnings)
            out_.warnings.push_back(out_.modelPath.string() + ": " + warning);
    }

    void take(BspContent content) {
        warn(content.warnings);
        out_.origin = std::move(content.origin);
        out_.scene.model = std::move(content.model);
        if (content.tree) out_.tree = std::move(*content.tree);
    }

    bool loadBuilt() {
        if (!options_.cachedModel) return false;
        try {
            take(readBsp(openFileBytes(*options_.cachedModel), options_.cachedModel->string()));
            out_.files.push_back(*options_.cachedModel);
            return true;
        } catch (const FileError& error) {
            out_.warnings.emplace_back(error.what());
            return false;
        }
    }

    /// The exact tree saves about a sixth of the time of each ray and costs several times that of the quick
    /// one, whose leaves are large.
    BuildOptions buildOptions(std::size_t triangles) {
        constexpr std::uint64_t kRaysPerTriangle = 4;
        constexpr int kQuick = 3;
        constexpr float kQuickIntersectionCost = 0.05F;
        BuildOptions build = options_.build;
        const bool few = options_.primaryRays > 0 && options_.primaryRays < kRaysPerTriangle * triangles;
        if (few && triangles > kFastTreeTriangles) {
            out_.fastTree = true;
            build.method = BuildMethod::Fast;
            build.fastQuality = kQuick;
            build.intersectionCost = kQuickIntersectionCost;
        }
        return build;
    }

    void takeModelLights() {
        Scene& scene = out_.scene;
        for (const Light& light : scene.model.lights) {
            scene.lights.push_back(light);
            scene.lightNames.emplace_back(scene.model.name(light.nameOffset));
        }
    }

    void overrideMaterials(const std::filesystem::path& path, const SceneFile& file) {
        Scene& scene = out_.scene;
        std::vector<LdrImage> pictures;
        for (const MaterialOverride& change : file.materials) {
            bool used = false;
            std::uint32_t texture = kNoTexture;
            for (Material& material : scene.materials) {
                if (!matchesPattern(change.pattern, scene.model.name(material.nameOffset))) continue;
                used = true;
                change.applyTo(material);
                if (!change.diffuseTexture) continue;
                if (texture == kNoTexture) {
                    texture = static_cast<std::uint32_t>(scene.model.textures.size() + pictures.size());
                    pictures.push_back(readLdrImage(*change.diffuseTexture));
                    out_.files.push_back(*change.diffuseTexture);
                }
                material.diffuseTexture = texture;
            }
            if (!used) {
                out_.warnings.push_back(path.string() + ": no material of the model is named like \"" +
                                        change.pattern + "\"");
            }
        }
        if (!pictures.empty()) addTextures(pictures);
    }

    /// The model's textures followed by these, in memory of their own.
    void addTextures(const std::vector<LdrImage>& pictures) {
        struct Extended {
            std::shared_ptr<const void> model;
            std::vector<Texture> textures;
            std::vector<Rgba8> texels;
        };
        Model& model = out_.scene.model;
        auto extended = std::make_shared<Extended>();
        extended->model = model.storage;
        extended->textures.assign(model.textures.begin(), model.textures.end());
        extended->texels.assign(model.texels.begin(), model.texels.end());
        for (const LdrImage& picture : pictures) {
            extended->textures.push_back({extended->texels.size(), static_cast<std::uint32_t>(picture.width),
                                          static_cast<std::uint32_t>(picture.height)});
            extended->texels.insert(extended->texels.end(), picture.pixels.begin(), picture.pixels.end());
        }
        model.textures = extended->textures;
        model.texels = extended->texels;
        model.storage = extended;
    }

    void loadEnvironment(const EnvironmentFile& file) {
        const auto read = [&]() -> Environment {
            switch (file.kind) {
            case EnvironmentKind::Cross:
                return loadCubeCross(file.files.at(0));
            case EnvironmentKind::Strip:
                return loadCubeStrip(file.files.at(0));
            case EnvironmentKind::Faces: {
                std::array<std::filesystem::path, 6> faces;
                std::copy_n(file.files.begin(), std::min<std::size_t>(6, file.files.size()), faces.begin());
                return loadCubeFaces(faces);
            }
            case EnvironmentKind::Equirectangular:
                break;
            }
            return loadEquirectangular(file.files.at(0));
        };
        Environment environment = read();
        out_.files.insert(out_.files.end(), file.files.begin(), file.files.end());
        environment.intensity = file.intensity;
        out_.scene.environments.push_back(std::make_shared<const Environment>(std::move(environment)));
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

    /// The options win over a .scn, that over the model's file, that over a guess.
    void decideUpAndUnit() {
        UpAndUnit frame;
        if (out_.sceneFile) {
            frame.up = frame.otherUp = out_.scene.up;
            frame.metresPerUnit = out_.scene.metresPerUnit;
            frame.upSaid = frame.unitSaid = Said::ByScene;
        } else {
            frame = guessUpAndUnit(out_.origin, out_.tree, out_.scene.mesh());
        }
        frame = withUserSays(frame, options_.import.up, options_.import.metresPerUnit);
        out_.ownCamera = hasCamera_;
        // A camera of the model's or the scene's own knows what is up, unless the user knows better.
        if (hasCamera_ && frame.upSaid == Said::ByUser) return reframe(out_, frame, out_.scene, out_.camera);
        out_.frame = frame;
        out_.scene.up = frame.up;
        out_.scene.metresPerUnit = frame.metresPerUnit;
        if (!hasCamera_) out_.camera = defaultCamera(out_.tree, out_.scene.mesh(), frame.up);
    }

    void finish() {
        Scene& scene = out_.scene;
        decideUpAndUnit();
        // A scene lit by its surroundings alone is a choice; one without any light is an oversight.
        const bool emits = std::any_of(scene.materials.begin(), scene.materials.end(),
                                       [](const Material& m) { return !isBlack(m.emission); });
        if (scene.lights.empty() && (isBlack(scene.ambient) || !out_.sceneFile) &&
            !(emits && out_.sceneFile)) {
            scene.lights.push_back(defaultLight(out_.camera, out_.tree.bounds));
            scene.lightNames.emplace_back("default");
            out_.ownLight = false;
        }
        scene.closed = findClosedSurfaces(scene.mesh(), scene.materials);
        phase(LoadPhase::Done);
    }

    const LoadOptions& options_;
    LoadedScene out_;
    bool hasCamera_ = false;
};

} // namespace

LoadedScene loadScene(const std::filesystem::path& path, const LoadOptions& options) {
    return Loader(options).load(path);
}

void reframe(LoadedScene& loaded, const UpAndUnit& frame, Scene& scene, Camera& camera) {
    const bool turned = frame.up != scene.up;
    loaded.frame = frame;
    scene.up = frame.up;
    scene.metresPerUnit = frame.metresPerUnit;
    if (!turned) return;
    if (loaded.ownCamera) {
        camera.up = upwardsOf(camera.forward, frame.up);
        return;
    }
    camera = loaded.camera = defaultCamera(loaded.tree, scene.mesh(), frame.up);
    if (loaded.ownLight || scene.lights.size() != 1) return;
    const std::uint32_t on = scene.lights.front().on;
    scene.lights.front() = defaultLight(camera, loaded.tree.bounds);
    scene.lights.front().on = on;
}

} // namespace rtcore

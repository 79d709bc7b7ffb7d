#include "rtcore/io/scene_loader.h"

#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/images/environment_file.h"
#include "rtcore/io/images/image_file.h"
#include "rtcore/io/import/import_report.h"
#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/pattern.h"
#include "rtcore/io/text/set.h"
#include "rtcore/look/seen_places.h"
#include "rtcore/look/shell_picture.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/render/visible_scene.h"
#include "rtcore/scene/closed_surfaces.h"
#include "rtcore/scene/image_summary.h"
#include "rtcore/scene/material_edit.h"
#include "rtcore/sky/scene_sky.h"
#include "rtcore/survey/default_view.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

enum class FileKind { Scene, Bsp, Model };

/// Whether a section for `pattern`, or for the `number` counted from 1, is for the element `index` of a list.
bool isNamed(const std::string& pattern, std::optional<int> number, std::size_t index,
             std::string_view name) {
    return number ? static_cast<std::size_t>(*number) == index + 1 : matchesPattern(pattern, name);
}

std::string_view materialName(const Scene& scene, std::size_t index) {
    return scene.model.name(scene.materials[index].nameOffset);
}

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

void straightenCamera(Vec3 up, Camera& camera) { camera.up = upwardsOf(camera.forward, up); }

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
            out_.scene.background = kPlainBackground;
            out_.scene.ambient = kPlainAmbient;
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
        for (const LightDescription& light : file.lights) putLight(scene, scene.lights.size(), light);
        static_cast<SceneLook&>(scene) = file;
        described_ = std::exchange(scene.sky, std::nullopt);
        phase(LoadPhase::LoadingImages);
        overrideMaterials(path, file);
        hideParts(path, file);
        for (const EnvironmentFile& environment : file.environments) {
            if (environment.kind == EnvironmentKind::Parts)
                addShell(path, environment);
            else
                addFile(environment, loadEnvironment(environment));
        }
        scene.activeEnvironment = file.activeEnvironment;
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
            out_.modelFiles = {std::filesystem::absolute(path)};
        } else if (!loadBuilt()) {
            phase(LoadPhase::ImportingModel);
            ImportedModel imported = importModel(path, import);
            warn(imported.report.warnings);
            out_.origin = std::move(imported.report.origin);
            out_.modelFiles.assign(imported.report.files.begin(), imported.report.files.end());
            out_.files.insert(out_.files.end(), out_.modelFiles.begin(), out_.modelFiles.end());
            scene.model = std::move(imported.model);
        }
        if (out_.tree.nodes.empty()) {
            phase(LoadPhase::BuildingTree);
            out_.tree = buildKdTree(scene.model.mesh, buildOptions(scene.model.mesh.triangles.size()),
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
        for (const Light& light : scene.model.lights)
            scene.lights.emplace_back(light, std::string(scene.model.name(light.nameOffset)));
    }

    void overrideMaterials(const std::filesystem::path& path, const SceneFile& file) {
        Scene& scene = out_.scene;
        std::vector<LdrImage> pictures;
        for (const MaterialOverride& change : file.materials) {
            std::optional<std::uint32_t> texture;
            bool used = false;
            for (std::size_t i = 0; i < scene.materials.size(); ++i) {
                if (!isNamed(change.pattern, change.number, i, materialName(scene, i))) continue;
                used = true;
                if (change.diffuseTexture && !texture) {
                    texture = static_cast<std::uint32_t>(scene.model.textures.size() + pictures.size());
                    pictures.push_back(readLdrImage(*change.diffuseTexture));
                    out_.files.push_back(*change.diffuseTexture);
                }
                changeMaterial(change, texture, pictures, scene.materials[i]);
            }
            if (!used) warnOfUnused(path, "material", change.pattern, change.number);
        }
        if (!pictures.empty()) addTextures(pictures);
    }

    void changeMaterial(const MaterialOverride& change, std::optional<std::uint32_t> texture,
                        const std::vector<LdrImage>& pictures, Material& material) const {
        const Model& model = out_.scene.model;
        const std::uint32_t seen = texture                                ? *texture
                                   : change.textures && !*change.textures ? kNoTexture
                                                                          : material.diffuseTexture;
        TextureMeans means;
        if (change.needsMeans()) {
            means = roughnessMeans(model, material);
            const std::size_t known = model.textures.size();
            if (seen != kNoTexture)
                means.diffuse = seen < known ? textureMean(model, seen)
                                             : summarise(pictures[seen - known].pixels).meanColour;
        }
        change.applyTo(material, means);
        if (texture) material.diffuseTexture = *texture;
    }

    void warnOfUnused(const std::filesystem::path& path, const std::string& what, const std::string& pattern,
                      std::optional<int> number) {
        const std::string which =
            number ? "has the number " + std::to_string(*number) : "is named like \"" + pattern + "\"";
        out_.warnings.push_back(path.string() + ": no " + what + " of the model " + which);
    }

    void hideParts(const std::filesystem::path& path, const SceneFile& file) {
        if (file.parts.empty()) return;
        Scene& scene = out_.scene;
        const std::vector<NamedPart> parts = namedParts(scene.model);
        for (const PartDescription& each : file.parts) {
            std::vector<std::uint8_t> chosen(parts.size());
            for (std::size_t i = 0; i < parts.size(); ++i)
                chosen[i] = isNamed(each.pattern, each.number, i, parts[i].name) ? 1 : 0;
            if (std::find(chosen.begin(), chosen.end(), 1) == chosen.end())
                warnOfUnused(path, "part", each.pattern, each.number);
            scene.hiddenParts = withParts(scene.model, parts, chosen, each.hidden, scene.hiddenParts);
        }
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
            out_.warnings.push_back(path.string() +
                                    ": no parts of the model that show a picture are named \"" + name +
                                    "\"; that environment is black");
            shown = Environment::fromEquirectangular(HdrImage(2, 1), name);
        }
        addEnvironment(out_.scene, environment, std::move(*shown));
    }

    void addFile(const EnvironmentFile& file, Environment environment) {
        out_.files.insert(out_.files.end(), file.files.begin(), file.files.end());
        addEnvironment(out_.scene, file, std::move(environment));
    }

    /// The light of the .scn that is its sun, as it was edited.
    std::optional<std::size_t> editedSun() const {
        if (!described_ || out_.sceneFile->sun.id == 0) return std::nullopt;
        const auto light = lightWithId(out_.scene, out_.sceneFile->sun.id);
        const bool fits = light && out_.scene.lights[*light].light.kind == LightKind::Directional;
        return fits ? light : std::nullopt;
    }

    void setSun(const SunDescription& sun, std::optional<std::size_t> edited) {
        Scene& scene = out_.scene;
        if (edited) return replaceSun(scene, *edited);
        if (!sunOf(scene)) return;
        SceneLight& own = scene.lights[*sunOf(scene)];
        own.light.on = sun.on ? 1 : 0;
        if (sun.id > 0 && !lightWithId(scene, sun.id)) own.notes.id = sun.id;
    }

    /// Of the options, in place of what the scene has. Settings of files win over that a sky lights.
    void takeSurroundings() {
        Scene& scene = out_.scene;
        const int active = scene.activeEnvironment;
        auto edited = editedSun();
        if (edited && (options_.surroundings.environment || options_.surroundings.sky)) {
            eraseLight(scene, *edited); // it goes with the sky of the file
            edited.reset();
        }
        if (options_.surroundings.environment) {
            phase(LoadPhase::LoadingImages);
            OpenedEnvironment opened = openEnvironment(*options_.surroundings.environment);
            addFile(opened.file, std::move(opened.environment));
            scene.activeEnvironment = static_cast<int>(scene.environments.size()) - 1;
        } else if (options_.surroundings.sky || described_) {
            setSky(scene, options_.surroundings.sky ? options_.surroundings.sky : described_);
            if (described_) setSun(out_.sceneFile->sun, edited);
            if (!options_.surroundings.sky) scene.activeEnvironment = active;
        }
    }

    /// Files' own assignments stand behind what follows from them, and before what the user says.
    void take(const std::vector<SettingAssignment>& settings, bool last = false) {
        for (auto* const all : {&out_.live, &out_.still})
            all->insert(last ? all->end() : all->begin(), settings.begin(), settings.end());
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
            frame = guessUpAndUnit(out_.origin, out_.tree, out_.scene.model);
        }
        frame = withUserSays(frame, options_.import.up, options_.import.metresPerUnit);
        // A camera of the model's or the scene's own knows what is up, unless the user knows better.
        if (hasCamera_ && frame.upSaid == Said::ByUser && frame.up != out_.scene.up)
            straightenCamera(frame.up, out_.camera);
        out_.frame = frame;
        out_.scene.up = frame.up;
        out_.scene.metresPerUnit = frame.metresPerUnit;
    }

    const Survey& surveyed() {
        if (!survey_) survey_ = survey(out_.tree, out_.scene.model.mesh, axesOf(out_.scene));
        return *survey_;
    }

    /// One of the model's own that shows it, or else one that does; the others become bookmarks.
    void chooseCamera() {
        const Mesh& mesh = out_.scene.model.mesh;
        if (out_.sceneFile) {
            out_.bookmarks = out_.sceneFile->bookmarks;
        } else if (hasCamera_) {
            const std::span<const Camera> cameras = out_.scene.model.cameras;
            const auto shown = std::find_if(cameras.begin(), cameras.end(),
                                            [&](const Camera& camera) { return isFirstView(camera); });
            hasCamera_ = shown != cameras.end();
            if (hasCamera_ && shown != cameras.begin()) out_.camera = *shown;
            bookmarkCameras(static_cast<std::size_t>(shown - cameras.begin()));
        }
        out_.ownCamera = hasCamera_;
        if (!hasCamera_) out_.camera = defaultCamera(out_.tree, mesh, surveyed());
        out_.indoors = isEnclosed(out_.tree, mesh, axesOf(out_.scene), out_.camera.eye);
    }

    /// Whether one who does not know the model sees it by that camera: not so near that most of an object is
    /// beyond the image.
    bool isFirstView(const Camera& camera) {
        constexpr float kLeastPart = 0.5F;
        const Mesh& mesh = out_.scene.model.mesh;
        const Axes axes = axesOf(out_.scene);
        const Box3& bounds = surveyed().subject.bounds;
        if (!showsModel(seenPlaces(out_.tree, mesh, camera), bounds)) return false;
        const bool object = !surveyed().inside() && !surveyed().isStage();
        if (!object || isIndoors(out_.tree, mesh, axes, camera.eye)) return true;
        std::vector<SeenPlace> model =
            seenPlaces(out_.tree, mesh, defaultCamera(out_.tree, mesh, surveyed()));
        std::erase_if(model, [&](const SeenPlace& place) { return !bounds.contains(place.position); });
        return partInImage(model, camera) >= kLeastPart;
    }

    /// All but the one that is shown, under their names.
    void bookmarkCameras(std::size_t shown) {
        const Model& model = out_.scene.model;
        std::vector<std::string> unused;
        for (std::size_t i = 0; i < model.cameras.size(); ++i) {
            if (i == shown) continue;
            const std::string own(model.name(model.cameras[i].nameOffset));
            std::string name = own.empty() ? "camera " + std::to_string(i + 1) : own;
            for (int n = 2; findBookmark(out_.bookmarks, name) != out_.bookmarks.end(); ++n)
                name = (own.empty() ? "camera" : own) + " " + std::to_string(n);
            if (i < shown) unused.push_back(name);
            out_.bookmarks.push_back({name, model.cameras[i]});
            out_.bookmarks.back().camera.nameOffset = 0;
        }
        if (unused.empty()) return;
        const bool one = unused.size() == 1;
        warn({(one ? "its camera " : "its cameras ") + firstOf(unused) + (one ? " shows" : " show") +
              " little or nothing of the model; kept as " + (one ? "a bookmark" : "bookmarks")});
    }

    /// The parts that are the skies around the model, one value for each; none where a part is more than
    /// that.
    std::vector<std::uint8_t> domesAmong(const std::vector<NamedPart>& parts) {
        const std::vector<std::uint32_t>& domes = surveyed().subject.domes;
        std::vector<std::uint8_t> chosen(parts.size());
        std::uint64_t triangles = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto holdsDome = [&](std::uint32_t piece) {
                const ModelPart& part = out_.scene.model.parts[piece];
                const auto next = std::ranges::lower_bound(domes, part.firstTriangle);
                return next != domes.end() && *next - part.firstTriangle < part.triangleCount;
            };
            if (std::none_of(parts[i].pieces.begin(), parts[i].pieces.end(), holdsDome)) continue;
            chosen[i] = 1;
            triangles += parts[i].triangles;
        }
        if (triangles != domes.size()) chosen.clear();
        return chosen;
    }

    /// The picture of the chosen parts, as an environment.
    bool showShell(const std::vector<NamedPart>& parts, const std::vector<std::uint8_t>& chosen) {
        Scene& scene = out_.scene;
        if (options_.surroundings.look || options_.surroundings.environment || scene.sky) return false;
        EnvironmentFile described;
        described.kind = EnvironmentKind::Parts;
        std::vector<std::uint8_t> pieces(scene.model.parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (chosen[i] == 0) continue;
            if (parts[i].name.empty() || isPattern(parts[i].name)) return false; // no scene can name it
            described.parts.emplace_back(parts[i].name);
            for (const std::uint32_t piece : parts[i].pieces) pieces[piece] = 1;
        }
        auto picture = pictureOfShell(scene, out_.tree, pieces, described.parts.front());
        if (!picture) return false;
        scene.activeEnvironment = static_cast<int>(addEnvironment(scene, described, std::move(*picture)));
        return true;
    }

    /// A sky that was modelled around everything would keep the light out.
    void hideDomes() {
        Scene& scene = out_.scene;
        if (surveyed().subject.domes.empty()) return;
        const std::vector<NamedPart> parts = namedParts(scene.model);
        const std::vector<std::uint8_t> chosen = domesAmong(parts);
        if (chosen.empty())
            return warn({"a sky that was modelled around it keeps the light out; make it a part of its own"});
        std::vector<std::string> names;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (chosen[i] != 0) names.emplace_back(parts[i].name);
        const bool shown = showShell(parts, chosen);
        scene.hiddenParts = withParts(scene.model, parts, chosen, true, scene.hiddenParts);
        if (shown)
            return warn({"the sky that was modelled around it, " + firstOf(names) +
                         ", lights it as an environment map; 'look sky' shows it under another sky"});
        warn({"the sky that was modelled around it, " + firstOf(names) +
              ", is hidden, since it would keep the light out; 'part show' or --show shows it"});
    }

    void lightByLook(Look look, bool last = false) {
        Scene& scene = out_.scene;
        const LookLights lights =
            lookLights(look, out_.tree, scene.model.mesh, surveyed(), out_.camera, options_.surroundings.sky);
        lightBy(scene, lights);
        out_.look = look;
        take(settingsOf(look, surveyed()), last);
    }

    /// A material gives off light.
    bool shines() const {
        return std::any_of(out_.scene.materials.begin(), out_.scene.materials.end(),
                           [](const Material& m) { return !isBlack(m.emission); });
    }

    bool hasLight() const {
        // A scene lit by its surroundings alone is a choice; one without any light is an oversight.
        const bool chosen =
            out_.sceneFile && (!out_.sceneFile->defaultLight || shines() || !isBlack(out_.scene.ambient));
        return chosen || out_.scene.lights.size() > (options_.surroundings.sky ? 1 : 0);
    }

    /// Whether the lights of the model, if it has any, can be noticed where its first camera looks.
    bool ownLightsReach() const {
        const Scene& scene = out_.scene;
        const KdTree shown = visibleTree(out_.tree, scene);
        const std::vector<SeenPlace> places = seenPlaces(shown, scene.model.mesh, out_.camera);
        return scene.lights.empty() || places.empty() ||
               lightReaches(shown, scene.model.mesh, lightsOf(scene.lights), places, kPlainAmbient);
    }

    /// Beside the lights of the model, which light nothing that is seen. The sun becomes a light like the
    /// others: files put that of a sky behind all, where it has other samples and gives other images.
    void lightBeside(Look look) {
        Scene& scene = out_.scene;
        const std::vector<SceneLight> own = std::exchange(scene.lights, {});
        lightByLook(look);
        for (SceneLight& each : scene.lights) each.ofSky = false;
        scene.lights.insert(scene.lights.end(), own.begin(), own.end());
        warn({"its own lights reach nothing that is seen; other light was added"});
    }

    /// What no light reaches is seen by one beside the viewer.
    void lightTheDark() {
        Scene& scene = out_.scene;
        if (out_.sceneFile || out_.look == Look::Headlight || options_.surroundings.look || shines()) return;
        const Mesh& mesh = scene.model.mesh;
        const KdTree shown = visibleTree(out_.tree, scene);
        const std::vector<SeenPlace> places = seenPlaces(shown, mesh, out_.camera);
        if (places.empty() || isOpen(shown, mesh, places) ||
            lightReaches(shown, mesh, lightsOf(scene.lights), places, kPlainAmbient))
            return;
        addHeadlight(scene, out_.tree.bounds, out_.camera);
        warn({"no light reaches what is seen; one beside the viewer was added"});
    }

    void giveGround() {
        Scene& scene = out_.scene;
        if (!scene.sky || !wantsGround(scene.model.mesh, surveyed())) return;
        Sky sky = *scene.sky;
        sky.ground = true;
        setSky(scene, sky);
    }

    /// An object is not half black by its author's only light, before nothing.
    void fillTheDark() {
        Scene& scene = out_.scene;
        if (out_.indoors || surveyed().inside() || surveyed().isStage() || shines()) return;
        const auto fill = fillLight(scene, visibleTree(out_.tree, scene), out_.camera);
        if (!fill) return;
        scene.background = *fill;
        take({{"skyLight.on", true}});
        warn({"its own lights leave much of what is seen in the dark; a background that lights was added"});
    }

    void giveLight() {
        Scene& scene = out_.scene;
        const Surroundings& surroundings = options_.surroundings;
        bool surrounded = surroundings.environment || scene.sky;
        if (!out_.sceneFile && (!hasLight() || !ownLightsReach())) {
            hideDomes();
            surrounded = surrounded || scene.environment() != nullptr;
            // What is not hidden any more may reach.
            if (hasLight() && !surrounded && !surroundings.look && !ownLightsReach())
                return lightBeside(surroundings.usual);
        }
        if (surroundings.look) return lightByLook(*surroundings.look, true);
        if (hasLight() || (surrounded && out_.sceneFile)) {
            if (!out_.sceneFile) take(exposureOf(surroundings.usual));
            if (surrounded) take({{"skyLight.on", true}});
            if (!surrounded && !out_.sceneFile) fillTheDark();
        } else if (surrounded) {
            giveGround();
            addRoomLights(scene, out_.tree, surveyed());
            take(settingsOf(Look::Sky, surveyed()));
        } else if (out_.sceneFile) {
            addHeadlight(scene, out_.tree.bounds, out_.camera);
            out_.look = Look::Headlight;
        } else {
            lightByLook(surroundings.usual);
        }
    }

    void finish() {
        Scene& scene = out_.scene;
        decideUpAndUnit();
        chooseCamera();
        takeSurroundings();
        giveLight();
        lightTheDark();
        if (!out_.sceneFile) out_.guesses = guessMaterials(scene);
        numberLights(scene);
        scene.closed = findClosedSurfaces(scene.model, scene.materials, out_.openGlass);
        phase(LoadPhase::Done);
    }

    const LoadOptions& options_;
    LoadedScene out_;
    bool hasCamera_ = false;
    std::optional<Sky> described_; ///< by the .scn
    std::optional<Survey> survey_;
};

LookLights lightsOfLook(const LoadedScene& loaded, const Scene& scene) {
    // A sky by date stands wherever its place is.
    const std::optional<Sky> sky = scene.sky && scene.sky->date ? scene.sky : std::nullopt;
    const Mesh& mesh = scene.model.mesh;
    const Survey found = survey(loaded.tree, mesh, axesOf(scene));
    return lookLights(*loaded.look, loaded.tree, mesh, found, loaded.camera, sky);
}

bool isLitByItsLook(const LoadedScene& loaded, const Scene& scene) {
    return loaded.look && isLitBy(scene, lightsOfLook(loaded, scene));
}

/// What is switched off stays so.
void lightAnew(const LoadedScene& loaded, Scene& scene) {
    LookLights look = lightsOfLook(loaded, scene);
    look.background = scene.background;
    look.ambient = scene.ambient;
    const std::vector<SceneLight> before = scene.lights;
    const int environment = scene.activeEnvironment;
    lightBy(scene, look);
    scene.activeEnvironment = environment;
    if (scene.lights.size() != before.size()) return;
    for (std::size_t i = 0; i < before.size(); ++i) scene.lights[i].light.on = before[i].light.on;
}

} // namespace

LoadedScene loadScene(const std::filesystem::path& path, const LoadOptions& options) {
    return Loader(options).load(path);
}

void reframe(LoadedScene& loaded, const UpAndUnit& frame, Scene& scene, Camera& camera) {
    const bool turned = frame.up != scene.up;
    const bool lit = turned && isLitByItsLook(loaded, scene);
    loaded.frame = frame;
    scene.up = frame.up;
    scene.metresPerUnit = frame.metresPerUnit;
    if (!turned) return;
    straightenSky(scene);
    if (loaded.ownCamera) {
        straightenCamera(frame.up, camera);
    } else {
        const Mesh& mesh = scene.model.mesh;
        camera = loaded.camera = defaultCamera(loaded.tree, mesh, survey(loaded.tree, mesh, axesOf(scene)));
    }
    if (lit) lightAnew(loaded, scene);
}

} // namespace rtcore

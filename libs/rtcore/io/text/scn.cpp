#include "rtcore/io/text/scn.h"

#include "rtcore/io/text/camera_section.h"
#include "rtcore/io/text/scn_sections.h"
#include "rtcore/io/text/settings_section.h"
#include "rtcore/io/text/text_file.h"
#include "rtcore/io/text/toml_parser.h"
#include "rtcore/io/text/written_mark.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/pose_choice.h"
#include "rtcore/scene/up_axis.h"
#include "rtcore/settings/plain_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

namespace rtcore {

namespace {

constexpr std::array<std::string_view, 3> kFogKinds{"none", "homogeneous", "exponential"};

constexpr Limits kMetresPerUnit{.minimum = 1e-9, .maximum = 1e9};
constexpr Limits kCreaseAngle{.minimum = 0, .maximum = 180};
constexpr Limits kDeflectionLimits{.minimum = 1e-6F, .maximum = 0.1F};

Fog readFog(StrictTable& table, Vec3 up) {
    const auto kind = table.choice("kind", kFogKinds);
    Fog fog;
    fog.density = table.number("density", kNotNegative).value_or(fog.density);
    fog.scaleHeight = table.number("scaleHeight", kPositive).value_or(fog.scaleHeight);
    fog.groundHeight = table.height("groundHeight", up).value_or(fog.groundHeight);
    fog.colour = table.colour("colour", kNotNegative).value_or(fog.colour);
    fog.albedo = table.colour("albedo", kUnitRange).value_or(fog.albedo);
    fog.surroundings = table.number("surroundings", kNotNegative).value_or(fog.surroundings);
    fog.emission = table.colour("emission", kNotNegative).value_or(fog.emission);
    table.finish();
    fog.kind = static_cast<FogKind>(table.require("kind", kind));
    return fog;
}

WalkParameters readWalk(StrictTable& table) {
    WalkParameters walk;
    walk.height = table.number("height", kPositive).value_or(walk.height);
    walk.speed = table.number("speed", kPositive).value_or(walk.speed);
    walk.jumpHeight = table.number("jumpHeight", kNotNegative).value_or(walk.jumpHeight);
    walk.stepHeight = table.number("stepHeight", kNotNegative).value_or(walk.stepHeight);
    walk.gravity = table.number("gravity", kNotNegative).value_or(walk.gravity);
    table.finish();
    return walk;
}

/// Reads one .scn. What needs several keys is decided when all were read.
class SceneReader {
  public:
    SceneReader(const TextValue& content, const std::filesystem::path& path, const std::string& file,
                const std::optional<LocalOrigin>& zero)
        : root_(content, file), folder_(path.parent_path()), zero_(zero) {}

    SceneFile read() {
        root_.checkVersion(kSceneFileVersion);
        scene_.origin = root_.readOrigin(zero_);
        readRoot();
        readLists();
        readSections();
        root_.finish();
        scene_.model = root_.require("model", model_);
        return std::move(scene_);
    }

  private:
    void readRoot() {
        model_ = root_.path("model", folder_);
        scene_.settings = root_.path("settings", folder_);
        scene_.output = root_.path("output", folder_);
        scene_.metresPerUnit = root_.number("metresPerUnit", kMetresPerUnit).value_or(scene_.metresPerUnit);
        if (const auto axis = root_.choice("up", kAxisNames)) scene_.up = kAxes.at(*axis);
        scene_.background = root_.colour("background", kNotNegative).value_or(scene_.background);
        scene_.ambient = root_.colour("ambient", kNotNegative).value_or(scene_.ambient);
        scene_.creaseAngle = root_.number("creaseAngle", kCreaseAngle).value_or(scene_.creaseAngle);
        scene_.flipTextures = root_.boolean("flipTextures").value_or(false);
        readScenePose();
        readDeflection();
    }

    void readLists() {
        std::set<int> ids;
        for (StrictTable& table : root_.tables("light")) {
            const int id = scene_.lights.emplace_back(readLight(table, folder_)).id;
            if (id > 0 && !ids.insert(id).second) table.fail("id", say("two lights have the id {0}", id));
        }
        for (StrictTable& table : root_.tables("material"))
            scene_.materials.push_back(readMaterial(table, folder_));
        for (StrictTable& table : root_.tables("part")) scene_.parts.push_back(readPart(table));
        root_.needVersion(2, "part");
        scene_.sections = readSectionPlanes(root_);
        for (StrictTable& table : root_.tables("environment"))
            scene_.environments.push_back(readEnvironment(table, folder_));
        scene_.modelLights = root_.boolean("modelLights").value_or(scene_.lights.empty());
        readDefaultLight();
        if (auto table = root_.table("sky")) {
            root_.needVersion(2, "sky");
            scene_.sun.id = table->integer("sunId", 1, kMaxLightId).value_or(0);
            scene_.sun.on = table->boolean("sunOn").value_or(true);
            scene_.sky = readSky(*table);
        }
        readActiveEnvironment();
        scene_.bookmarks = readBookmarks(root_, scene_.up);
        scene_.measures = readMeasures(root_);
        scene_.notes = readNotes(root_, scene_.up);
        scene_.flights = readFlights(root_, scene_.up);
        readAllVariants();
    }

    void readAllVariants() {
        scene_.variants = readVariants(root_, folder_);
        scene_.shown = readShown(root_, folder_);
        scene_.activeVariant = root_.text("activeVariant").value_or("");
        if (scene_.activeVariant.empty()) return;
        root_.needVersion(2, "activeVariant");
        if (findVariant(scene_.variants, scene_.activeVariant) == scene_.variants.end())
            root_.fail("activeVariant",
                       say("there is no [[variant]] {0} in this file", inQuotes(scene_.activeVariant)));
    }

    void readScenePose() {
        const auto text = root_.text("pose");
        if (!text) return;
        root_.needVersion(2, "pose");
        const auto pose = readPose(*text);
        if (!pose)
            root_.fail("pose", say("pose is {0}; it must be \"rest\", \"first\" or the name or number of an "
                                   "animation with @ and seconds behind it",
                                   inQuotes(*text)));
        scene_.pose = *pose;
    }

    void readDeflection() {
        const auto deflection = root_.number("deflection", kDeflectionLimits);
        if (!deflection) return;
        root_.needVersion(2, "deflection");
        scene_.deflection = *deflection;
    }

    void readDefaultLight() {
        const auto light = root_.boolean("defaultLight");
        if (light) root_.needVersion(2, "defaultLight");
        scene_.defaultLight = light.value_or(true);
    }

    void readActiveEnvironment() {
        const auto index =
            root_.integer("activeEnvironment", kNoEnvironment, std::numeric_limits<int>::max());
        const int files = static_cast<int>(scene_.environments.size());
        const int count = files + (scene_.sky ? 1 : 0);
        scene_.activeEnvironment = index.value_or(scene_.sky ? files : 0);
        if (index == kNoEnvironment) root_.needVersion(2, "activeEnvironment");
        if (index && *index >= count)
            root_.fail("activeEnvironment",
                       say("activeEnvironment is {0}, but there are {1} {2}, counted from 0", *index, count,
                           say(scene_.sky ? "with the [sky]" : "[[environment]]")));
    }

    void readSections() {
        if (auto table = root_.table("camera")) readCameraTable(*table);
        if (auto table = root_.table("fog")) scene_.fog = readFog(*table, scene_.up);
        if (auto table = root_.table("walk")) scene_.walk = readWalk(*table);
        scene_.live = readSettingsSection(root_, "live");
        scene_.still = readSettingsSection(root_, "still");
    }

    /// Either the name of a .cam or the camera itself; a misspelt key is reported before a wrong mixture.
    void readCameraTable(StrictTable& table) {
        scene_.cameraFile = table.path("file", folder_);
        if (!scene_.cameraFile) {
            scene_.camera = readCamera(table, scene_.up, true);
            return;
        }
        for (const std::string_view key : kCameraKeys) {
            if (table.value(key) != nullptr)
                table.fail(key, say("{0} and {1} are both given; leave one out", std::string("file"), key));
        }
        table.finish();
    }

    StrictTable root_;
    std::filesystem::path folder_;
    std::optional<LocalOrigin> zero_;
    SceneFile scene_;
    std::optional<std::filesystem::path> model_;
};

/// "" (which the reader refuses) for a vector that is no axis.
class SceneWriter {
  public:
    SceneWriter(const SceneFile& scene, std::filesystem::path folder)
        : scene_(scene), folder_(std::move(folder)) {}

    std::string write() {
        writer_.add("version", kSceneFileVersion);
        writeRoot();
        writeCameraTable();
        for (const LightDescription& light : scene_.lights) writeLight(writer_, light, folder_);
        for (const MaterialOverride& material : scene_.materials) writeMaterial(writer_, material, folder_);
        for (const PartDescription& part : scene_.parts) writePart(writer_, part);
        for (const SectionPlane& plane : scene_.sections.planes) writeSectionPlane(writer_, plane);
        for (const EnvironmentFile& environment : scene_.environments)
            writeEnvironment(writer_, environment, folder_);
        if (scene_.sky) {
            writeSky(writer_, *scene_.sky);
            if (scene_.sun.id != 0) writer_.add("sunId", scene_.sun.id);
            if (!scene_.sun.on) writer_.add("sunOn", false);
        }
        for (const SceneBookmark& bookmark : scene_.bookmarks) writeBookmark(writer_, bookmark);
        for (const KeptMeasure& measure : scene_.measures.all) writeMeasure(writer_, measure);
        for (const SceneNote& note : scene_.notes) writeNote(writer_, note);
        for (const Flight& flight : scene_.flights) writeFlight(writer_, flight);
        for (const SceneVariant& variant : scene_.variants) writeVariant(writer_, variant, folder_);
        if (scene_.shown) writeVariant(writer_, *scene_.shown, folder_);
        writeFog();
        writeWalk();
        writeSettingsSection(writer_, "live", scene_.live);
        writeSettingsSection(writer_, "still", scene_.still);
        return writer_.text();
    }

  private:
    void addPath(std::string_view key, const std::filesystem::path& path) {
        writer_.add(key, pathToUtf8(pathSeenFrom(folder_, path)));
    }

    void writeRoot() {
        addPath("model", scene_.model);
        if (scene_.settings) addPath("settings", *scene_.settings);
        if (scene_.output) addPath("output", *scene_.output);
        writer_.add("metresPerUnit", scene_.metresPerUnit);
        writer_.add("origin", scene_.origin);
        writer_.add("up", axisName(scene_.up));
        writer_.add("background", scene_.background);
        writer_.add("ambient", scene_.ambient);
        writer_.add("modelLights", scene_.modelLights);
        if (!scene_.defaultLight) writer_.add("defaultLight", false);
        if (!scene_.environments.empty() || scene_.sky)
            writer_.add("activeEnvironment", scene_.activeEnvironment);
        if (!scene_.activeVariant.empty()) writer_.add("activeVariant", scene_.activeVariant);
        writer_.add("creaseAngle", scene_.creaseAngle);
        writer_.add("flipTextures", scene_.flipTextures);
        if (scene_.pose != PoseChoice{}) writer_.add("pose", poseText(scene_.pose));
        writeSectionStyle(writer_, scene_.sections);
        writeMeasureStyle(writer_, scene_.measures);
        if (scene_.deflection != SceneFile{}.deflection) writer_.add("deflection", scene_.deflection);
    }

    void writeCameraTable() {
        if (!scene_.camera && !scene_.cameraFile) return;
        writer_.section("[camera]");
        if (scene_.cameraFile) addPath("file", *scene_.cameraFile);
        if (scene_.camera) writeCamera(writer_, *scene_.camera);
    }

    void writeFog() {
        const Fog& fog = scene_.fog;
        writer_.section("[fog]");
        writer_.add("kind", kFogKinds.at(static_cast<std::size_t>(fog.kind)));
        writer_.add("density", fog.density);
        writer_.add("scaleHeight", fog.scaleHeight);
        writer_.add("groundHeight", fog.groundHeight);
        writer_.add("colour", fog.colour);
        writer_.add("albedo", fog.albedo);
        writer_.add("surroundings", fog.surroundings);
        writer_.add("emission", fog.emission);
    }

    void writeWalk() {
        const WalkParameters& walk = scene_.walk;
        writer_.section("[walk]");
        writer_.add("height", walk.height);
        writer_.add("speed", walk.speed);
        writer_.add("jumpHeight", walk.jumpHeight);
        writer_.add("stepHeight", walk.stepHeight);
        writer_.add("gravity", walk.gravity);
    }

    const SceneFile& scene_;
    std::filesystem::path folder_;
    TomlWriter writer_;
};

} // namespace

SceneFile parseSceneFile(std::string_view text, const std::filesystem::path& path,
                         const std::optional<LocalOrigin>& zero) {
    const std::string name = path.string();
    const TextValue content = parseToml(text, name);
    return SceneReader(content, path, name, zero).read();
}

SceneFile readSceneFile(const std::filesystem::path& path, const std::optional<LocalOrigin>& zero) {
    return parseSceneFile(readShortText(path), path, zero);
}

std::string formatSceneFile(const SceneFile& scene, const std::filesystem::path& path) {
    return withWrittenMark(SceneWriter(scene, path.parent_path()).write());
}

void writeSceneFile(const std::filesystem::path& path, const SceneFile& scene) {
    writeCheckedText(path, formatSceneFile(scene, path),
                     [&](std::string_view text) { parseSceneFile(text, path); });
}

} // namespace rtcore

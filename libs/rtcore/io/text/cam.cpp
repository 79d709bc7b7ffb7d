#include "rtcore/io/text/cam.h"

#include "rtcore/io/text/camera_section.h"
#include "rtcore/io/text/text_file.h"
#include "rtcore/io/text/toml_parser.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/scene_light.h"
#include "rtcore/settings/settings_table.h"

#include <fmt/core.h>

#include <set>

namespace rtcore {

namespace {

constexpr int kMaxEnvironment = 65535;
constexpr int kByIds = 2; ///< the version that names lights by their ids

/// A key of a .cam with the range of the setting `name`.
std::optional<int> readInteger(StrictTable& table, std::string_view key, std::string_view name) {
    const Setting& setting = requireSetting(name);
    return table.integer(key, static_cast<int>(setting.minimum), static_cast<int>(setting.maximum));
}

void readLightIds(StrictTable& root, CameraFile& file) {
    const auto read = [&](std::string_view key) {
        const auto ids = root.integers(key, 1, kMaxLightId);
        if (ids) root.needVersion(kByIds, key);
        if (ids && file.lights) root.fail(key, say("{0} and {1} are both given", std::string("lights"), key));
        return ids.value_or(std::vector<int>());
    };
    file.lightsOn = read("lightsOn");
    file.lightsOff = read("lightsOff");
    std::set<int> named;
    for (const int id : file.lightsOn) {
        if (!named.insert(id).second) root.fail("lightsOn", say("light {0} is named twice", id));
    }
    for (const int id : file.lightsOff) {
        if (!named.insert(id).second) root.fail("lightsOff", say("light {0} is named twice", id));
    }
}

} // namespace

CameraFile parseCameraFile(std::string_view text, const std::filesystem::path& path,
                           const std::optional<LocalOrigin>& zero) {
    const std::string name = path.string();
    const TextValue content = parseToml(text, name);
    StrictTable root(content, name);
    root.checkVersion(kByIds);
    const Setting& exposure = requireSetting("exposure.value");
    CameraFile file;
    file.origin = root.readOrigin(zero);
    file.width = readInteger(root, "width", "width");
    file.height = readInteger(root, "height", "height");
    file.antialiasing = readInteger(root, "antialiasing", "antialiasing");
    file.bloom = readInteger(root, "bloom", "bloom.radius");
    file.exposure = root.number("exposure", {.minimum = exposure.minimum, .maximum = exposure.maximum});
    file.lights = root.booleans("lights");
    readLightIds(root, file);
    file.environment = root.integer("environment", 0, kMaxEnvironment);
    file.time = root.preciseNumber("time", kNotNegative);
    file.camera = readCamera(root, Vec3{0, 1, 0}, false);
    return file;
}

CameraFile readCameraFile(const std::filesystem::path& path, const std::optional<LocalOrigin>& zero) {
    return parseCameraFile(readShortText(path), path, zero);
}

std::string formatCameraFile(const CameraFile& file) {
    TomlWriter writer;
    const bool byIds = !file.lightsOn.empty() || !file.lightsOff.empty();
    writer.add("version", byIds ? kByIds : 1);
    writer.add("origin", file.origin);
    writeCamera(writer, file.camera);
    writer.add("width", file.width);
    writer.add("height", file.height);
    writer.add("antialiasing", file.antialiasing);
    writer.add("bloom", file.bloom);
    writer.add("exposure", file.exposure);
    writer.add("lights", file.lights);
    if (byIds) {
        writer.add("lightsOn", file.lightsOn);
        writer.add("lightsOff", file.lightsOff);
    }
    writer.add("environment", file.environment);
    writer.add("time", file.time);
    return writer.text();
}

std::string formatCameraInFile(const Camera& camera, const LocalOrigin& zero) {
    TomlWriter writer;
    writer.add("version", 1);
    writeCamera(writer, camera, zero);
    return writer.text();
}

void writeCameraFile(const std::filesystem::path& path, const CameraFile& file) {
    writeCheckedText(path, formatCameraFile(file),
                     [&](std::string_view text) { parseCameraFile(text, path); });
}

} // namespace rtcore

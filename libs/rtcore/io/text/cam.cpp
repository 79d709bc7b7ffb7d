#include "rtcore/io/text/cam.h"

#include "rtcore/io/text/camera_section.h"
#include "rtcore/io/text/text_file.h"
#include "rtcore/io/text/toml_parser.h"
#include "rtcore/settings/settings_table.h"

namespace rtcore {

namespace {

constexpr int kMaxEnvironment = 65535;

/// A key of a .cam with the range of the setting `name`.
std::optional<int> readInteger(StrictTable& table, std::string_view key, std::string_view name) {
    const Setting& setting = requireSetting(name);
    return table.integer(key, static_cast<int>(setting.minimum), static_cast<int>(setting.maximum));
}

} // namespace

CameraFile parseCameraFile(std::string_view text, const std::filesystem::path& path) {
    const std::string name = path.string();
    const TextValue content = parseToml(text, name);
    StrictTable root(content, name);
    root.checkVersion();
    const Setting& exposure = requireSetting("exposure.value");
    CameraFile file;
    file.width = readInteger(root, "width", "width");
    file.height = readInteger(root, "height", "height");
    file.antialiasing = readInteger(root, "antialiasing", "antialiasing");
    file.bloom = readInteger(root, "bloom", "bloom.radius");
    file.exposure = root.number("exposure", {.minimum = exposure.minimum, .maximum = exposure.maximum});
    file.lights = root.booleans("lights");
    file.environment = root.integer("environment", 0, kMaxEnvironment);
    file.time = root.preciseNumber("time", kNotNegative);
    file.camera = readCamera(root, Vec3{0, 1, 0}, false);
    return file;
}

CameraFile readCameraFile(const std::filesystem::path& path) {
    return parseCameraFile(readShortText(path), path);
}

std::string formatCameraFile(const CameraFile& file) {
    TomlWriter writer;
    writer.add("version", 1);
    writeCamera(writer, file.camera);
    writer.add("width", file.width);
    writer.add("height", file.height);
    writer.add("antialiasing", file.antialiasing);
    writer.add("bloom", file.bloom);
    writer.add("exposure", file.exposure);
    writer.add("lights", file.lights);
    writer.add("environment", file.environment);
    writer.add("time", file.time);
    return writer.text();
}

void writeCameraFile(const std::filesystem::path& path, const CameraFile& file) {
    writeCheckedText(path, formatCameraFile(file),
                     [&](std::string_view text) { parseCameraFile(text, path); });
}

} // namespace rtcore

#include "rtcore/io/text/set.h"

#include "rtcore/io/text/settings_section.h"
#include "rtcore/io/text/text_file.h"
#include "rtcore/io/text/toml_parser.h"

namespace rtcore {

SettingsFile parseSettingsFile(std::string_view text, const std::filesystem::path& path) {
    const std::string name = path.string();
    const TextValue content = parseToml(text, name);
    StrictTable root(content, name);
    root.checkVersion();
    SettingsFile file;
    file.live = readSettingsSection(root, "live");
    file.still = readSettingsSection(root, "still");
    root.finish();
    return file;
}

SettingsFile readSettingsFile(const std::filesystem::path& path) {
    return parseSettingsFile(readShortText(path), path);
}

std::string formatSettingsFile(const SettingsFile& file) {
    TomlWriter writer;
    writer.add("version", 1);
    writeSettingsSection(writer, "live", file.live);
    writeSettingsSection(writer, "still", file.still);
    return writer.text();
}

void writeSettingsFile(const std::filesystem::path& path, const SettingsFile& file) {
    writeCheckedText(path, formatSettingsFile(file),
                     [&](std::string_view text) { parseSettingsFile(text, path); });
}

} // namespace rtcore

#include "common/settings/lighting_options.h"

#include "rtcore/io/text/scn_sections.h"
#include "rtcore/io/text/strict_table.h"
#include "rtcore/io/text/toml_parser.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <string>

namespace app {

namespace {

const std::string kPlace = "--sky"; // in errors of the reader

/// One line of the table.
std::string lineOf(std::string_view part) {
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos) return "hour = " + std::string(part) + "\n";
    const std::string key(part.substr(0, equals));
    std::string value(part.substr(equals + 1));
    if (key == "date") value = '"' + value + '"';
    if (key == "direction") {
        std::replace(value.begin(), value.end(), '/', ',');
        value = '[' + value + ']';
    }
    return key + " = " + value + "\n";
}

/// In the words of a [sky]. Nothing but keys and numbers reaches the parser.
std::string tableOf(std::string_view text) {
    constexpr std::string_view kLetters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789=+-.,/";
    if (text.find_first_not_of(kLetters) != std::string_view::npos) throw UsageError("");
    std::string table;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        table += lineOf(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return table;
}

/// The keys and values in `text`. An error of the parser becomes a UsageError without its words.
rtcore::TextValue contentOf(std::string_view text) {
    try {
        return rtcore::parseToml(tableOf(text), kPlace);
    } catch (const rtcore::FileError&) {
        throw UsageError("");
    }
}

} // namespace

rtcore::Sky readSkyOption(std::string_view text) {
    std::string reason;
    try {
        const rtcore::TextValue content = contentOf(text);
        rtcore::StrictTable table(content, kPlace);
        return rtcore::readSky(table, {.haze = true});
    } catch (const rtcore::FileError& error) {
        reason = error.what();
        const std::size_t message = reason.find(": "); // behind the place
        if (message != std::string::npos) reason.erase(0, message + 2);
    } catch (const UsageError&) {
        reason = "it takes an hour, or keys and values such as hour=17,latitude=48.2";
    }
    throw UsageError("option '--sky': '" + std::string(text) + "': " + reason);
}

rtcore::LightingOptions readLightingOptions(const Arguments& arguments) {
    rtcore::LightingOptions lighting;
    lighting.usual = rtcore::LightingPreset::Sky;
    if (arguments.has("sky") && arguments.has("environment"))
        throw UsageError("--sky and --environment exclude each other");
    if (const auto look = arguments.text("look")) {
        lighting.preset = rtcore::lightingPresetNamed(*look);
        if (arguments.has("environment")) throw UsageError("--look and --environment exclude each other");
        if (arguments.has("sky") && lighting.preset != rtcore::LightingPreset::Sky)
            throw UsageError("--sky and --look=" + *look + " exclude each other");
    }
    if (const auto file = arguments.text("environment"))
        lighting.environment = std::filesystem::absolute(*file);
    if (const auto sky = arguments.text("sky")) lighting.sky = readSkyOption(*sky);
    return lighting;
}

} // namespace app

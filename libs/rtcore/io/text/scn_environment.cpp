#include "rtcore/io/text/scn_sections.h"
#include "rtcore/io/text/text_file.h"
#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <array>

namespace rtcore {

namespace {

/// In the order of EnvironmentKind.
constexpr std::array<std::string_view, 3> kSingleFileKeys{"equirectangular", "cross", "strip"};
constexpr std::size_t kFaces = 6;
constexpr Limits kRotation{.minimum = -360, .maximum = 360};

} // namespace

EnvironmentFile readEnvironment(StrictTable& table, const std::filesystem::path& folder) {
    EnvironmentFile environment;
    environment.name = table.text("name").value_or("");
    environment.intensity = table.number("intensity", kNotNegative).value_or(1.0F);
    if (const auto rotation = table.number("rotation", kRotation)) {
        table.needVersion(2, "rotation");
        environment.rotation = *rotation;
    }
    int given = 0;
    for (std::size_t i = 0; i < kSingleFileKeys.size(); ++i) {
        const auto file = table.path(kSingleFileKeys[i], folder);
        if (!file) continue;
        environment.kind = static_cast<EnvironmentKind>(i);
        environment.files = {*file};
        ++given;
    }
    if (const auto faces = table.paths("faces", folder)) {
        environment.kind = EnvironmentKind::Faces;
        environment.files = *faces;
        ++given;
        if (faces->size() != kFaces)
            table.fail("faces",
                       say("faces has {0} files, but takes six: +x, -x, +y, -y, +z, -z", faces->size()));
    }
    if (const auto parts = table.texts("parts")) {
        table.needVersion(2, "parts");
        environment.kind = EnvironmentKind::Parts;
        environment.parts = *parts;
        ++given;
        if (parts->empty()) table.fail("parts", say("parts names no part; give at least one"));
    }
    table.finish();
    if (given != 1)
        table.fail(
            "",
            say("an environment has exactly one of the keys equirectangular, cross, strip, faces and parts"));
    return environment;
}

void writeEnvironment(TomlWriter& writer, const EnvironmentFile& environment,
                      const std::filesystem::path& folder) {
    std::vector<std::string> files;
    for (const std::filesystem::path& file : environment.files)
        files.push_back(pathToUtf8(pathSeenFrom(folder, file)));
    writer.section("[[environment]]");
    if (!environment.name.empty()) writer.add("name", environment.name);
    if (environment.kind == EnvironmentKind::Faces) {
        writer.add("faces", files);
    } else if (environment.kind == EnvironmentKind::Parts) {
        writer.add("parts", environment.parts);
    } else if (!files.empty()) {
        writer.add(kSingleFileKeys.at(static_cast<std::size_t>(environment.kind)), files.front());
    }
    writer.add("intensity", environment.intensity);
    writer.add("rotation", environment.rotation);
}

} // namespace rtcore

#include "rtserver/document/packed_model.h"

#include "rtcore/io/bsp/bsp_checksum.h"
#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/import/model_import.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/paths.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>

namespace rtserver {

namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

rtcore::ImportedModel import(const fs::path& model, const PackProgress& progress) {
    rtcore::ImportOptions options;
    options.stop = &progress.stop;
    return rtcore::importModel(model, options);
}

bool hasBspHead(const fs::path& path) {
    constexpr std::size_t kHead = 8;
    return rtcore::isBsp(rtcore::InputFile(path).head(kHead));
}

/// The folder that all are in or below.
fs::path commonFolder(const Paths& files) {
    fs::path common = files.front().parent_path();
    for (const fs::path& file : files) {
        const auto ends = std::mismatch(common.begin(), common.end(), file.begin(), file.end());
        fs::path shared;
        for (auto part = common.begin(); part != ends.first; ++part) shared /= *part;
        common = shared;
    }
    return common;
}

/// Equal for models of which each bit is the same.
std::uint32_t digestOf(const rtcore::Model& model) {
    std::uint32_t crc = 0;
    const auto add = [&crc](const auto&... spans) {
        ((crc = rtcore::crc32Of(std::as_bytes(spans), crc)), ...);
    };
    const rtcore::Mesh& mesh = model.mesh;
    add(mesh.vertices, mesh.triangles, mesh.shading, mesh.normals, mesh.texcoords, mesh.colours);
    add(model.materials, model.textures, model.texels, model.blocks, model.lights, model.cameras, model.parts,
        model.strings);
    return crc;
}

/// Whether the packed model is read from the pack alone.
void checkFound(const fs::path& model, const fs::path& root, const std::set<fs::path>& found,
                const std::set<fs::path>& expected) {
    const auto refuse = [&](const rtcore::Sentence& why) {
        throw rtcore::FileError(rtcore::FailureKind::BadData, model.filename().string(), why);
    };
    for (const fs::path& file : found) {
        const fs::path seen = file.lexically_relative(root);
        if (seen.empty() || *seen.begin() == "..")
            refuse(rtcore::say(
                "names {0} by its absolute path, which no copy of the model would find; export it "
                "with relative ones, or make a .bsp of it by BSPBuilder and pack that",
                file.string()));
    }
    for (const fs::path& file : expected) {
        if (found.count(file) == 0)
            refuse(rtcore::say("its copy does not find {0}; make a .bsp of it by BSPBuilder and pack that",
                               file.lexically_relative(root).string()));
    }
}

/// Each companion of the packed model in turn is taken away: it stays away where the model is the same
/// without it. Images were decoded, which says enough.
void leaveOutUnused(const fs::path& model, const rtcore::ImportedModel& whole, PackedFiles& pack) {
    const std::set<fs::path> images(whole.report.images.begin(), whole.report.images.end());
    const std::uint32_t digest = digestOf(whole.model);
    const auto isSame = [&] {
        try {
            return digestOf(import(model, pack.progress()).model) == digest;
        } catch (const rtcore::FileError& error) {
            if (error.kind == rtcore::FailureKind::Stopped) throw;
            return false;
        }
    };
    for (const std::string& name : whole.report.files) {
        const fs::path file(name), aside = pack.root().parent_path() / "aside";
        if (file == model || images.count(file) != 0) continue;
        fs::rename(file, aside);
        const bool unused = isSame();
        fs::rename(aside, file);
        if (unused) pack.leaveOut(file);
    }
}

} // namespace

Paths companionsOf(const fs::path& model, const PackProgress& progress) {
    if (hasBspHead(model)) return {};
    const std::vector<std::string> files = import(model, progress).report.files;
    return {files.begin(), files.end()};
}

fs::path packModel(const fs::path& model, const Paths& companions, PackedFiles& pack) {
    const fs::path source = rtcore::plainPath(model), folder = pack.root() / "model";
    Paths names{source.lexically_normal()};
    for (const fs::path& file : companions) names.push_back(file.lexically_normal());
    const fs::path from = commonFolder(names);
    const auto place = [&](const fs::path& file) {
        return folder / file.lexically_normal().lexically_relative(from);
    };
    const fs::path packed = pack.copy(source, place(source));
    std::set<fs::path> expected{packed};
    for (const fs::path& file : companions) expected.insert(pack.copy(file, place(file)));
    throwIfStopped(pack.progress());
    std::uint64_t bytes = 0;
    for (const fs::path& file : expected) bytes += fs::file_size(file);
    if (hasBspHead(packed)) {
        (void)rtcore::readBsp(packed);
    } else {
        const rtcore::ImportedModel whole = import(packed, pack.progress());
        std::set<fs::path> found(whole.report.files.begin(), whole.report.files.end());
        found.insert(packed);
        checkFound(model, folder, found, expected);
        leaveOutUnused(packed, whole, pack);
    }
    pack.progress().done += bytes;
    return packed;
}

} // namespace rtserver

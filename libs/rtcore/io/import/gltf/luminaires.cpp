#include "rtcore/io/import/gltf/luminaires.h"

#include "rtcore/io/import/gltf/data_uri.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/materials/texture_files.h"
#include "rtcore/io/photometry/luminaire.h"
#include "rtcore/io/photometry/photometric_file.h"
#include "rtcore/io/photometry/web_symmetry.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/paths.h"
#include "rtcore/scene/model_photometry.h"

#include <span>
#include <vector>

namespace rtcore::gltf {

namespace {

std::string quoted(const std::string& name) { return "'" + name + "'"; }

/// Its own, that of its file, or its number.
std::string nameOf(const Json& stated, std::size_t number) {
    const std::string name = text(stated, "name"), uri = text(stated, "uri");
    if (!name.empty()) return name;
    if (!uri.empty() && !isDataUri(uri)) return percentDecoded(uri);
    return "lights[" + std::to_string(number) + "]";
}

std::string asText(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

[[noreturn]] void refuseLargeProfile() { throw Refusal(say("it is larger than 4 MB")); }

} // namespace

Luminaires::Luminaires(const Json& root, Views& views, const std::filesystem::path& model,
                       ImportReport& report)
    : root_(root), views_(views), folder_(model.parent_path()), home_(model), report_(report) {}

std::optional<Luminaire> Luminaires::find(std::size_t number, bool mirrored) {
    const auto known = found_.find({number, mirrored});
    if (known != found_.end()) return known->second;
    const Json& stated = element(member(extension(root_, "EXT_lights_ies"), "lights"), number);
    const std::string name = nameOf(stated, number);
    std::optional<Luminaire> found;
    try {
        const PhotometricWeb web = read(stated, name);
        found = keep(mirrored ? mirroredWeb(web) : web);
    } catch (const Worded& error) {
        addWarning(report_, say(import_forms::kPlainLuminaires, quoted(name), error.sentence()));
    }
    found_.emplace(std::pair(number, mirrored), found);
    return found;
}

PhotometricWeb Luminaires::read(const Json& stated, const std::string& name) {
    PhotometricFile file = parseIes(textOf(stated), name);
    for (const Sentence& warning : file.warnings)
        addWarning(report_, say(import_forms::kOf, quoted(name), warning));
    return std::move(file.web);
}

std::string Luminaires::textOf(const Json& stated) {
    const std::string uri = text(stated, "uri");
    if (isDataUri(uri)) {
        const std::vector<std::byte> bytes = bytesOfDataUri(uri);
        if (bytes.size() > kMaxPhotometricBytes) refuseLargeProfile();
        return asText(bytes);
    }
    if (!uri.empty()) return textOfFile(uri);
    const auto view = index(stated, "bufferView");
    const std::uint64_t size = view ? views_.size(*view) : 0;
    if (size == 0) throw Refusal(say("its data are damaged or missing"));
    if (size > kMaxPhotometricBytes) refuseLargeProfile();
    return asText(views_.bytes(*view));
}

std::string Luminaires::textOfFile(const std::string& uri) {
    const auto path = findTextureFile(folder_, uri);
    if (!path) throw Refusal(say("its file is missing; put it beside the model"));
    if (!home_.holds(*path))
        throw Refusal(
            say("its file is not read, as it lies outside of the model's folder; put it beside the model"));
    if (InputFile(*path).size() > kMaxPhotometricBytes) refuseLargeProfile();
    addFile(report_, plainPath(*path).string());
    return readTextFile(*path, kMaxPhotometricBytes);
}

/// As bright as lights of scenes are by the same file.
Luminaire Luminaires::keep(const PhotometricWeb& web) {
    if (!isSoundWeb(web)) throw Refusal(say("its data are damaged or missing"));
    const std::size_t numbers = numbersOf(web).size();
    if (numbers_ + numbers > kMaxModelWebNumbers || found_.size() >= kMaxModelPhotometries)
        throw Refusal(say("the model has more profiles than are kept, {0} or {1} numbers in all",
                          kMaxModelPhotometries, kMaxModelWebNumbers));
    LightDescription light;
    light.light.kind = LightKind::Ies;
    light.lumens = 0.0F;
    shineBy(web, 1, light);
    numbers_ += numbers;
    return {light.light.photometry, light.light.intensity.r};
}

} // namespace rtcore::gltf

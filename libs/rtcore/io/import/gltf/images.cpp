#include "rtcore/io/import/gltf/images.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/io/import/gltf/data_uri.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace rtcore::gltf {

namespace {

/// In the order in which they are tried where a texture has no image of a format that all read.
constexpr std::array<const char*, 2> kFurtherFormats{"EXT_texture_webp", "MSFT_texture_dds"};

bool isInside(const Json& image) { return text(image, "uri").empty() || isDataUri(text(image, "uri")); }

TextureWrap wrapOf(const Json& sampler, const char* name) {
    constexpr std::uint64_t kClamp = 33071, kMirror = 33648; // of OpenGL
    const std::uint64_t mode = wholeNumber(sampler, name, 0);
    return mode == kClamp    ? TextureWrap::ClampToEdge
           : mode == kMirror ? TextureWrap::MirroredRepeat
                             : TextureWrap::Repeat;
}

std::optional<std::size_t> imageOf(const Json& texture) {
    if (const auto source = index(texture, "source")) return source;
    for (const char* const name : kFurtherFormats)
        if (const auto source = index(extension(texture, name), "source")) return source;
    return std::nullopt;
}

} // namespace

Images::Images(const Json& root, Views& views) : root_(root), views_(views) {
    const Json& images = member(root, "images");
    std::set<std::string> files;
    for (const Json& image : images)
        if (!isInside(image)) files.insert(text(image, "uri"));
    for (std::size_t i = 0; i < gltf::sizeOf(images); ++i) {
        if (!isInside(images[i])) continue;
        std::string name = text(images[i], "name");
        if (name.empty() || files.contains(name) || numbers_.contains(name))
            name = "images[" + std::to_string(i) + "]";
        numbers_.emplace(name, i);
        names_.emplace(i, name);
    }
}

LdrImage Images::decode(const std::string& name) const {
    const Json& image = element(member(root_, "images"), numbers_.at(name));
    const std::string uri = text(image, "uri");
    const auto view = index(image, "bufferView");
    const std::vector<std::byte> bytes = !uri.empty() ? bytesOfDataUri(uri)
                                         : view       ? views_.bytes(*view)
                                                      : std::vector<std::byte>();
    if (bytes.empty()) throw FileError(FailureKind::BadData, name, "the image inside the model is empty");
    return decodeLdrImage(bytes, name);
}

SourceMap Images::mapOf(const Json& use) const {
    const Json& texture = element(member(root_, "textures"), index(use, "index"));
    const auto image = imageOf(texture);
    if (!image) return {};
    const auto inside = names_.find(*image);
    SourceMap map;
    map.name = inside != names_.end() ? inside->second : text(element(member(root_, "images"), image), "uri");
    constexpr std::uint64_t kNearest = 9728; // of OpenGL
    const Json& sampler = element(member(root_, "samplers"), index(texture, "sampler"));
    map.wrapU = wrapOf(sampler, "wrapS");
    map.wrapV = wrapOf(sampler, "wrapT");
    if (wholeNumber(sampler, "magFilter", 0) == kNearest) map.filter = TextureFilter::Nearest;
    return map;
}

bool needsImagesOf(const Json& root, const std::string& name) {
    const Json& textures = member(root, "textures");
    return std::any_of(textures.begin(), textures.end(), [&](const Json& texture) {
        return !imageOf(texture) && !extension(texture, name.c_str()).is_null();
    });
}

} // namespace rtcore::gltf

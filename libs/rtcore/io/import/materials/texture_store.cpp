#include "rtcore/io/import/materials/texture_store.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/materials/image_storage.h"
#include "rtcore/io/import/materials/relief.h"
#include "rtcore/io/import/materials/texture_files.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/paths.h"
#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace rtcore {

TextureStore::TextureStore(ModelBuffers& model, ImportReport& report, std::filesystem::path folder,
                           const EmbeddedPictures& embedded, std::function<void()> alive)
    : model_(model), report_(report), folder_(std::move(folder)), embedded_(embedded),
      alive_(std::move(alive)) {}

std::uint32_t TextureStore::texture(const SourceMap& map) {
    if (map.empty()) return kNoTexture;
    Picture& picture = lookUp(map.name, true);
    return picture.stored.width == 0 ? kNoTexture : used(picture, map);
}

std::optional<ImageSummary> TextureStore::summary(const SourceMap& map) {
    return map.empty() ? std::nullopt : lookUp(map.name, false).summary;
}

const std::string& TextureStore::keyOf(const std::string& name) {
    const auto [entry, isNew] = keys_.try_emplace(name);
    if (!isNew) return entry->second;
    if (embedded_.has(name)) {
        entry->second = "<" + name; // no path begins like this: they are made absolute below
    } else if (const auto path = findTextureFile(folder_, name)) {
        entry->second = plainPath(*path).string();
    } else {
        missing_.push_back(name);
    }
    return entry->second;
}

TextureStore::Picture& TextureStore::lookUp(const std::string& name, bool keep) {
    const std::string& key = keyOf(name);
    Picture& picture = pictures_[key];
    const bool complete = picture.summary && (!keep || picture.stored.width != 0);
    if (key.empty() || complete || !load(name, key, picture)) return picture;
    if (!picture.summary) picture.summary = summarise(last_.pixels);
    if (keep) picture.stored = stored(last_);
    return picture;
}

/// Makes it the image read last.
bool TextureStore::load(const std::string& name, const std::string& key, Picture& picture) {
    if (picture.unreadable) return false;
    if (lastKey_ == key) return true;
    last_ = {}; // two large images at once would need twice the memory
    lastKey_.clear();
    auto image = read(name, key);
    picture.unreadable = !image;
    if (!image) return false;
    last_ = std::move(*image);
    lastKey_ = key;
    return true;
}

Relief TextureStore::relief(const SourceMap& map, float scale) {
    if (!summary(map)) return {};
    const std::string key = keyOf(map.name);
    const std::string use =
        fmt::format("{} {} {} {}", static_cast<int>(map.wrapU), static_cast<int>(map.wrapV), scale, key);
    KnownRelief& known = reliefs_[use];
    if (known.picture.stored.width == 0 && !known.isNormals) {
        if (!load(map.name, key, pictures_[key])) return {};
        known.isNormals = holdsNormals(last_);
        if (!known.isNormals) {
            const NormalImage normals = normalsOfHeights(last_, {map.wrapU, map.wrapV, scale});
            known.picture.stored = stored(normals.image);
            known.scale = normals.scale;
        }
    }
    if (known.isNormals) return {texture(map), scale};
    return {used(known.picture, map), known.scale};
}

std::optional<LdrImage> TextureStore::read(const std::string& name, const std::string& key) {
    alive_();
    try {
        const bool embedded = key[0] == '<';
        if (!embedded) addFile(report_, key);
        LdrImage image = embedded ? embedded_.decode(name) : readLdrImage(key);
        if (!image.empty() && !embedded) addImage(report_, key);
        if (!image.empty()) return image;
        addWarning(report_, say(import_forms::kEmptyTexture, "'" + name + "'"));
    } catch (const FileError& error) {
        addWarning(report_, say(import_forms::kBadTexture, error.sentence()));
    }
    return {};
}

/// Making blocks of a large image takes as long as reading it.
Texture TextureStore::stored(const LdrImage& image) {
    alive_();
    return storeImage(image, model_);
}

std::uint32_t TextureStore::used(Picture& picture, const SourceMap& map) {
    Texture texture = picture.stored;
    texture.wrapU = map.wrapU;
    texture.wrapV = map.wrapV;
    texture.filter = map.filter;
    texture.texcoordSet = map.texcoordSet;
    for (const std::uint32_t number : picture.textures) {
        if (model_.textures[number] == texture) return number;
    }
    picture.textures.push_back(static_cast<std::uint32_t>(model_.textures.size()));
    model_.textures.push_back(texture);
    return picture.textures.back();
}

} // namespace rtcore

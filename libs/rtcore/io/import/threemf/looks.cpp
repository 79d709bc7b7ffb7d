#include "rtcore/io/import/threemf/looks.h"

#include "rtcore/io/import/threemf/paints.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace rtcore::threemf {

namespace {

SourceMaterial plainMaterial(Colour colour) {
    SourceMaterial source;
    source.diffuse = colour;
    source.indexByHabit = true;
    return source;
}

const Display* displayOf(const PartContent& part, const PropertyGroup& group, std::uint32_t entry) {
    const auto at = part.displays.find(group.display);
    return at != part.displays.end() && entry < at->second.size() ? &at->second[entry] : nullptr;
}

SourceMaterial materialOf(const PartContent& part, const PropertyGroup& group, std::uint32_t entry) {
    SourceMaterial source = plainMaterial(group.paints[entry].colour);
    source.opacity = group.paints[entry].alpha;
    source.name = group.names[entry];
    const Display* const display = displayOf(part, group, entry);
    if (display == nullptr) return source;
    source.rules = display->metallic ? MaterialRules::MetallicRoughness : MaterialRules::SpecularGlossiness;
    source.alphaMode = AlphaMode::Blend;
    source.metallic = display->metal;
    source.roughness = display->roughness;
    source.specular = display->specular;
    source.glossiness = display->glossiness;
    return source;
}

std::uint64_t codeOf(const Paint& paint) {
    const auto part = [](float v) {
        return static_cast<std::uint64_t>(std::lround(std::clamp(v, 0.0F, 1.0F) * 255));
    };
    return part(srgbEncode(paint.colour.r)) << 24U | part(srgbEncode(paint.colour.g)) << 16U |
           part(srgbEncode(paint.colour.b)) << 8U | part(paint.alpha);
}

SourceMaterial imageMaterial(const TextureSource& texture, const std::string& name,
                             const std::string& image) {
    SourceMaterial source = plainMaterial(kWhite);
    source.name = name;
    source.diffuseMap = {image, texture.wrapU, texture.wrapV, texture.filter};
    source.alphaInDiffuseMap = true;
    source.mapReplacesDiffuse = true;
    source.alphaMode = AlphaMode::Blend;
    return source;
}

} // namespace

std::uint32_t Looks::add(SourceMaterial source, Look look) {
    Material material = mapMaterial(source, textures_);
    material.nameOffset = import_.model.addName(source.name);
    look.material = static_cast<std::uint32_t>(import_.model.materials.size());
    look.name = source.name;
    import_.model.materials.push_back(material);
    looks_.push_back(std::move(look));
    return static_cast<std::uint32_t>(looks_.size() - 1);
}

template <typename Make>
std::uint32_t Looks::numberOf(const Key& key, const Make& make) {
    if (last_.second != kNoNumber && last_.first == key) return last_.second;
    auto at = numbers_.find(key);
    if (at == numbers_.end()) at = numbers_.emplace(key, make()).first;
    last_ = *at;
    return at->second;
}

Surface Looks::plain() {
    Surface surface;
    surface.look = numberOf({}, [&] { return add(plainMaterial(kUnsetDiffuse), {}); });
    return surface;
}

Surface Looks::unknown() {
    Surface surface = plain();
    surface.unknown = true;
    return surface;
}

Surface Looks::ofMaterial(const PartContent& part, const PropertyGroup& group, const Properties& properties) {
    Surface surface;
    const std::uint32_t entry = properties.entries[0];
    surface.look =
        numberOf({&part, properties.group, entry}, [&] { return add(materialOf(part, group, entry), {}); });
    return surface;
}

Surface Looks::painted(const PartContent& part, const Properties& properties) {
    Surface surface;
    bool translucent = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto paint = paintAt(part, properties.group, properties.entries[i]);
        if (!paint) {
            return unknown();
        }
        surface.paints[i] = *paint;
        translucent = translucent || paint->alpha < 1;
    }
    surface.look = numberOf({nullptr, 0, translucent ? 1U : 0U}, [&] {
        SourceMaterial source = plainMaterial(kWhite);
        source.vertexAlpha = translucent;
        source.alphaMode = translucent ? AlphaMode::Blend : AlphaMode::Opaque;
        return add(source, {.name = {}, .painted = true, .translucent = translucent});
    });
    return surface;
}

Surface Looks::textured(const PartContent& part, const PropertyGroup& group, const Properties& properties) {
    const auto texture = part.textures.find(group.source);
    Surface surface;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto coordinate = coordinateAt(part, properties.group, properties.entries[i]);
        if (!coordinate || texture == part.textures.end()) {
            return unknown();
        }
        surface.coordinates[i] = *coordinate;
    }
    surface.look = numberOf({&part, properties.group, 0}, [&] {
        const std::string& path = texture->second.path;
        const std::string name = std::filesystem::path(path).stem().string();
        return add(imageMaterial(texture->second, name, path), {.name = {}, .textured = true});
    });
    return surface;
}

/// The coordinates of the lowest image hold for all of them.
bool Looks::lay(const PartContent& part, const PropertyGroup& group, const Properties& properties,
                Surface& surface) {
    for (std::size_t i = 0; i < 3; ++i) {
        std::optional<Vec2> first;
        for (std::size_t c = 0; c < group.columns.size(); ++c) {
            const std::uint32_t entry = entryOfLayer(group, properties.entries[i], c);
            if (!isTexture(part, group.columns[c])) {
                if (!paintAt(part, group.columns[c], entry)) return false;
                continue;
            }
            const auto coordinate = coordinateAt(part, group.columns[c], entry);
            if (!coordinate) return false;
            laidApart_ = laidApart_ || (first && *first != *coordinate);
            first = first ? first : coordinate;
        }
        surface.coordinates[i] = *first;
    }
    return true;
}

std::vector<ImageLayer> Looks::layersOf(const PartContent& part, const PropertyGroup& group,
                                        std::uint32_t entry) {
    std::vector<ImageLayer> layers;
    for (std::size_t c = 0; c < group.columns.size(); ++c) {
        ImageLayer layer{{}, {}, group.multiplies[c] != 0};
        if (isTexture(part, group.columns[c])) {
            const auto texture = part.textures.find(groupAt(part, group.columns[c])->source);
            layer.path = texture != part.textures.end() ? texture->second.path : "?";
        } else {
            layer.paint = paintAt(part, group.columns[c], entryOfLayer(group, entry, c)).value_or(Paint{});
        }
        layers.push_back(layer);
    }
    return layers;
}

Surface Looks::layered(const PartContent& part, const PropertyGroup& group, const Properties& properties) {
    constexpr std::uint32_t kMaxImages = 16;
    const auto first =
        std::ranges::find_if(group.columns, [&](std::uint32_t c) { return isTexture(part, c); });
    if (first == group.columns.end()) return painted(part, properties);
    Surface surface;
    if (!lay(part, group, properties, surface)) {
        return unknown();
    }
    std::array<std::uint64_t, 3> codes{};
    for (std::size_t i = 0; i < 3; ++i)
        codes[i] = codeOf(paintAt(part, properties.group, properties.entries[i]).value_or(Paint{}));
    unevenLayers_ = unevenLayers_ || codes[1] != codes[0] || codes[2] != codes[0];
    Key key{&part, properties.group, codes[0]};
    if (!numbers_.contains(key) && composed_[&group] >= kMaxImages) {
        unevenLayers_ = true;
        key = numbers_.lower_bound({&part, properties.group, 0})->first;
    }
    surface.look = numberOf(key, [&] {
        const std::string image = fmt::format("multiproperties {}/{}", properties.group, composed_[&group]++);
        const std::vector<ImageLayer> layers = layersOf(part, group, properties.entries[0]);
        images_.compose(image, layers);
        const auto texture = part.textures.find(groupAt(part, *first)->source);
        SourceMaterial source =
            imageMaterial(texture != part.textures.end() ? texture->second : TextureSource{}, image, image);
        if (layers[0].path.empty()) source.diffuse = layers[0].paint.colour;
        return add(source, {.name = {}, .textured = true});
    });
    return surface;
}

Surface Looks::surfaceOf(const PartContent& part, const Properties& properties) {
    if (properties.group == kNoNumber) return plain();
    const PropertyGroup* const group = groupAt(part, properties.group);
    if (group == nullptr) {
        return unknown();
    }
    switch (group->kind) {
    case GroupKind::Materials:
        if (properties.entries[0] < group->paints.size()) return ofMaterial(part, *group, properties);
        return unknown();
    case GroupKind::Texture:
        return textured(part, *group, properties);
    case GroupKind::Layers:
        return layered(part, *group, properties);
    case GroupKind::Colours:
    case GroupKind::Composites:
        break;
    }
    return painted(part, properties);
}

} // namespace rtcore::threemf

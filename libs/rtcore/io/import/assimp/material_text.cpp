#include "rtcore/io/import/assimp/material_text.h"

#include "rtcore/io/import/assimp/xml_text.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

using View = std::string_view;
using xml::attributeOf;
using xml::takeElement;

SpecularOrigin specularOf(View effect) {
    View rest = effect;
    if (takeElement(rest, "lambert")) return SpecularOrigin::None;
    rest = effect;
    if (takeElement(rest, "constant")) return SpecularOrigin::Stated;
    const auto specular = takeElement(effect, "specular");
    if (!specular) return SpecularOrigin::None;
    const auto holds = [&](const char* what) { return specular->body.find(what) != View::npos; };
    if (holds("<color") || holds("<param")) return SpecularOrigin::Stated;
    return holds("<texture") ? SpecularOrigin::Texture : SpecularOrigin::None;
}

/// In the order of their identifiers, those alone whose effect is there.
std::vector<MaterialText> colladaMaterials(const std::filesystem::path& path) {
    const std::string text = xml::textWithoutComments(path);
    std::map<std::string, SpecularOrigin> effects, materials;
    View rest = text;
    while (const auto effect = takeElement(rest, "effect"))
        effects[attributeOf(effect->head, "id")] = specularOf(effect->body);
    rest = text;
    while (const auto material = takeElement(rest, "material")) {
        View body = material->body;
        const auto instance = takeElement(body, "instance_effect");
        if (!instance) continue;
        const auto effect = effects.find(xml::idOf(attributeOf(instance->head, "url")));
        if (effect != effects.end()) materials[attributeOf(material->head, "id")] = effect->second;
    }
    std::vector<MaterialText> inOrder;
    for (const auto& [id, specular] : materials) inOrder.push_back({specular});
    return inOrder;
}

} // namespace

MaterialTexts::MaterialTexts(const std::filesystem::path& path) {
    if (xml::isCollada(path)) inOrder_ = colladaMaterials(path);
}

MaterialText MaterialTexts::of(std::size_t index, std::size_t count) const {
    return inOrder_.size() == count && index < count ? inOrder_[index] : MaterialText{};
}

} // namespace rtcore

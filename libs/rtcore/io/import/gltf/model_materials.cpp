#include "rtcore/io/import/gltf/model_materials.h"

#include "rtcore/io/import/import_forms.h"

#include <utility>

namespace rtcore::gltf {

ModelMaterials::ModelMaterials(const Json& root, const NodeWalk& walk, std::span<const Placement> placements,
                               const Images& images, PrimitiveReader& primitives)
    : stated_(member(root, "materials")), images_(images), entries_(gltf::sizeOf(stated_) + 1) {
    const Json& meshes = member(root, "meshes");
    std::set<std::size_t> seen;
    const auto useOnce = [&](std::size_t mesh) {
        if (seen.insert(mesh).second) use(meshes[mesh], primitives);
    };
    for (const std::size_t placed : leavesFirst(walk)) {
        const auto mesh = index(member(root, "nodes")[walk.nodes[placed].node], "mesh");
        if (mesh && *mesh < gltf::sizeOf(meshes)) useOnce(*mesh);
    }
    for (const Placement& at : placements) useOnce(at.mesh); // of a file without nodes
    if (entries_.back().shown) order_.push_back(entries_.size() - 1);
}

void ModelMaterials::use(const Json& mesh, PrimitiveReader& primitives) {
    for (const Json& primitive : member(mesh, "primitives")) {
        const std::size_t number = entryOf(primitive);
        if (!entries_[number].shown && number + 1 < entries_.size()) order_.push_back(number);
        entries_[number].shown = true;
        const std::string mode = text(element(stated_, number), "alphaMode");
        if ((mode != "BLEND" && mode != "MASK") || !primitives.hasAlphas(primitive)) continue;
        entries_[number].alphas = true;
        withAlphas_.insert(&primitive);
    }
}

std::size_t ModelMaterials::entryOf(const Json& primitive) const {
    const auto number = index(primitive, "material");
    return number && *number + 1 < entries_.size() ? *number : entries_.size() - 1;
}

void ModelMaterials::addTo(FileImport& import, TextureStore& textures) {
    for (const std::size_t i : order_) {
        Entry& entry = entries_[i];
        const Json& stated = element(stated_, i);
        StatedMaterial material = materialOf(stated, images_);
        SourceMaterial& source = material.source;
        source.vertexAlpha = entry.alphas;
        entry.texcoords = std::move(material.texcoords);
        if (hasUnevenCoat(stated, images_))
            addWarning(import.report, say(import_forms::kEvenCoat, "'" + source.name + "'"));
        Material mapped = mapMaterial(source, textures);
        entry.alphas = mapped.vertexAlpha != 0;
        mapped.nameOffset = import.model.addName(source.name);
        entry.number = static_cast<std::uint32_t>(import.model.materials.size());
        import.model.materials.push_back(mapped);
    }
}

std::uint32_t ModelMaterials::numberOf(const Json& primitive) const {
    return entries_[entryOf(primitive)].number;
}

PrimitiveUse ModelMaterials::useOf(const Json& primitive) const {
    const Entry& entry = entries_[entryOf(primitive)];
    PrimitiveUse use;
    use.texcoords = entry.texcoords;
    use.alphas = entry.alphas && withAlphas_.contains(&primitive);
    return use;
}

} // namespace rtcore::gltf

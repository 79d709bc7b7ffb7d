#include "rtcore/io/import/obj/obj_structure.h"

namespace rtcore {

namespace {

const std::string kUnnamed = "defaultobject";

} // namespace

void ObjStructure::createMesh(const std::string& name) {
    model_.meshes.push_back({name, object_, material_, {}, 0});
    mesh_ = model_.meshes.size() - 1;
}

void ObjStructure::createObject(const std::string& name) {
    object_ = static_cast<std::uint32_t>(model_.objects.size());
    objects_.try_emplace(name, object_);
    model_.objects.push_back(name);
    createMesh(name);
}

void ObjStructure::beginObject(std::string_view name) {
    if (name.empty()) return;
    const auto known = objects_.find(std::string(name));
    if (known != objects_.end()) {
        object_ = known->second;
    } else {
        createObject(std::string(name));
    }
}

void ObjStructure::beginGroup(std::string_view name) {
    if (name == group_) return;
    group_ = name;
    createObject(group_);
}

void ObjStructure::setMaterial(std::uint32_t material, const std::string& name) {
    if (material == material_) return;
    material_ = material;
    if (!mesh_ || model_.meshes[*mesh_].statements > 0) {
        createMesh(name);
    } else {
        model_.meshes[*mesh_].material = material;
    }
}

std::size_t ObjStructure::meshOfNext() {
    if (object_ == kNoIndex) createObject(kUnnamed);
    return *mesh_;
}

} // namespace rtcore

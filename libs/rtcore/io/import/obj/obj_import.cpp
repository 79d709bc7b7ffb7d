#include "rtcore/io/import/obj/obj_import.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/inspection/exporter_notes.h"
#include "rtcore/io/import/inspection/foreign_formats.h"
#include "rtcore/io/import/inspection/import_warnings.h"
#include "rtcore/io/import/materials/material_mapping.h"
#include "rtcore/io/import/mesh/geometry_finish.h"
#include "rtcore/io/import/mesh/near_zero.h"
#include "rtcore/io/import/obj/obj_meshes.h"
#include "rtcore/io/import/obj/obj_reader.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/paths.h"

#include <algorithm>
#include <string>
#include <vector>

namespace rtcore {

namespace {

/// Numbers of materials in the model, and how their images lie, by their numbers in the file.
class ObjMaterials {
  public:
    /// Those that `used` tells, in the order of the file.
    ObjMaterials(std::span<MtlMaterial> materials, const std::vector<char>& used, FileImport& to,
                 TextureStore& textures)
        : numbers_(materials.size(), 0), layouts_(materials.size()) {
        for (std::size_t m = 0; m < materials.size(); ++m) {
            if (used[m] == 0) continue;
            layouts_[m] = layoutOf(materials[m], to.report);
            Material material = mapMaterial(materials[m].source, textures);
            material.nameOffset = to.model.addName(materials[m].source.name);
            numbers_[m] = static_cast<std::uint32_t>(to.model.materials.size());
            to.model.materials.push_back(material);
        }
    }
    std::uint32_t numberOf(std::uint32_t material) const { return numbers_[material]; }
    const MtlLayout& layout(std::uint32_t material) const { return layouts_[material]; }

  private:
    /// A material has one set of coordinates for all of its images: that of the first.
    static MtlLayout layoutOf(MtlMaterial& material, ImportReport& report) {
        std::optional<MtlLayout> first;
        for (std::size_t i = 0; i < kMtlMaps; ++i) {
            if (material.map(static_cast<MtlMap>(i)).empty()) continue;
            if (!first) first = material.layouts[i];
            if (material.layouts[i] == *first) continue;
            addWarning(report, say(import_forms::kLaidAlike, "'" + material.source.name + "'"));
        }
        return first.value_or(MtlLayout{});
    }
    std::vector<std::uint32_t> numbers_;
    std::vector<MtlLayout> layouts_;
};

std::uint32_t materialOf(const ObjMesh& mesh) {
    return mesh.material == kNoIndex ? MtlMaterials::kDefault : mesh.material;
}

/// Colours of vertices stand in place of the grey of faces without a material, or with one that no library
/// describes, which would darken them.
void whitenColouredFaces(ObjFile& file) {
    if (file.model.colours.empty()) return;
    for (MtlMaterial& material : file.materials.all())
        if (!material.isDescribed) material.source.diffuse = kWhite;
}

std::vector<char> usedMaterials(ObjFile& file) {
    std::vector<char> used(file.materials.all().size(), 0);
    for (const ObjMesh& mesh : file.model.meshes)
        if (mesh.statements > 0) used[materialOf(mesh)] = 1;
    return used;
}

/// Numbers of the meshes that hold something, by objects.
std::vector<std::size_t> inOrder(const ObjModel& model) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < model.meshes.size(); ++i)
        if (model.meshes[i].statements > 0) order.push_back(i);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return model.meshes[i].object; });
    return order;
}

/// Parts of an object that has several go by their material, too.
std::string partName(const ObjModel& model, const ObjMesh& mesh, bool isAlone, const std::string& material) {
    const std::string& object = model.objects[mesh.object];
    std::string own = object.empty() ? mesh.name : "";
    if (!isAlone && !material.empty()) own = material;
    return object.empty() || own.empty() ? object + own : object + "/" + own;
}

void makeRoom(const ObjModel& model, std::uint64_t memoryLimit, MeshAssembler& assembler) {
    const std::uint64_t corners = model.corners.positions.size();
    const std::uint64_t triangles =
        model.sizes.empty() ? model.faces : corners - std::min<std::uint64_t>(corners, 2 * model.faces);
    makeRoomFor({0, corners, triangles}, memoryLimit, assembler);
}

void addMeshes(ObjFile& file, const ObjMaterials& materials, const FileImportOptions& options,
               MeshAssembler& assembler, FileImport& import) {
    ObjModel& model = file.model;
    const std::vector<std::size_t> order = inOrder(model);
    std::vector<std::uint32_t> meshesOf(model.objects.size(), 0);
    for (const std::size_t i : order) ++meshesOf[model.meshes[i].object];
    ObjMeshes meshes(model);
    for (const std::size_t i : order) {
        const ObjMesh& mesh = model.meshes[i];
        const std::uint32_t material = materialOf(mesh);
        SourceMesh source = meshes.read(mesh, materials.layout(material), i == order.back());
        if (source.triangles.empty()) continue;
        source.material = materials.numberOf(material);
        const std::uint32_t first = assembler.triangleCount();
        assembler.add(source);
        const std::string name =
            partName(model, mesh, meshesOf[mesh.object] == 1, file.materials.all()[material].source.name);
        import.model.parts.push_back({import.model.addName(name), first, assembler.triangleCount() - first});
        options.alive();
    }
    import.report.ignoredPrimitives = model.segments + meshes.ignoredFaces();
    import.report.unconnectedTriangles = meshes.unconnectedTriangles();
}

std::optional<FileImport> objAsItLies(const std::filesystem::path& path, const FileImportOptions& options) {
    if (inSmallLetters(path.extension().string()) != ".obj") return std::nullopt;
    refuseMisnamed(path);
    FileImport import;
    const std::string notes = exporterNotes(path);
    import.report.origin = {"Wavefront Object Importer", notes, {}, statedUnit(notes)};
    addFile(import.report, plainPath(path).string());
    MeshAssembler assembler;
    const NoEmbeddedPictures none;
    TextureStore textures(import.model, import.report, path.parent_path(), none, options.alive);
    std::size_t meshes = 0;
    {
        ObjFile file = readObj(path, options.origin, import.report, options.alive);
        meshes = inOrder(file.model).size();
        if (meshes == 0 && !file.model.positions.empty()) refusePoints(file.model.positions.size());
        makeRoom(file.model, options.memoryLimit, assembler);
        whitenColouredFaces(file);
        const ObjMaterials materials(file.materials.all(), usedMaterials(file), import, textures);
        addMeshes(file, materials, options, assembler, import);
    }
    finishGeometry(assembler, options.creaseAngle, options.origin, import);
    refuseUseless(assembler, meshes, import);
    warnOfLostTriangles(import.model, import.report);
    warnOfMissingTextures(textures.missing(), import.report);
    warnWhenInvisible(import.model, import.report);
    warnOfOutliers(import.model, import.report);
    return import;
}

} // namespace

std::optional<FileImport> importObj(const std::filesystem::path& path, const FileImportOptions& options) {
    return readNearZero(objAsItLies, path, options);
}

} // namespace rtcore

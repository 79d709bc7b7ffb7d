#include "rtcore/io/import/cad/cad_import.h"

#include "rtcore/io/import/cad/alive_progress.h"
#include "rtcore/io/import/cad/cad_document.h"
#include "rtcore/io/import/cad/face_mesh.h"
#include "rtcore/io/import/inspection/foreign_formats.h"
#include "rtcore/io/import/inspection/import_warnings.h"
#include "rtcore/io/import/materials/material_mapping.h"
#include "rtcore/io/import/mesh/geometry_finish.h"
#include "rtcore/io/import/mesh/near_zero.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/paths.h"

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <Bnd_Box.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

double diagonalOf(const Bnd_Box& box) { return box.IsVoid() ? 0 : std::sqrt(box.SquareExtent()); }

Bnd_Box boundsOfPart(const CadPart& part) {
    Bnd_Box box;
    BRepBndLib::AddClose(part.shape.Moved(part.location), box);
    return box;
}

class CadMeshes {
  public:
    CadMeshes(const FileImportOptions& options, FileImport& import) : options_(options), import_(import) {}

    void read(const std::vector<CadPart>& parts, MeshAssembler& assembler) {
        Bnd_Box all;
        for (const CadPart& part : parts) all.Add(boundsOfPart(part));
        for (const CadPart& part : parts) {
            meshShape(part, diagonalOf(all));
            add(part, assembler);
            options_.alive();
        }
    }

  private:
    /// A shape that stands in several positions is meshed once: it keeps its triangles.
    void meshShape(const CadPart& part, double diagonal) {
        constexpr double kOfPart = 10, kTurn = 0.35; // radians
        const double deflection = static_cast<double>(options_.deflection);
        IMeshTools_Parameters parameters;
        parameters.Deflection =
            std::max(std::min(diagonal, kOfPart * diagonalOf(boundsOfPart(part))) * deflection, 1e-9);
        parameters.Angle = kTurn;
        parameters.InParallel = false;
        Handle(AliveProgress) progress = new AliveProgress(options_.alive);
        const BRepMesh_IncrementalMesh mesher(part.shape, parameters, progress->Start());
    }

    /// One mesh for each colour, in the order of the faces.
    void add(const CadPart& part, MeshAssembler& assembler) {
        std::vector<std::uint32_t> materials;
        for (const CadFace& face : part.faces) {
            const std::uint32_t material = materialOf(face.paint);
            if (std::ranges::find(materials, material) == materials.end()) materials.push_back(material);
        }
        const std::uint32_t first = assembler.triangleCount();
        for (const std::uint32_t material : materials) {
            FaceMesh mesh;
            for (const CadFace& face : part.faces)
                if (materialOf(face.paint) == material)
                    addFace(face.face, part.location, options_.origin, mesh);
            triangles_ += mesh.triangles.size();
            makeRoomFor({0, 0, triangles_}, options_.memoryLimit, assembler);
            SourceMesh source{
                .positions = mesh.positions, .normals = mesh.normals, .triangles = mesh.triangles};
            source.material = material;
            assembler.add(source);
        }
        import_.model.parts.push_back(
            {import_.model.addName(part.name), first, assembler.triangleCount() - first});
    }

    std::uint32_t materialOf(const std::optional<CadPaint>& paint) {
        const auto at = std::ranges::find(paints_, paint);
        if (at != paints_.end()) return static_cast<std::uint32_t>(at - paints_.begin());
        paints_.push_back(paint);
        const NoEmbeddedPictures none;
        TextureStore textures(import_.model, import_.report, {}, none, options_.alive);
        SourceMaterial source;
        source.diffuse = paint ? paint->colour : kUnsetDiffuse;
        source.opacity = paint ? paint->alpha : 1;
        source.indexByHabit = true;
        import_.model.materials.push_back(mapMaterial(source, textures));
        return static_cast<std::uint32_t>(paints_.size() - 1);
    }

    const FileImportOptions& options_;
    FileImport& import_;
    std::vector<std::optional<CadPaint>> paints_; ///< by the number of the material
    std::uint64_t triangles_ = 0;
};

} // namespace

namespace {

FileImport cadAsItLies(const std::filesystem::path& path, const FileImportOptions& options) {
    try {
        FileImport import;
        addFile(import.report, plainPath(path).string());
        const bool hasUnit = cadFormat(path) != CadFormat::Brep;
        import.report.origin = {"Open CASCADE (STEP, IGES, BREP)", {}, {}, {}};
        if (hasUnit) import.report.origin.metresPerUnit = 0.001;
        const std::vector<CadPart> parts =
            cadPartsOf(readCadDocument(path, options.alive), options.memoryLimit);
        MeshAssembler assembler;
        CadMeshes(options, import).read(parts, assembler);
        finishGeometry(assembler, options.creaseAngle, options.origin, import);
        refuseUseless(assembler, parts.size(), import);
        warnOfLostTriangles(import.model, import.report);
        warnOfOutliers(import.model, import.report);
        return import;
    } catch (const Standard_Failure& failure) {
        const char* const words = failure.GetMessageString();
        throw FileError(
            FailureKind::BadData, "",
            say("Open CASCADE cannot read it ({0}); export it as STL, 3MF or glTF from the CAD program",
                std::string(words != nullptr && *words != '\0' ? words : failure.DynamicType()->Name())));
    }
}

} // namespace

FileImport importCad(const std::filesystem::path& path, const FileImportOptions& options) {
    return readNearZero(cadAsItLies, path, options);
}

} // namespace rtcore

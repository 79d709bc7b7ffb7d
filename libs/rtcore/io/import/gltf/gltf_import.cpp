#include "rtcore/io/import/gltf/gltf_import.h"

#include "rtcore/io/import/gltf/animation.h"
#include "rtcore/io/import/gltf/extensions.h"
#include "rtcore/io/import/gltf/lights.h"
#include "rtcore/io/import/gltf/model_materials.h"
#include "rtcore/io/import/gltf/placed_mesh.h"
#include "rtcore/io/import/gltf/scene_meshes.h"
#include "rtcore/io/import/gltf/skin.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/inspection/cut_off.h"
#include "rtcore/io/import/inspection/import_warnings.h"
#include "rtcore/io/import/mesh/geometry_finish.h"
#include "rtcore/io/import/mesh/near_zero.h"
#include "rtcore/io/import/model_import.h"
#include "rtcore/io/import/pose/animation_choice.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/paths.h"

#include <map>
#include <tuple>
#include <utility>

namespace rtcore {

namespace {

using gltf::Json;

/// Meshes without normals are flat in this format, unless another angle than the usual one is asked for.
float creaseOf(const FileImportOptions& options) {
    return options.creaseAngle == kCreaseAngle ? 0 : options.creaseAngle;
}

[[noreturn]] void refuseGltf(const Sentence& why) { throw FileError(FailureKind::BadData, "", why); }

void refuseMissing(const std::vector<std::string>& buffers) {
    if (buffers.empty()) return;
    const bool one = buffers.size() == 1;
    refuseGltf(say(one ? "its geometry is in {0}, which is missing; put it beside the model's file"
                       : "its geometry is in {0}, which are missing; put them beside the model's file",
                   firstOf(buffers)));
}

/// Reads one file.
class GltfReader {
  public:
    /// Moves the nodes of the container where another pose than theirs is asked for.
    GltfReader(const std::filesystem::path& path, gltf::Container& container,
               const FileImportOptions& options)
        : path_(path), posed_(container.root), root_(container.root), options_(options),
          buffers_(container, path, import_.report), views_(root_, buffers_), accessors_(root_, views_),
          primitives_(root_, accessors_, views_), world_(options.origin), skins_(root_, world_, accessors_) {}

    FileImport read() {
        const gltf::Needs needs = gltf::needsOf(root_);
        if (needs.fatal) refuseGltf(*needs.fatal);
        describe();
        pose();
        MeshAssembler assembler;
        makeRoomFor(gltf::shownOf(root_, primitives_, accessors_), options_.memoryLimit, assembler);
        walk_ = gltf::walkNodes(root_, world_);
        placements_ = gltf::placementsOf(root_, world_, walk_, accessors_);
        refuseMissing(buffers_.missing());
        const gltf::Images images(root_, views_);
        TextureStore textures(import_.model, import_.report, path_.parent_path(), images, options_.alive);
        gltf::ModelMaterials materials(root_, walk_, placements_, images, primitives_);
        materials.addTo(import_, textures);
        addMeshes(materials, assembler);
        finish(assembler);
        warn(needs, textures.missing());
        gltf::Luminaires luminaires(root_, views_, path_, import_.report);
        gltf::addLights(root_, walk_, luminaires, import_.model, import_.report);
        gltf::addCameras(root_, walk_, import_.model, import_.report);
        return std::move(import_);
    }

  private:
    const Json& primitivesOf(std::size_t mesh) const {
        return gltf::member(gltf::member(root_, "meshes")[mesh], "primitives");
    }

    void describe() {
        import_.report.origin = {"glTF2 Importer", gltf::text(gltf::member(root_, "asset"), "generator"),
                                 Vec3{0, 1, 0}, 1};
        addFile(import_.report, plainPath(path_).string());
    }

    void pose() {
        const std::vector<std::string> names = gltf::animationNames(root_);
        const auto animation = animationOf(options_.pose, names, import_.report);
        if (!animation) return;
        std::optional<double> seconds;
        if (options_.pose.kind == PoseChoice::Kind::Moment) seconds = options_.pose.seconds;
        damagedChannels_ = gltf::animate(posed_, *animation, seconds, accessors_);
    }

    std::vector<float> weightsOf(const gltf::Placement& at) const {
        const Json& mesh = gltf::member(root_, "meshes")[at.mesh];
        const Json* weights = &gltf::member(mesh, "weights");
        if (at.placed < walk_.nodes.size()) {
            const Json& own =
                gltf::member(gltf::member(root_, "nodes")[walk_.nodes[at.placed].node], "weights");
            if (!own.is_null()) weights = &own;
        }
        std::vector<float> list;
        for (const Json& weight : *weights) list.push_back(weight.is_number() ? weight.get<float>() : 0.0F);
        return list;
    }

    bool isSkinned(const gltf::Placement& at) const { return at.skin && skins_.has(*at.skin); }

    void addMeshes(const gltf::ModelMaterials& materials, MeshAssembler& assembler) {
        std::map<std::size_t, std::uint64_t> times; // that a mesh is shown
        for (const gltf::Placement& at : placements_) ++times[at.mesh];
        std::vector<gltf::Primitive> kept;
        std::tuple<std::size_t, std::vector<float>, bool> keptOf{~std::size_t{0}, {}, false};
        for (const gltf::Placement& at : placements_) {
            const std::vector<float> weights = weightsOf(at);
            const Json& list = primitivesOf(at.mesh);
            const bool skinned = isSkinned(at);
            if (keptOf != std::tuple(at.mesh, weights, skinned)) kept.clear();
            keptOf = {at.mesh, weights, skinned};
            for (std::size_t p = 0; p < gltf::sizeOf(list); ++p) {
                if (kept.size() > p) {
                    addMesh(kept[p], at, p, materials, assembler, false);
                    continue;
                }
                gltf::PrimitiveUse use = materials.useOf(list[p]);
                use.weights = weights;
                use.skinned = skinned;
                gltf::Primitive primitive = primitives_.read(list[p], use);
                const bool once = times[at.mesh] == 1;
                addMesh(primitive, at, p, materials, assembler, once);
                if (!once) kept.push_back(std::move(primitive));
            }
        }
    }

    /// `spare`: the lists of the primitive are needed no more.
    void addMesh(gltf::Primitive& primitive, const gltf::Placement& at, std::size_t number,
                 const gltf::ModelMaterials& materials, MeshAssembler& assembler, bool spare) {
        damagedPrimitives_ += primitive.damaged ? 1 : 0;
        damagedAttributes_ += primitive.damagedAttributes;
        import_.report.ignoredPrimitives += primitive.list.pointsAndLines;
        import_.report.unconnectedTriangles += primitive.list.unconnected;
        if (!options_.origin.isZero())
            import_.coarseness = std::max(import_.coarseness, coarsenessOf(primitive.positions, at.toWorld));
        SourceMesh mesh = placer_.place(primitive, at.toWorld,
                                        isSkinned(at) ? skins_.joints(*at.skin) : std::span<const Affine>());
        if (mesh.triangles.empty()) return;
        if (spare) gltf::MeshPlacer::spareLists(primitive, mesh);
        mesh.material = materials.numberOf(primitivesOf(at.mesh)[number]);
        const std::uint32_t first = assembler.triangleCount();
        assembler.add(mesh);
        import_.model.parts.push_back({import_.model.addName(gltf::nameOf(root_, walk_, at, number)), first,
                                       assembler.triangleCount() - first});
        options_.alive();
    }

    void finish(MeshAssembler& assembler) {
        finishGeometry(assembler, creaseOf(options_), options_.origin, import_);
        cut_ = cutOff(path_);
        if (import_.model.triangles.empty()) {
            if (cut_) refuseGltf(*cut_);
            if (damagedPrimitives_ > 0)
                refuseGltf(say("all of its geometry is damaged; copy or export it again"));
        }
        std::size_t primitives = 0;
        for (const Json& mesh : gltf::member(root_, "meshes"))
            primitives += gltf::sizeOf(gltf::member(mesh, "primitives"));
        refuseUseless(assembler, primitives, import_);
    }

    void warn(const gltf::Needs& needs, const std::vector<std::string>& missingTextures) {
        ImportReport& report = import_.report;
        if (cut_) addWarning(report, *cut_);
        warnOfLostTriangles(import_.model, report);
        if (damagedPrimitives_ > 0) addWarning(report, say(import_forms::kBrokenMeshes, damagedPrimitives_));
        if (damagedAttributes_ > 0) addWarning(report, say(import_forms::kBrokenLists, damagedAttributes_));
        if (damagedChannels_ > 0) addWarning(report, say(import_forms::kBrokenChannels, damagedChannels_));
        if (needs.loss) addWarning(report, say(import_forms::kNeeds, *needs.loss));
        if (const auto ignored = gltf::ignoredOf(root_)) addWarning(report, *ignored);
        warnOfMissingTextures(missingTextures, report);
        warnWhenInvisible(import_.model, report);
        warnOfOutliers(import_.model, report);
    }

    const std::filesystem::path& path_;
    Json& posed_;
    const Json& root_; ///< the same
    const FileImportOptions& options_;
    FileImport import_;
    gltf::Buffers buffers_;
    gltf::Views views_;
    gltf::Accessors accessors_;
    gltf::PrimitiveReader primitives_;
    gltf::World world_;
    gltf::Skins skins_;
    gltf::MeshPlacer placer_;
    gltf::NodeWalk walk_;
    std::vector<gltf::Placement> placements_;
    std::uint64_t damagedPrimitives_ = 0, damagedAttributes_ = 0, damagedChannels_ = 0;
    std::optional<Sentence> cut_;
};

std::optional<FileImport> gltfAsItLies(const std::filesystem::path& path, const FileImportOptions& options) {
    std::optional<gltf::Container> container = gltf::openContainer(path);
    if (!container) return std::nullopt;
    options.alive();
    return GltfReader(path, *container, options).read();
}

} // namespace

std::optional<FileImport> importGltf(const std::filesystem::path& path, const FileImportOptions& options) {
    return readNearZero(gltfAsItLies, path, options);
}

} // namespace rtcore

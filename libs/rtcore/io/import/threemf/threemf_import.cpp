#include "rtcore/io/import/threemf/threemf_import.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/inspection/cut_off.h"
#include "rtcore/io/import/inspection/foreign_formats.h"
#include "rtcore/io/import/inspection/import_warnings.h"
#include "rtcore/io/import/mesh/geometry_finish.h"
#include "rtcore/io/import/mesh/near_zero.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/io/import/threemf/build_items.h"
#include "rtcore/io/import/threemf/looks.h"
#include "rtcore/io/import/threemf/package.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/paths.h"
#include "rtcore/scene/up_axis.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace rtcore::threemf {

namespace {

/// The lists of one mesh, kept from one to the next.
class ObjectMeshes {
  public:
    ObjectMeshes(Looks& looks, MeshAssembler& assembler, FileImport& import)
        : looks_(looks), assembler_(assembler), import_(import) {}

    void add(const PlacedObject& placed) {
        const Object& object = *placed.object;
        mirrored_ = placed.toWorld.determinant() < 0;
        import_.report.unconnectedTriangles += object.unconnected;
        const std::vector<std::uint32_t> order = looksOf(placed);
        for (const std::uint32_t look : order) {
            const bool whole = order.size() == 1 && !hasCorners(looks_.look(look));
            const SourceMesh mesh = whole ? asItStands(placed) : withCorners(placed, look);
            const std::uint32_t first = assembler_.triangleCount();
            assembler_.add(mesh);
            const std::string& own = looks_.look(look).name;
            const bool both = order.size() > 1 && !own.empty();
            const std::string name = !both                 ? placed.name
                                     : placed.name.empty() ? own
                                                           : placed.name + "/" + own;
            import_.model.parts.push_back(
                {import_.model.addName(name), first, assembler_.triangleCount() - first});
        }
    }
    /// Triangles whose groups or entries do not exist.
    std::uint64_t unknown() const { return unknown_; }

  private:
    static bool hasCorners(const Look& look) { return look.painted || look.textured; }

    static const Properties& propertiesOf(const Object& object, std::size_t triangle) {
        return object.ownProperties.empty() ? object.properties : object.ownProperties[triangle];
    }

    /// Numbers of looks in the order in which they come; lookOf_ has that of each triangle.
    std::vector<std::uint32_t> looksOf(const PlacedObject& placed) {
        const Object& object = *placed.object;
        std::vector<std::uint32_t> order;
        lookOf_.clear();
        for (std::size_t t = 0; t < object.triangles.size(); ++t) {
            const Surface surface = looks_.surfaceOf(*placed.part, propertiesOf(object, t));
            unknown_ += surface.unknown ? 1 : 0;
            const bool again = !lookOf_.empty() && lookOf_.back() == surface.look;
            if (!again && std::ranges::find(order, surface.look) == order.end())
                order.push_back(surface.look);
            lookOf_.push_back(surface.look);
        }
        return order;
    }

    void turn(std::vector<Triangle>& triangles) const {
        if (!mirrored_) return;
        for (Triangle& t : triangles) std::swap(t.v[1], t.v[2]);
    }

    SourceMesh asItStands(const PlacedObject& placed) {
        const Object& object = *placed.object;
        SourceMesh mesh{.positions = object.positions, .triangles = object.triangles};
        mesh.material = looks_.look(lookOf_[0]).material;
        if (placed.toWorld.identity()) return mesh;
        positions_.clear();
        for (const Vec3 p : object.positions) positions_.push_back(placed.toWorld.point(p));
        mesh.positions = positions_;
        if (!mirrored_) return mesh;
        triangles_ = object.triangles;
        turn(triangles_);
        mesh.triangles = triangles_;
        return mesh;
    }

    /// Each triangle of this look with vertices of its own.
    SourceMesh withCorners(const PlacedObject& placed, std::uint32_t number) {
        const Object& object = *placed.object;
        const Look& look = looks_.look(number);
        positions_.clear();
        triangles_.clear();
        colours_.clear();
        alphas_.clear();
        coordinates_.clear();
        for (std::size_t t = 0; t < object.triangles.size(); ++t) {
            if (lookOf_[t] != number) continue;
            const auto first = static_cast<std::uint32_t>(positions_.size());
            triangles_.push_back({{first, first + 1, first + 2}});
            for (const std::uint32_t v : object.triangles[t].v)
                positions_.push_back(placed.toWorld.point(object.positions[v]));
            if (hasCorners(look)) addCorners(looks_.surfaceOf(*placed.part, propertiesOf(object, t)), look);
        }
        turn(triangles_);
        SourceMesh mesh{.positions = positions_, .triangles = triangles_};
        mesh.texcoords = coordinates_;
        mesh.colours = colours_;
        mesh.alphas = alphas_;
        mesh.material = look.material;
        return mesh;
    }
    void addCorners(const Surface& surface, const Look& look) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (look.painted) colours_.push_back(surface.paints[i].colour);
            if (look.translucent) alphas_.push_back(surface.paints[i].alpha);
            if (look.textured) coordinates_.push_back(surface.coordinates[i]);
        }
    }

    Looks& looks_;
    MeshAssembler& assembler_;
    FileImport& import_;
    std::vector<std::uint32_t> lookOf_;
    std::vector<Vec3> positions_;
    std::vector<Triangle> triangles_;
    std::vector<Colour> colours_;
    std::vector<float> alphas_;
    std::vector<Vec2> coordinates_;
    std::uint64_t unknown_ = 0;
    bool mirrored_ = false;
};

void refuseRequired(const BuildItems& items) {
    for (const auto& [key, part] : items.parts()) {
        if (part.required.empty()) continue;
        const std::string name = "'" + part.required[0] + "'";
        throw FileError(FailureKind::BadData, "", say(import_forms::kNeedsOne, name, import_forms::kWithout));
    }
}

/// Before memory goes to instances.
void makeRoom(const BuildItems& items, const FileImportOptions& options, MeshAssembler& assembler) {
    makeRoomFor({items.objects(), 0, items.triangles()}, options.memoryLimit, assembler);
}

void warn(const BuildItems& items, const Looks& looks, std::uint64_t unknown, ImportReport& report) {
    std::vector<std::string> ignored;
    for (const auto& [key, part] : items.parts())
        for (const std::string& name : part.ignored)
            if (std::ranges::find(ignored, name) == ignored.end()) ignored.push_back(name);
    if (!ignored.empty()) addWarning(report, say(import_forms::kIgnored, firstOf(ignored)));
    if (items.lost() > 0) addWarning(report, say(import_forms::kLostObjects, items.lost()));
    if (unknown > 0) addWarning(report, say(import_forms::kLostColours, unknown));
    if (looks.laidApart()) addWarning(report, say(import_forms::kLayersApart));
    if (looks.unevenLayers()) addWarning(report, say(import_forms::kUnevenLayers));
}

void addObjects(Package& package, const std::filesystem::path& path, const FileImportOptions& options,
                FileImport& import) {
    const BuildItems items(package);
    refuseRequired(items);
    const PartContent& root = items.root();
    import.report.origin = {"3mf Importer", root.application, axisNamed("+z"), root.metresPerUnit};
    MeshAssembler assembler;
    makeRoom(items, options, assembler);
    PackageImages images(package);
    TextureStore textures(import.model, import.report, path.parent_path(), images, options.alive);
    Looks looks(images, textures, import);
    ObjectMeshes meshes(looks, assembler, import);
    std::size_t objects = 0;
    const Affine ofFile = lessOrigin(options.origin);
    items.walk([&](PlacedObject placed) {
        ++objects;
        if (!options.origin.isZero()) {
            import.coarseness =
                std::max(import.coarseness, coarsenessOf(placed.object->positions, placed.toWorld));
            placed.toWorld = ofFile * placed.toWorld;
        }
        meshes.add(placed);
        options.alive();
    });
    warn(items, looks, meshes.unknown(), import.report);
    finishGeometry(assembler, options.creaseAngle, options.origin, import);
    refuseUseless(assembler, objects, import);
}

} // namespace

} // namespace rtcore::threemf

namespace rtcore {

namespace {

std::optional<FileImport> packageAsItLies(const std::filesystem::path& path,
                                          const FileImportOptions& options) {
    if (inSmallLetters(path.extension().string()) != ".3mf") return std::nullopt;
    if (const auto cut = cutOff(path)) throw FileError(FailureKind::BadData, "", *cut);
    refuseMisnamed(path);
    FileImport import;
    addFile(import.report, plainPath(path).string());
    threemf::Package package(path, options.alive);
    threemf::addObjects(package, path, options, import);
    warnOfLostTriangles(import.model, import.report);
    warnWhenInvisible(import.model, import.report);
    warnOfOutliers(import.model, import.report);
    return import;
}

} // namespace

std::optional<FileImport> importThreeMf(const std::filesystem::path& path, const FileImportOptions& options) {
    return readNearZero(packageAsItLies, path, options);
}

} // namespace rtcore

#include "rtcore/io/import/mesh/mesh_assembly.h"

#include "rtcore/io/import/mesh/crease_normals.h"
#include "rtcore/io/import/mesh/equal_positions.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/large_vector.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

/// Corners are numbered in 32 bits.
constexpr std::size_t kMaxTriangles = std::size_t{1} << 30;
/// Not worth the threads.
constexpr std::size_t kFewTriangles = 20'000;

[[noreturn]] void refuseLarge() {
    throw FileError(FailureKind::BadData, "", "it has more than 2^30 triangles; split the model");
}

/// A mesh without normals, texture coordinates, colours and alphas.
bool isBare(const SourceMesh& mesh) {
    return mesh.normals.empty() && mesh.texcoords.empty() && mesh.colours.empty() && mesh.alphas.empty();
}

/// In double, where differences and products of floats keep nearly all of their bits.
bool hasArea(Vec3 a, Vec3 b, Vec3 c) {
    const double ux = double{b.x} - a.x, uy = double{b.y} - a.y, uz = double{b.z} - a.z;
    const double vx = double{c.x} - a.x, vy = double{c.y} - a.y, vz = double{c.z} - a.z;
    return uy * vz - uz * vy != 0 || uz * vx - ux * vz != 0 || ux * vy - uy * vx != 0;
}

template <typename T>
void makeRoom(std::vector<T>& list, std::size_t more, std::size_t expected) {
    const std::size_t wanted = list.size() + more;
    if (list.capacity() < wanted) reserveLarge(list, std::max({wanted, expected, list.size() * 3 / 2}));
}

/// Adds one attribute of a mesh of `count` vertices to those of the `before` that came before.
template <typename T>
void addAttribute(std::vector<T>& list, std::size_t before, std::size_t count, std::span<const T> from,
                  const T& usual, std::size_t expected) {
    if (list.empty() && from.empty()) return;
    makeRoom(list, before - list.size() + count, expected);
    list.resize(before, usual);
    list.insert(list.end(), from.begin(), from.end());
    list.resize(before + count, usual);
}

/// The first list of its kind is taken over, if it may be.
template <typename T>
bool takeOver(std::vector<T>& list, std::span<const T> from, std::vector<T>* spare) {
    if (!list.empty() || spare == nullptr || spare->data() != from.data() || spare->size() != from.size())
        return false;
    list = std::move(*spare);
    return true;
}

void addRun(std::vector<MeshLists::Run>& runs, std::size_t end, std::uint32_t value) {
    if (runs.empty() || runs.back().value != value) runs.push_back({0, value});
    runs.back().end = static_cast<std::uint32_t>(end);
}

std::vector<std::uint32_t> namedVertices(std::span<const Triangle> triangles) {
    std::vector<std::uint32_t> list;
    list.reserve(triangles.size() * 3);
    for (const Triangle& t : triangles) list.insert(list.end(), t.v, t.v + 3);
    std::ranges::sort(list);
    list.erase(std::ranges::unique(list).begin(), list.end());
    return list;
}

/// A mesh of the vertices that its triangles use, where these are few.
class UsedVertices {
  public:
    explicit UsedVertices(const SourceMesh& mesh) : used_(namedVertices(mesh.triangles)), mesh_(mesh) {
        for (const Triangle& t : mesh.triangles) triangles_.push_back({{at(t.v[0]), at(t.v[1]), at(t.v[2])}});
        mesh_.triangles = triangles_;
        mesh_.positions = pick(mesh.positions, positions_);
        mesh_.normals = pick(mesh.normals, normals_);
        mesh_.texcoords = pick(mesh.texcoords, texcoords_);
        mesh_.colours = pick(mesh.colours, colours_);
        mesh_.alphas = pick(mesh.alphas, alphas_);
        for (const std::vector<Vec2>& set : mesh.furtherTexcoords)
            pick(std::span<const Vec2>(set), further_.emplace_back());
        mesh_.furtherTexcoords = further_;
        mesh_.spare = {};
    }
    const SourceMesh& mesh() const { return mesh_; }

  private:
    std::uint32_t at(std::uint32_t vertex) const {
        return static_cast<std::uint32_t>(std::ranges::lower_bound(used_, vertex) - used_.begin());
    }
    template <typename T>
    std::span<const T> pick(std::span<const T> from, std::vector<T>& list) const {
        if (from.empty()) return {};
        for (const std::uint32_t vertex : used_) list.push_back(from[vertex]);
        return list;
    }

    std::vector<std::uint32_t> used_;
    SourceMesh mesh_;
    std::vector<Triangle> triangles_;
    std::vector<Vec3> positions_, normals_;
    std::vector<Vec2> texcoords_;
    std::vector<Colour> colours_;
    std::vector<float> alphas_;
    std::vector<std::vector<Vec2>> further_;
};

} // namespace

void MeshAssembler::reserve(std::size_t vertices, std::size_t triangles) {
    if (triangles > kMaxTriangles) refuseLarge();
    // Files without shared vertices have three in a triangle; more room is made when it is needed.
    expectedVertices_ = std::min(vertices, triangles);
    expectedTriangles_ = triangles;
}

/// Classifies the triangles, and extends the bounds by finite ones that will not be welded.
std::vector<MeshAssembler::Use> MeshAssembler::measure(const SourceMesh& mesh) {
    const std::size_t count = mesh.triangles.size();
    std::vector<Use> uses(count);
    const auto useOf = [&](const Triangle& t) {
        const auto corner = [&](int i) { return withoutTraces(mesh.positions[t.v[i]]); };
        const Vec3 a = corner(0), b = corner(1), c = corner(2);
        if (!isUsablePosition(a) || !isUsablePosition(b) || !isUsablePosition(c)) return Use::NonFinite;
        return hasArea(a, b, c) ? Use::Good : Use::WithoutArea;
    };
#pragma omp parallel if (count > kFewTriangles)
    {
        Box3 bounds;
#pragma omp for schedule(static)
        for (std::size_t i = 0; i < count; ++i) {
            const Triangle& t = mesh.triangles[i];
            uses[i] = useOf(t);
            if (uses[i] != Use::WithoutArea) continue;
            for (const std::uint32_t v : t.v) bounds.extend(mesh.positions[v]);
        }
#pragma omp critical(rtcore_mesh_bounds)
        if (!bounds.empty()) bounds_.extend(bounds);
    }
    return uses;
}

/// The good ones.
void MeshAssembler::addTriangles(const SourceMesh& mesh, const std::vector<Use>& uses) {
    const auto count = [&](Use use) { return static_cast<std::size_t>(std::ranges::count(uses, use)); };
    const std::size_t nonFinite = count(Use::NonFinite), flat = count(Use::WithoutArea);
    nonFinite_ += nonFinite;
    degenerate_ += flat;
    const auto first = static_cast<std::uint32_t>(lists_.positions.size());
    if (nonFinite + flat > 0 || first > 0 ||
        !takeOver(lists_.triangles, mesh.triangles, mesh.spare.triangles)) {
        makeRoom(lists_.triangles, uses.size(), expectedTriangles_);
        for (std::size_t i = 0; i < uses.size(); ++i) {
            const Triangle& t = mesh.triangles[i];
            if (uses[i] == Use::Good)
                lists_.triangles.push_back({{first + t.v[0], first + t.v[1], first + t.v[2]}});
        }
    }
    addRun(lists_.materials, lists_.triangles.size(), mesh.material);
}

void MeshAssembler::addVertices(const SourceMesh& mesh) {
    const std::size_t before = lists_.positions.size(), count = mesh.positions.size();
    const auto add = [&](auto& list, auto from, auto usual, auto* spare) {
        if (before > 0 || !takeOver(list, from, spare))
            addAttribute(list, before, count, from, usual, expectedVertices_);
    };
    constexpr std::vector<Colour>* kNoColours = nullptr;
    constexpr std::vector<float>* kNoAlphas = nullptr;
    add(lists_.normals, mesh.normals, Vec3{}, mesh.spare.normals);
    add(lists_.texcoords, mesh.texcoords, Vec2{}, mesh.spare.texcoords);
    add(lists_.colours, mesh.colours, kWhite, kNoColours);
    add(lists_.alphas, mesh.alphas, 1.0F, kNoAlphas);
    const std::size_t sets = std::max(lists_.furtherTexcoords.size(), mesh.furtherTexcoords.size());
    lists_.furtherTexcoords.resize(sets);
    for (std::size_t set = 0; set < sets; ++set) {
        const bool has = set < mesh.furtherTexcoords.size();
        addAttribute(lists_.furtherTexcoords[set], before, count,
                     has ? std::span<const Vec2>(mesh.furtherTexcoords[set]) : std::span<const Vec2>(),
                     Vec2{}, expectedVertices_);
    }
    add(lists_.positions, mesh.positions, Vec3{}, mesh.spare.positions);
    lists_.hasAttributes = lists_.hasAttributes || !isBare(mesh);
    lists_.hasTexcoords = lists_.hasTexcoords || !mesh.texcoords.empty();
    lists_.hasColours = lists_.hasColours || !mesh.colours.empty();
    lists_.hasAlphas = lists_.hasAlphas || !mesh.alphas.empty();
    addRun(lists_.bare, before + count, isBare(mesh) ? 1 : 0);
}

void MeshAssembler::add(const SourceMesh& mesh) {
    if (mesh.triangles.size() > kMaxTriangles - lists_.triangles.size()) refuseLarge();
    if (mesh.positions.size() > 3 * mesh.triangles.size()) return add(UsedVertices(mesh).mesh());
    addTriangles(mesh, measure(mesh));
    addVertices(mesh);
}

void MeshAssembler::weld() {
    rtcore::weld(std::move(lists_), welded_);
    const std::vector<Vertex>& vertices = welded_.vertices;
#pragma omp parallel if (vertices.size() > kFewTriangles)
    {
        Box3 bounds;
#pragma omp for schedule(static)
        for (std::size_t i = 0; i < vertices.size(); ++i) bounds.extend(vertices[i].position());
#pragma omp critical(rtcore_mesh_bounds)
        if (!bounds.empty()) bounds_.extend(bounds);
    }
}

void MeshAssembler::finish(ModelBuffers& model, float creaseAngle) {
    model.vertices = std::move(welded_.vertices);
    model.triangles = std::move(welded_.triangles);
    model.shading = std::move(welded_.shading);
    model.normals = std::move(welded_.normals);
    model.texcoords = std::move(welded_.texcoords);
    model.colours = std::move(welded_.colours);
    model.alphas = std::move(welded_.alphas);
    model.furtherTexcoords = std::move(welded_.furtherTexcoords);
    computeMissingNormals(model, creaseAngle);
}

} // namespace rtcore

#include "rtcore/io/import/mesh/mesh_assembly.h"

#include "rtcore/io/import/mesh/crease_normals.h"
#include "rtcore/io/import/mesh/equal_positions.h"
#include "rtcore/io/import/mesh/first_use.h"
#include "rtcore/io/import/mesh/hash.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/large_vector.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace rtcore {

namespace {

/// Corners are numbered in 32 bits.
constexpr std::size_t kMaxTriangles = std::size_t{1} << 30;
/// Not worth the threads.
constexpr std::size_t kFewTriangles = 20'000;
/// Triangles that are only copied.
constexpr std::size_t kManyTriangles = 1'000'000;
/// A mesh without normals, texture coordinates, colours and alphas.
bool isPlain(const SourceMesh& mesh) {
    return mesh.normals.empty() && mesh.texcoords.empty() && mesh.colours.empty() && mesh.alphas.empty();
}

/// In double, where differences and products of floats keep nearly all of their bits.
bool hasArea(Vec3 a, Vec3 b, Vec3 c) {
    const double ux = double{b.x} - a.x, uy = double{b.y} - a.y, uz = double{b.z} - a.z;
    const double vx = double{c.x} - a.x, vy = double{c.y} - a.y, vz = double{c.z} - a.z;
    return uy * vz - uz * vy != 0 || uz * vx - ux * vz != 0 || ux * vy - uy * vx != 0;
}

Vec2 finiteOrZero(Vec2 t) {
    constexpr float kLargestTexcoord = 1e12F;
    const auto fine = [](float v) { return std::fabs(v) <= kLargestTexcoord; };
    return {fine(t.x) ? t.x + 0.0F : 0.0F, fine(t.y) ? t.y + 0.0F : 0.0F};
}

Colour finiteOrWhite(Colour c) {
    if (!isFinite(c)) return kWhite;
    const auto clamped = [](float v) { return std::clamp(v, 0.0F, 1.0F) + 0.0F; };
    return {clamped(c.r), clamped(c.g), clamped(c.b)};
}

float finiteOrOne(float alpha) { return std::isfinite(alpha) ? std::clamp(alpha, 0.0F, 1.0F) + 0.0F : 1; }

} // namespace

void IndexTable::reserve(std::size_t elements) {
    const std::size_t size = std::bit_ceil(std::max<std::size_t>(elements * 2, 64));
    if (size <= slots_.size()) return;
    slots_.clear();
    resizeLarge(slots_, size);
    mask_ = size - 1;
    std::vector<std::uint64_t> hashes;
    hashes.swap(hashes_);
    reserveLarge(hashes_, elements);
    for (std::size_t i = 0; i < hashes.size(); ++i) insert(hashes[i], static_cast<std::uint32_t>(i));
}

void IndexTable::insert(std::uint64_t hash, std::uint32_t element) {
    if (hashes_.size() * 2 >= slots_.size()) reserve(std::max<std::size_t>(hashes_.size() * 2, 32));
    hashes_.push_back(hash);
    std::size_t i = hash & mask_;
    while (slots_[i].element != kNone) i = (i + 1) & mask_;
    slots_[i] = {element, static_cast<std::uint32_t>(hash >> 32)};
}

void MeshAssembler::reserve(std::size_t vertices, std::size_t triangles) {
    if (triangles > kMaxTriangles) {
        throw FileError(FailureKind::BadData, "", "it has more than 2^30 triangles; split the model");
    }
    reserveLarge(out_.triangles, triangles);
    reserveLarge(out_.shading, triangles);
    // Files without shared vertices have three in a triangle, of which about half a one is left.
    const std::size_t expected = std::min(vertices, triangles);
    reserveLarge(out_.vertices, expected);
}

/// The vertex at `p` of earlier meshes, or kNone; from a table that is filled when the next mesh comes.
std::uint32_t MeshAssembler::knownVertexAt(Vec3 p) {
    return vertices_.find(hashOfPosition(p),
                          [&](std::uint32_t i) { return out_.vertices[i].position() == p; });
}

void MeshAssembler::tabulateVertices() {
    vertices_.reserve(out_.vertices.size());
    for (std::size_t i = vertices_.size(); i < out_.vertices.size(); ++i)
        vertices_.insert(hashOfPosition(out_.vertices[i].position()), static_cast<std::uint32_t>(i));
}

std::uint32_t MeshAssembler::vertexAt(Vec3 p) {
    const std::uint32_t known = knownVertexAt(p);
    if (known != IndexTable::kNone) return known;
    out_.vertices.push_back({p.x, p.y, p.z, 0});
    return static_cast<std::uint32_t>(out_.vertices.size() - 1);
}

std::uint32_t MeshAssembler::appendEntry(std::uint32_t vertex, const Attributes& of) {
    vertexOfEntry_.push_back(vertex);
    out_.normals.push_back(of.normal);
    if (hasTexcoords_) out_.texcoords.push_back(of.texcoord);
    if (hasColours_) out_.colours.push_back(of.colour);
    if (hasAlphas_) out_.alphas.push_back(of.alpha);
    for (std::size_t set = 0; set < further_.size(); ++set) further_[set].push_back(cornerFurther_[set]);
    return static_cast<std::uint32_t>(out_.normals.size() - 1);
}

/// The entry of a vertex of a mesh that has only positions: no need to look for equals.
std::uint32_t MeshAssembler::plainEntryFor(std::uint32_t vertex) {
    if (plainEntry_.size() <= vertex) plainEntry_.resize(out_.vertices.capacity(), IndexTable::kNone);
    std::uint32_t& entry = plainEntry_[vertex];
    if (entry != IndexTable::kNone) return entry;
    std::ranges::fill(cornerFurther_, Vec2{});
    return entry = appendEntry(vertex, {});
}

std::uint64_t MeshAssembler::hashOf(std::uint32_t vertex, const Attributes& of) const {
    const auto& [normal, texcoord, colour, alpha] = of;
    std::uint64_t hash =
        mixedHash(mixedHash(vertex, bitsOfPair(normal.x, normal.y)), bitsOfPair(normal.z, texcoord.x));
    hash = mixedHash(mixedHash(hash, bitsOfPair(texcoord.y, colour.r)), bitsOfPair(colour.g, colour.b));
    if (hasAlphas_) hash = mixedHash(hash, bitsOfPair(alpha, 0));
    for (const Vec2 t : cornerFurther_) hash = mixedHash(hash, bitsOfPair(t.x, t.y));
    return finishedHash(hash);
}

MeshAssembler::Attributes MeshAssembler::attributesOf(std::uint32_t entry) const {
    return {out_.normals[entry], hasTexcoords_ ? out_.texcoords[entry] : Vec2{},
            hasColours_ ? out_.colours[entry] : kWhite, hasAlphas_ ? out_.alphas[entry] : 1};
}

void MeshAssembler::tabulate(std::uint64_t hash, std::uint32_t entry) {
    entries_.insert(hash, static_cast<std::uint32_t>(hashedEntries_.size()));
    hashedEntries_.push_back(entry);
}

/// Those that the last mesh had alone are not looked for before the next one comes.
void MeshAssembler::tabulateEntries() {
    for (const Range& range : untabulated_) {
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            takeFurtherOf(i);
            tabulate(hashOf(vertexOfEntry_[i], attributesOf(i)), i);
        }
    }
    untabulated_.clear();
}

std::uint32_t MeshAssembler::entryFor(std::uint32_t vertex, const Attributes& of) {
    const std::uint64_t hash = hashOf(vertex, of);
    const std::uint32_t known = entries_.find(hash, [&](std::uint32_t number) {
        const std::uint32_t i = hashedEntries_[number];
        return vertexOfEntry_[i] == vertex && out_.normals[i] == of.normal &&
               (!hasTexcoords_ || out_.texcoords[i] == of.texcoord) &&
               (!hasColours_ || out_.colours[i] == of.colour) &&
               (!hasAlphas_ || out_.alphas[i] == of.alpha) && hasFurther(i);
    });
    if (known != IndexTable::kNone) return hashedEntries_[known];
    const std::uint32_t entry = appendEntry(vertex, of);
    tabulate(hash, entry);
    return entry;
}

/// The entry of a vertex that nothing has used before and one corner of the mesh alone uses.
std::uint32_t MeshAssembler::onlyEntryFor(std::uint32_t vertex, const Attributes& of) {
    const std::uint32_t entry = appendEntry(vertex, of);
    if (untabulated_.empty() || untabulated_.back().end != entry) untabulated_.push_back({entry, entry});
    ++untabulated_.back().end;
    return entry;
}

void MeshAssembler::findAlone() {
    alone_.assign(firstOfEqual_.size(), 1);
    for (std::size_t i = 0; i < firstOfEqual_.size(); ++i)
        if (firstOfEqual_[i] != i) alone_[i] = alone_[firstOfEqual_[i]] = 0;
}

/// Classifies the triangles, and extends the bounds by all that are finite.
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
            if (uses[i] == Use::NonFinite) continue;
            for (const std::uint32_t v : t.v) bounds.extend(mesh.positions[v]);
        }
#pragma omp critical(rtcore_mesh_bounds)
        bounds_.extend(bounds);
    }
    return uses;
}

void MeshAssembler::addTriangle(const SourceMesh& mesh, const Triangle& t) {
    Triangle welded;
    ShadingTriangle shading;
    for (int i = 0; i < 3; ++i) {
        std::uint32_t& vertex = localVertex_[firstOfEqual_[t.v[i]]];
        if (vertex == IndexTable::kNone) vertex = vertexAt(withoutTraces(mesh.positions[t.v[i]]));
        welded.v[i] = vertex;
        shading.v[i] = entriesAreVertices_ ? vertex : entryOfCorner(mesh, t.v[i], vertex);
    }
    shading.material = mesh.material;
    out_.triangles.push_back(welded);
    out_.shading.push_back(shading);
}

/// The good triangles of a mesh, with other numbers for their corners.
std::vector<Triangle> MeshAssembler::renumbered(const SourceMesh& mesh, const std::vector<Use>& uses,
                                                const std::vector<std::uint32_t>& numbers) {
    const auto numbered = [&](const Triangle& t) {
        return Triangle{{numbers[t.v[0]], numbers[t.v[1]], numbers[t.v[2]]}};
    };
    const auto good = static_cast<std::size_t>(std::count(uses.begin(), uses.end(), Use::Good));
    std::vector<Triangle> list;
    resizeLarge(list, good);
    if (good == uses.size()) {
#pragma omp parallel for schedule(static) if (good > kManyTriangles)
        for (std::size_t i = 0; i < good; ++i) list[i] = numbered(mesh.triangles[i]);
        return list;
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (uses[i] == Use::Good) list[next++] = numbered(mesh.triangles[i]);
    }
    return list;
}

/// The good triangles of the first mesh, with the first of equal vertices as their corners.
void MeshAssembler::setTriangles(const SourceMesh& mesh, const std::vector<Use>& uses, bool maySpare) {
    const auto isGood = [](Use use) { return use == Use::Good; };
    if (!maySpare || mesh.spare == nullptr || !std::ranges::all_of(uses, isGood)) {
        out_.triangles = renumbered(mesh, uses, firstOfEqual_);
        return;
    }
    out_.triangles = std::move(*mesh.spare);
#pragma omp parallel for schedule(static) if (out_.triangles.size() > kManyTriangles)
    for (Triangle& t : out_.triangles)
        for (std::uint32_t& v : t.v) v = firstOfEqual_[v];
}

/// The first mesh: all its vertices and entries are new, in the order in which triangles come to them.
void MeshAssembler::addFirst(const SourceMesh& mesh, const std::vector<Use>& uses) {
    const std::vector<std::uint32_t> same =
        entriesAreVertices_ ? std::vector<std::uint32_t>() : firstOfSame(mesh);
    const std::size_t room = out_.triangles.capacity();
    setTriangles(mesh, uses, same.empty());
    reserveLarge(out_.triangles, room);
    const std::vector<std::uint32_t> order = renumberByFirstUse(out_.triangles, mesh.positions.size());
    const std::size_t good = out_.triangles.size();
    resizeLarge(out_.vertices, order.size());
    resizeLarge(out_.shading, good);
#pragma omp parallel for schedule(static) if (good > kManyTriangles)
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Vec3 p = withoutTraces(mesh.positions[order[i]]);
        out_.vertices[i] = {p.x, p.y, p.z, 0};
    }
    if (entriesAreVertices_) return shadeLike(out_.triangles, mesh.material);
    if (same.empty()) {
        shadeLike(out_.triangles, mesh.material);
        addFirstEntries(mesh, order);
    } else {
        std::vector<Triangle> corners = renumbered(mesh, uses, same);
        const std::vector<std::uint32_t> entries = renumberByFirstUse(corners, mesh.positions.size());
        shadeLike(corners, mesh.material);
        addFirstEntries(mesh, entries);
    }
}

/// Gives all triangles the entries that `corners` has.
void MeshAssembler::shadeLike(const std::vector<Triangle>& corners, std::uint32_t material) {
#pragma omp parallel for schedule(static) if (corners.size() > kManyTriangles)
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Triangle& t = corners[i];
        out_.shading[i] = {{t.v[0], t.v[1], t.v[2]}, material};
    }
}

/// For each vertex of a mesh the number of the first with its position and attributes; none where each is the
/// only one at its position.
std::vector<std::uint32_t> MeshAssembler::firstOfSame(const SourceMesh& mesh) {
    findAlone();
    if (std::ranges::find(alone_, 0) == alone_.end()) return {};
    std::vector<std::uint32_t> same, found;
    resizeLarge(same, firstOfEqual_.size());
    IndexTable table;
    for (std::uint32_t i = 0; i < same.size(); ++i) {
        same[i] = i;
        if (alone_[i] != 0) continue;
        const Attributes own = attributesAt(mesh, i);
        const std::uint64_t hash = hashOf(firstOfEqual_[i], own);
        const std::uint32_t known = table.find(hash, [&](std::uint32_t number) {
            const std::uint32_t j = found[number];
            return firstOfEqual_[j] == firstOfEqual_[i] && attributesAt(mesh, j) == own;
        });
        if (known != IndexTable::kNone) {
            same[i] = found[known];
        } else {
            table.insert(hash, static_cast<std::uint32_t>(found.size()));
            found.push_back(i);
        }
    }
    return same;
}

/// `corners`: the vertices of the mesh that entries are made of.
void MeshAssembler::addFirstEntries(const SourceMesh& mesh, const std::vector<std::uint32_t>& corners) {
    const std::size_t count = corners.size();
    resizeLarge(out_.normals, count);
    if (hasTexcoords_) resizeLarge(out_.texcoords, count);
    if (hasColours_) resizeLarge(out_.colours, count);
    if (hasAlphas_) resizeLarge(out_.alphas, count);
#pragma omp parallel for schedule(static) if (count > kManyTriangles)
    for (std::size_t i = 0; i < count; ++i) {
        const Attributes of = attributesAt(mesh, corners[i]);
        out_.normals[i] = of.normal;
        if (hasTexcoords_) out_.texcoords[i] = of.texcoord;
        if (hasColours_) out_.colours[i] = of.colour;
        if (hasAlphas_) out_.alphas[i] = of.alpha;
    }
    untabulated_.push_back({0, static_cast<std::uint32_t>(count)});
}

/// Which the first mesh left out.
void MeshAssembler::findVerticesOfEntries() {
    if (vertexOfEntry_.size() >= out_.normals.size()) return;
    resizeLarge(vertexOfEntry_, out_.normals.size());
    for (std::size_t t = 0; t < out_.triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) vertexOfEntry_[out_.shading[t].v[i]] = out_.triangles[t].v[i];
    }
}

/// As they go into entries.
MeshAssembler::Attributes MeshAssembler::attributesAt(const SourceMesh& mesh, std::size_t corner) {
    return {mesh.normals.empty() ? Vec3{} : normalize(mesh.normals[corner]),
            mesh.texcoords.empty() ? Vec2{} : finiteOrZero(mesh.texcoords[corner]),
            mesh.colours.empty() ? kWhite : finiteOrWhite(mesh.colours[corner]),
            mesh.alphas.empty() ? 1 : finiteOrOne(mesh.alphas[corner])};
}

std::uint32_t MeshAssembler::entryOfCorner(const SourceMesh& mesh, std::uint32_t corner,
                                           std::uint32_t vertex) {
    std::uint32_t& entry = localEntry_[corner];
    if (entry != IndexTable::kNone) return entry;
    if (isPlain(mesh)) return entry = plainEntryFor(vertex);
    const Attributes attributes = attributesAt(mesh, corner);
    takeFurther(mesh, corner);
    const bool only = alone_[corner] != 0 && vertex >= firstNewVertex_;
    return entry = only ? onlyEntryFor(vertex, attributes) : entryFor(vertex, attributes);
}

/// Sets cornerFurther_.
void MeshAssembler::takeFurther(const SourceMesh& mesh, std::uint32_t corner) {
    for (std::size_t set = 0; set < cornerFurther_.size(); ++set)
        cornerFurther_[set] =
            set < mesh.furtherTexcoords.size() ? finiteOrZero(mesh.furtherTexcoords[set][corner]) : Vec2{};
}

void MeshAssembler::takeFurtherOf(std::uint32_t entry) {
    for (std::size_t set = 0; set < further_.size(); ++set) cornerFurther_[set] = further_[set][entry];
}

bool MeshAssembler::hasFurther(std::uint32_t entry) const {
    for (std::size_t set = 0; set < further_.size(); ++set)
        if (further_[set][entry] != cornerFurther_[set]) return false;
    return true;
}

/// Those of vertices, so that others can follow.
void MeshAssembler::makeEntries() {
    const std::size_t count = out_.vertices.size();
    resizeLarge(vertexOfEntry_, count);
    std::iota(vertexOfEntry_.begin(), vertexOfEntry_.end(), 0U);
    plainEntry_ = vertexOfEntry_;
    resizeLarge(out_.normals, count);
    entriesAreVertices_ = false;
}

/// The first mesh with texture coordinates, colours or alphas gives them to all that came before.
void MeshAssembler::widen(const SourceMesh& mesh) {
    if (!mesh.texcoords.empty() && !hasTexcoords_) {
        hasTexcoords_ = true;
        out_.texcoords.resize(out_.normals.size());
    }
    if (!mesh.colours.empty() && !hasColours_) {
        hasColours_ = true;
        out_.colours.resize(out_.normals.size(), kWhite);
    }
    if (!mesh.alphas.empty() && !hasAlphas_) {
        hasAlphas_ = true;
        out_.alphas.resize(out_.normals.size(), 1);
    }
    if (mesh.furtherTexcoords.size() <= further_.size()) return;
    further_.resize(mesh.furtherTexcoords.size(), std::vector<Vec2>(out_.normals.size()));
    cornerFurther_.resize(further_.size());
}

void MeshAssembler::addFurther(const SourceMesh& mesh, const std::vector<Use>& uses) {
    const auto clear = [&](std::vector<std::uint32_t>& list) {
        reserveLarge(list, mesh.positions.size());
        list.assign(mesh.positions.size(), IndexTable::kNone);
    };
    clear(localVertex_);
    if (!entriesAreVertices_) clear(localEntry_);
    if (!isPlain(mesh)) findAlone();
    firstNewVertex_ = static_cast<std::uint32_t>(out_.vertices.size());
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (uses[i] == Use::Good) addTriangle(mesh, mesh.triangles[i]);
    }
}

void MeshAssembler::add(const SourceMesh& mesh) {
    if (mesh.triangles.size() > kMaxTriangles - out_.triangles.size()) {
        throw FileError(FailureKind::BadData, "", "it has more than 2^30 triangles; split the model");
    }
    if (entriesAreVertices_ && !isPlain(mesh)) makeEntries();
    if (!entriesAreVertices_) findVerticesOfEntries();
    tabulateEntries();
    widen(mesh);
    tabulateVertices();
    firstOfEqual_ = firstOfEqualPositions(mesh.positions);
    const std::vector<Use> uses = measure(mesh);
    if (out_.triangles.empty() && further_.empty() && (entriesAreVertices_ || !isPlain(mesh))) {
        addFirst(mesh, uses);
    } else {
        addFurther(mesh, uses);
    }
    nonFinite_ += static_cast<std::uint64_t>(std::count(uses.begin(), uses.end(), Use::NonFinite));
    degenerate_ += static_cast<std::uint64_t>(std::count(uses.begin(), uses.end(), Use::WithoutArea));
}

void MeshAssembler::finish(ModelBuffers& model, float creaseAngle) {
    model.vertices = std::move(out_.vertices);
    model.triangles = std::move(out_.triangles);
    model.shading = std::move(out_.shading);
    model.normals = std::move(out_.normals);
    model.texcoords = std::move(out_.texcoords);
    model.colours = std::move(out_.colours);
    model.alphas = std::move(out_.alphas);
    const std::size_t sets = further_.size();
    resizeLarge(model.furtherTexcoords, sets * model.normals.size());
    for (std::size_t set = 0; set < sets; ++set)
        for (std::size_t i = 0; i < further_[set].size(); ++i)
            model.furtherTexcoords[i * sets + set] = further_[set][i];
    further_ = {};
    vertexOfEntry_ = hashedEntries_ = plainEntry_ = {};
    firstOfEqual_ = localVertex_ = localEntry_ = {};
    alone_ = {};
    untabulated_ = {};
    vertices_ = entries_ = {};
    computeMissingNormals(model, creaseAngle);
}

} // namespace rtcore

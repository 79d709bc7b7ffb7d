#include "rtcore/io/import/mesh_assembly.h"

#include "rtcore/io/import/crease_normals.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace rtcore {

namespace {

/// Squares of distances up to here stay finite in float.
constexpr float kLargestCoordinate = 1e12F;
/// What is nearer to 0 is 0: in a model that is large enough to be traced it makes no difference, and numbers
/// that a processor is slow with do not come up.
constexpr float kLeastCoordinate = 1e-30F;
/// Corners are numbered in 32 bits.
constexpr std::size_t kMostTriangles = std::size_t{1} << 30;

std::uint64_t mix(std::uint64_t h, std::uint64_t value) {
    h = (h ^ value) * 0x9E3779B97F4A7C15ULL;
    return h ^ (h >> 32);
}
std::uint64_t bitsOf(float a, float b) {
    return (std::uint64_t{std::bit_cast<std::uint32_t>(a)} << 32) | std::bit_cast<std::uint32_t>(b);
}
std::uint64_t finished(std::uint64_t h) { return h * 0xD6E8FEB86659FD93ULL ^ (h >> 29); }

Vec3 withoutTraces(Vec3 p) {
    const auto clean = [](float v) { return std::fabs(v) < kLeastCoordinate ? 0.0F : v; };
    return {clean(p.x), clean(p.y), clean(p.z)};
}

bool usable(Vec3 p) {
    // False for NaN, too.
    return std::fabs(p.x) <= kLargestCoordinate && std::fabs(p.y) <= kLargestCoordinate &&
           std::fabs(p.z) <= kLargestCoordinate;
}

/// In double, where differences and products of floats keep nearly all of their bits.
bool hasArea(Vec3 a, Vec3 b, Vec3 c) {
    const double ux = double{b.x} - a.x, uy = double{b.y} - a.y, uz = double{b.z} - a.z;
    const double vx = double{c.x} - a.x, vy = double{c.y} - a.y, vz = double{c.z} - a.z;
    return uy * vz - uz * vy != 0 || uz * vx - ux * vz != 0 || ux * vy - uy * vx != 0;
}

Vec2 finiteOrZero(Vec2 t) {
    const auto fine = [](float v) { return std::fabs(v) <= kLargestCoordinate; };
    return {fine(t.x) ? t.x + 0.0F : 0.0F, fine(t.y) ? t.y + 0.0F : 0.0F};
}

Colour finiteOrWhite(Colour c) {
    if (!isFinite(c)) return kWhite;
    const auto clamped = [](float v) { return std::clamp(v, 0.0F, 1.0F) + 0.0F; };
    return {clamped(c.r), clamped(c.g), clamped(c.b)};
}

} // namespace

void IndexTable::reserve(std::size_t elements) {
    const std::size_t size = std::bit_ceil(std::max<std::size_t>(elements * 2, 64));
    if (size <= slots_.size()) return;
    slots_.assign(size, {});
    mask_ = size - 1;
    std::vector<std::uint64_t> hashes;
    hashes.swap(hashes_);
    hashes_.reserve(elements);
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
    if (triangles > kMostTriangles) {
        throw FileError(FailureKind::BadData, "", "it has more than 2^30 triangles; split the model");
    }
    out_.triangles.reserve(triangles);
    out_.shading.reserve(triangles);
    // Files without shared vertices have three in a triangle, of which about half a one is left.
    const std::size_t expected = std::min(vertices, triangles);
    out_.vertices.reserve(expected);
    vertices_.reserve(expected);
}

std::uint32_t MeshAssembler::vertexAt(Vec3 p) {
    const std::uint64_t hash = finished(mix(mix(0, bitsOf(p.x, p.y)), std::bit_cast<std::uint32_t>(p.z)));
    const std::uint32_t known =
        vertices_.find(hash, [&](std::uint32_t i) { return out_.vertices[i].position() == p; });
    if (known != IndexTable::kNone) return known;
    const auto index = static_cast<std::uint32_t>(out_.vertices.size());
    out_.vertices.push_back({p.x, p.y, p.z, 0});
    vertices_.insert(hash, index);
    return index;
}

std::uint32_t MeshAssembler::appendEntry(std::uint32_t vertex, Vec3 normal, Vec2 texcoord, Colour colour) {
    vertexOfEntry_.push_back(vertex);
    out_.normals.push_back(normal);
    if (hasTexcoords_) out_.texcoords.push_back(texcoord);
    if (hasColours_) out_.colours.push_back(colour);
    return static_cast<std::uint32_t>(out_.normals.size() - 1);
}

/// Of a mesh that has only positions, as scanned ones: no need to look for equals.
std::uint32_t MeshAssembler::plainEntryFor(std::uint32_t vertex) {
    if (plainEntry_.size() <= vertex) plainEntry_.resize(out_.vertices.capacity(), IndexTable::kNone);
    std::uint32_t& entry = plainEntry_[vertex];
    if (entry == IndexTable::kNone) entry = appendEntry(vertex, {}, {}, kWhite);
    return entry;
}

std::uint32_t MeshAssembler::entryFor(std::uint32_t vertex, Vec3 normal, Vec2 texcoord, Colour colour) {
    std::uint64_t hash = mix(mix(vertex, bitsOf(normal.x, normal.y)), bitsOf(normal.z, texcoord.x));
    hash = finished(mix(mix(hash, bitsOf(texcoord.y, colour.r)), bitsOf(colour.g, colour.b)));
    const std::uint32_t known = entries_.find(hash, [&](std::uint32_t number) {
        const std::uint32_t i = hashedEntries_[number];
        return vertexOfEntry_[i] == vertex && out_.normals[i] == normal &&
               (!hasTexcoords_ || out_.texcoords[i] == texcoord) &&
               (!hasColours_ || out_.colours[i] == colour);
    });
    if (known != IndexTable::kNone) return hashedEntries_[known];
    entries_.insert(hash, static_cast<std::uint32_t>(hashedEntries_.size()));
    hashedEntries_.push_back(appendEntry(vertex, normal, texcoord, colour));
    return hashedEntries_.back();
}

/// False, and counted, when the triangle is of no use.
bool MeshAssembler::weldTriangle(const SourceMesh& mesh, const Triangle& t, Triangle& welded) {
    const auto corner = [&](int i) { return withoutTraces(mesh.positions[t.v[i]]); };
    const Vec3 a = corner(0), b = corner(1), c = corner(2);
    if (!usable(a) || !usable(b) || !usable(c)) {
        ++nonFinite_;
        return false;
    }
    for (int i = 0; i < 3; ++i) bounds_.extend(mesh.positions[t.v[i]]);
    if (!hasArea(a, b, c)) {
        ++degenerate_;
        return false;
    }
    for (int i = 0; i < 3; ++i) {
        std::uint32_t& vertex = localVertex_[t.v[i]];
        if (vertex == IndexTable::kNone) vertex = vertexAt(corner(i));
        welded.v[i] = vertex;
    }
    return true;
}

std::uint32_t MeshAssembler::entryOfCorner(const SourceMesh& mesh, std::uint32_t corner,
                                           std::uint32_t vertex) {
    std::uint32_t& entry = localEntry_[corner];
    if (entry == IndexTable::kNone && mesh.normals.empty() && mesh.texcoords.empty() &&
        mesh.colours.empty()) {
        entry = plainEntryFor(vertex);
    } else if (entry == IndexTable::kNone) {
        entry = entryFor(vertex, mesh.normals.empty() ? Vec3{} : normalize(mesh.normals[corner]),
                         mesh.texcoords.empty() ? Vec2{} : finiteOrZero(mesh.texcoords[corner]),
                         mesh.colours.empty() ? kWhite : finiteOrWhite(mesh.colours[corner]));
    }
    return entry;
}

/// The first mesh with texture coordinates or colours gives them to all that came before.
void MeshAssembler::widen(const SourceMesh& mesh) {
    if (!mesh.texcoords.empty() && !hasTexcoords_) {
        hasTexcoords_ = true;
        out_.texcoords.resize(out_.normals.size());
    }
    if (!mesh.colours.empty() && !hasColours_) {
        hasColours_ = true;
        out_.colours.resize(out_.normals.size(), kWhite);
    }
}

void MeshAssembler::add(const SourceMesh& mesh) {
    if (mesh.triangles.size() > kMostTriangles - out_.triangles.size()) {
        throw FileError(FailureKind::BadData, "", "it has more than 2^30 triangles; split the model");
    }
    widen(mesh);
    localVertex_.assign(mesh.positions.size(), IndexTable::kNone);
    localEntry_.assign(mesh.positions.size(), IndexTable::kNone);
    for (const Triangle& t : mesh.triangles) {
        Triangle welded;
        if (!weldTriangle(mesh, t, welded)) continue;
        ShadingTriangle shading;
        for (int i = 0; i < 3; ++i) shading.v[i] = entryOfCorner(mesh, t.v[i], welded.v[i]);
        shading.material = mesh.material;
        out_.triangles.push_back(welded);
        out_.shading.push_back(shading);
    }
}

void MeshAssembler::finish(ModelBuffers& model, float creaseAngle) {
    model.vertices = std::move(out_.vertices);
    model.triangles = std::move(out_.triangles);
    model.shading = std::move(out_.shading);
    model.normals = std::move(out_.normals);
    model.texcoords = std::move(out_.texcoords);
    model.colours = std::move(out_.colours);
    vertexOfEntry_ = hashedEntries_ = plainEntry_ = {};
    vertices_ = entries_ = {};
    computeMissingNormals(model, creaseAngle);
}

} // namespace rtcore

#include "rtcore/io/import/obj/obj_meshes.h"

#include "rtcore/io/import/materials/colour_decoder.h"
#include "rtcore/platform/large_vector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

/// Some programs count colours from 0 to 255.
void decodeColours(std::vector<Colour>& colours) {
    const bool ofBytes = std::ranges::any_of(
        colours, [](Colour c) { return maxComponent(c) >= 2 && std::isfinite(maxComponent(c)); });
    const ColourDecoder decode(false);
    for (Colour& c : colours) c = decode(ofBytes ? Colour{c.r / 255, c.g / 255, c.b / 255} : c);
}

Vec2 placed(Vec2 t, const MtlLayout& layout) {
    return {t.x * layout.scale.x + layout.offset.x, t.y * layout.scale.y + layout.offset.y};
}

} // namespace

ObjMeshes::ObjMeshes(ObjModel& model) : model_(model) { decodeColours(model.colours); }

ObjMeshes::Corner ObjMeshes::cornerAt(std::size_t corner) const {
    const auto& [positions, texcoords, normals] = model_.corners;
    const auto known = [corner](const std::vector<std::uint32_t>& list, std::size_t count) {
        return corner < list.size() && list[corner] < count ? list[corner] : kNoIndex;
    };
    return {positions[corner], known(texcoords, model_.texcoords.size()),
            known(normals, model_.normals.size())};
}

std::uint32_t ObjMeshes::vertexOf(const Corner& corner) {
    constexpr int kSearched = 64; // of those at one position: fans have thousands
    std::uint32_t& newest = newest_[corner.position];
    std::uint32_t at = newest;
    for (int i = 0; at != kNoIndex && i < kSearched; at = known_[at].next, ++i)
        if (known_[at].texcoord == corner.texcoord && known_[at].normal == corner.normal) return at;
    known_.push_back({corner.texcoord, corner.normal, newest});
    positionOf_.push_back(corner.position);
    hasTexcoords_ = hasTexcoords_ || corner.texcoord != kNoIndex;
    hasNormals_ = hasNormals_ || corner.normal != kNoIndex;
    newest = static_cast<std::uint32_t>(known_.size() - 1);
    return newest;
}

void ObjMeshes::forgetVertices() {
    if (newest_.empty()) newest_.assign(model_.positions.size(), kNoIndex);
    for (const std::uint32_t position : positionOf_) newest_[position] = kNoIndex;
    known_.clear();
    positionOf_.clear();
    hasTexcoords_ = hasNormals_ = false;
}

void ObjMeshes::cutPolygon(std::size_t first, std::size_t size) {
    polygon_.clear();
    places_.clear();
    for (std::size_t i = 0; i < size; ++i) {
        polygon_.push_back(vertexOf(cornerAt(first + i)));
        places_.push_back(model_.positions[model_.corners.positions[first + i]]);
    }
    for (const Triangle& t : cutter_.cut(places_))
        triangles_.push_back({{polygon_[t.v[0]], polygon_[t.v[1]], polygon_[t.v[2]]}});
}

void ObjMeshes::readFace(std::size_t first, std::size_t size) {
    if (size < 3) {
        ++ignored_;
        return;
    }
    const auto begin = model_.corners.positions.begin() + static_cast<std::ptrdiff_t>(first);
    const auto outside = [this](std::uint32_t position) { return position >= model_.positions.size(); };
    if (std::any_of(begin, begin + static_cast<std::ptrdiff_t>(size), outside)) {
        unconnected_ += size - 2;
    } else if (size == 3) {
        const std::uint32_t a = vertexOf(cornerAt(first)), b = vertexOf(cornerAt(first + 1));
        triangles_.push_back({{a, b, vertexOf(cornerAt(first + 2))}});
    } else {
        cutPolygon(first, size);
    }
}

void ObjMeshes::readRun(const ObjRun& run) {
    std::size_t corner = run.firstCorner;
    for (std::size_t face = run.firstFace; face < run.endFace; ++face) {
        const std::size_t size = model_.sizes.empty() ? 3 : model_.sizes[face];
        readFace(corner, size);
        corner += size;
    }
}

/// Whether all of the model is this mesh of triangles, and each corner has one index for all that it names.
bool ObjMeshes::isIndexed(const ObjMesh& mesh) const {
    const auto& [positions, texcoords, normals] = model_.corners;
    const bool all = mesh.runs.size() == 1 && mesh.runs[0].endFace - mesh.runs[0].firstFace == model_.faces;
    const std::size_t count = model_.positions.size();
    const auto fits = [&positions, count](const std::vector<std::uint32_t>& list, std::size_t named) {
        return list.empty() || (named == count && list == positions);
    };
    return all && model_.sizes.empty() && fits(texcoords, model_.texcoords.size()) &&
           fits(normals, model_.normals.size()) &&
           std::ranges::all_of(positions, [count](std::uint32_t position) { return position < count; });
}

SourceMesh ObjMeshes::asItStands(const MtlLayout& layout) {
    static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));
    const auto& [positions, texcoords, normals] = model_.corners;
    const bool hasTexcoords = !texcoords.empty(), hasNormals = !normals.empty();
    model_.corners.texcoords = {};
    model_.corners.normals = {};
    for (Vec2& t : model_.texcoords) t = placed(t, layout);
    SourceMesh mesh{.positions = model_.positions, .colours = model_.colours};
    mesh.spare = {&model_.positions, &model_.normals, &model_.texcoords, nullptr};
    if (hasNormals) mesh.normals = model_.normals;
    if (hasTexcoords) mesh.texcoords = model_.texcoords;
    mesh.triangles = {reinterpret_cast<const Triangle*>(positions.data()), model_.faces};
    return mesh;
}

/// Of the vertices of the mesh at hand.
void ObjMeshes::gatherVertices(const MtlLayout& layout) {
    const std::size_t count = known_.size();
    resizeLarge(positions_, count);
    resizeLarge(normals_, hasNormals_ ? count : 0);
    resizeLarge(texcoords_, hasTexcoords_ ? count : 0);
    resizeLarge(colours_, model_.colours.empty() ? 0 : count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t position = positionOf_[i];
        const auto& [texcoord, normal, next] = known_[i];
        positions_[i] = model_.positions[position];
        if (hasNormals_) normals_[i] = normal == kNoIndex ? Vec3{} : model_.normals[normal];
        if (hasTexcoords_)
            texcoords_[i] = placed(texcoord == kNoIndex ? Vec2{} : model_.texcoords[texcoord], layout);
        if (!colours_.empty()) colours_[i] = model_.colours[position];
    }
}

void ObjMeshes::releaseModel() {
    model_.positions = model_.normals = {};
    model_.texcoords = {};
    model_.colours = {};
    model_.corners = {};
    model_.sizes = {};
    newest_ = positionOf_ = {};
    known_ = {};
}

SourceMesh ObjMeshes::read(const ObjMesh& mesh, const MtlLayout& layout, bool last) {
    if (last && isIndexed(mesh)) return asItStands(layout);
    forgetVertices();
    triangles_.clear();
    std::size_t corners = 0;
    for (const ObjRun& run : mesh.runs) corners += run.endCorner - run.firstCorner;
    if (model_.sizes.empty()) reserveLarge(triangles_, corners / 3);
    for (const ObjRun& run : mesh.runs) readRun(run);
    gatherVertices(layout);
    if (last) releaseModel();
    SourceMesh source{positions_, normals_, texcoords_, colours_, {}, triangles_};
    source.spare = {&positions_, &normals_, &texcoords_, &triangles_};
    return source;
}

} // namespace rtcore

#include "rtcore/io/import/mesh/polygon.h"
#include "rtcore/io/import/scan/ply_elements.h"
#include "rtcore/io/import/scan/ply_file.h"
#include "rtcore/io/import/scan/ply_rows.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace rtcore {

namespace {

bool isIndexList(const PlyProperty& property) {
    const auto isWhole = [](PlyType type) { return type != PlyType::Float32 && type != PlyType::Float64; };
    return property.listLength && isWhole(*property.listLength) && isWhole(property.type) &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Where an element that names vertices has its list, and its colour.
struct FaceFields {
    explicit FaceFields(const PlyElement& element) {
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            if (isIndexList(element.properties[i])) list = i;
            if (const auto part = plyColourComponent(element.properties[i])) colour[*part] = i;
        }
    }
    bool hasColour() const {
        return std::ranges::any_of(colour, [](const auto& part) { return part.has_value(); });
    }
    std::optional<std::size_t> list;
    std::array<std::optional<std::size_t>, 3> colour;
};

class PlyMeshReader {
  public:
    explicit PlyMeshReader(const LocalOrigin& origin) { mesh_.origin = origin; }

    void add(const PlyElement& element, const PlyRow& row) {
        if (element.name == "vertex") {
            if (!vertices_) vertices_.emplace(element, mesh_);
            vertices_->add(row.numbers);
            return;
        }
        const bool strips = element.name == "tristrips";
        if (element.name != "face" && !strips) return;
        if (&element != last_) fields_.emplace(element);
        last_ = &element;
        if (!fields_->list) return;
        const std::size_t before = mesh_.triangles.size();
        if (strips) {
            addStrips(row.lists[*fields_->list]);
        } else {
            addFace(row.lists[*fields_->list]);
        }
        if (!fields_->hasColour()) return;
        Colour colour;
        float* const parts[] = {&colour.r, &colour.g, &colour.b};
        for (std::size_t i = 0; i < 3; ++i) {
            if (const auto property = fields_->colour[i])
                *parts[i] = plyFraction(element.properties[*property].type, row.numbers[*property]);
        }
        colours_.resize(before, kWhite);
        colours_.resize(mesh_.triangles.size(), decode_(colour));
    }

    ScanMesh finish() {
        if (!colours_.empty() && mesh_.colours.empty()) partTriangles();
        return std::move(mesh_);
    }

  private:
    std::optional<std::uint32_t> vertexAt(double index) const {
        const bool there = index >= 0 && index < static_cast<double>(mesh_.positions.size());
        return there ? std::optional(static_cast<std::uint32_t>(index)) : std::nullopt;
    }

    void addFace(const std::vector<double>& list) {
        if (list.size() < 3) {
            ++mesh_.ignoredPrimitives;
            return;
        }
        corners_.clear();
        places_.clear();
        for (const double index : list) {
            const auto vertex = vertexAt(index);
            if (!vertex) {
                mesh_.unconnectedTriangles += list.size() - 2;
                return;
            }
            corners_.push_back(*vertex);
            places_.push_back(mesh_.positions[*vertex]);
        }
        for (const Triangle& t : cutter_.cut(places_))
            mesh_.triangles.push_back({{corners_[t.v[0]], corners_[t.v[1]], corners_[t.v[2]]}});
    }

    /// Each corner from the third on makes a triangle with the two before, of which every other is turned; a
    /// number below 0 ends a strip.
    void addStrips(const std::vector<double>& list) {
        std::size_t first = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (list[i] < 0) {
                first = i + 1;
                continue;
            }
            if (i < first + 2) continue;
            const auto a = vertexAt(list[i - 2]), b = vertexAt(list[i - 1]), c = vertexAt(list[i]);
            if (!a || !b || !c) {
                ++mesh_.unconnectedTriangles;
            } else if ((i - first) % 2 == 0) {
                mesh_.triangles.push_back({{*a, *b, *c}});
            } else {
                mesh_.triangles.push_back({{*b, *a, *c}});
            }
        }
    }

    /// Gives each triangle vertices of its own, with its colour.
    void partTriangles() {
        colours_.resize(mesh_.triangles.size(), kWhite);
        ScanMesh parted;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            for (std::uint32_t& v : mesh_.triangles[t].v) {
                parted.positions.push_back(mesh_.positions[v]);
                if (!mesh_.normals.empty()) parted.normals.push_back(mesh_.normals[v]);
                if (!mesh_.texcoords.empty()) parted.texcoords.push_back(mesh_.texcoords[v]);
                parted.colours.push_back(colours_[t]);
                v = static_cast<std::uint32_t>(parted.positions.size() - 1);
            }
        }
        mesh_.positions = std::move(parted.positions);
        mesh_.normals = std::move(parted.normals);
        mesh_.texcoords = std::move(parted.texcoords);
        mesh_.colours = std::move(parted.colours);
    }

    ScanMesh mesh_;
    std::optional<PlyVertexRows> vertices_;
    const PlyElement* last_ = nullptr;
    std::optional<FaceFields> fields_;
    std::vector<Colour> colours_; ///< of triangles
    std::vector<std::uint32_t> corners_;
    std::vector<Vec3> places_;
    PolygonCutter cutter_;
    ColourDecoder decode_{false};
};

} // namespace

bool hasFaceColours(const PlyHeader& header) {
    return std::ranges::any_of(
        header.elements, [](const PlyElement& e) { return e.name == "face" && FaceFields(e).hasColour(); });
}

bool isPlyMesh(const PlyHeader& header) {
    bool hasVertices = false;
    for (const PlyElement& element : header.elements) {
        if (areScanVertices(element)) {
            hasVertices = true;
        } else if (element.name == "vertex" || element.name == "material") {
            return false;
        } else if (element.name == "face" || element.name == "tristrips") {
            const auto isOther = [](const PlyProperty& p) { return p.listLength && !isIndexList(p); };
            if (!hasVertices || std::ranges::any_of(element.properties, isOther)) return false;
        }
    }
    return hasVertices;
}

ScanMesh readPlyMesh(const InputFile& file, const PlyHeader& header, const LocalOrigin& origin,
                     const std::function<void()>& alive) {
    PlyMeshReader reader(origin);
    readPlyRows(file, header, alive,
                [&](const PlyElement& element, const PlyRow& row) { reader.add(element, row); });
    return reader.finish();
}

} // namespace rtcore

/// Many meshes into the flat arrays of a model.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/scene/model.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// One mesh where it stands in the scene. All spans but `positions` and `triangles` may be empty, else they
/// are as long as `positions`.
struct SourceMesh {
    std::span<const Vec3> positions = {}; ///< any floats
    std::span<const Vec3> normals = {};   ///< any length; zero or not finite = to be computed
    std::span<const Vec2> texcoords = {}; ///< (0, 0) = lower left of the image
    std::span<const Colour> colours = {}; ///< linear
    std::span<const float> alphas = {};
    std::span<const Triangle> triangles = {}; ///< indices below positions.size(); the caller has checked
    std::uint32_t material = 0;
    /// Of further sets; at most kMaxFurtherSets, where there are `texcoords`.
    std::span<const std::vector<Vec2>> furtherTexcoords = {};
    std::vector<Triangle>* spare = nullptr; ///< the list of all of them, where the caller needs it no more
};

/// An open hash table of numbers of elements that live elsewhere. It grows; nothing is ever removed.
class IndexTable {
  public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    /// The element with this hash for which `same` holds, else kNone.
    template <typename Same>
    std::uint32_t find(std::uint64_t hash, Same same) const {
        if (slots_.empty()) return kNone;
        for (std::size_t i = hash & mask_;; i = (i + 1) & mask_) {
            if (slots_[i].element == kNone) return kNone;
            if (slots_[i].hash == static_cast<std::uint32_t>(hash >> 32) && same(slots_[i].element)) {
                return slots_[i].element;
            }
        }
    }
    /// Elements come in the order of their numbers: 0, 1, 2...
    void insert(std::uint64_t hash, std::uint32_t element);
    void reserve(std::size_t elements);
    std::size_t size() const { return hashes_.size(); }

  private:
    struct Slot {
        std::uint32_t element = kNone, hash = 0; ///< the upper half of its hash
    };
    std::vector<Slot> slots_;
    std::vector<std::uint64_t> hashes_; ///< of every element
    std::size_t mask_ = 0;
};

/// Welds vertices whose positions are equal (what is nearer to 0 than 1e-30 is 0), so that neighbours share
/// them; keeps the order of triangles; drops and counts triangles without area and those with a coordinate
/// that is no number or beyond 1e12. Entries of normals, texture coordinates of all sets, colours and alphas
/// are shared where all of them are equal. By the threads of OpenMP for large meshes; the result does not
/// depend on them.
class MeshAssembler {
  public:
    void reserve(std::size_t vertices, std::size_t triangles);
    void add(const SourceMesh& mesh);
    std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(out_.triangles.size()); }
    /// Fills the geometry of `model`; computes the normals that are missing (crease_normals.h). Call it once.
    void finish(ModelBuffers& model, float creaseAngle);

    /// So far, welded; the first mesh of positions alone may have none yet.
    std::span<const Vertex> vertices() const { return out_.vertices; }
    /// The bounds of all finite triangles added, even without area, and before small numbers become 0.
    const Box3& bounds() const { return bounds_; }
    std::uint64_t degenerateTriangles() const { return degenerate_; }
    std::uint64_t nonFiniteTriangles() const { return nonFinite_; }

  private:
    enum class Use : std::uint8_t { Good, NonFinite, WithoutArea };
    /// The attributes of a corner other than its position.
    struct Attributes {
        Vec3 normal;
        Vec2 texcoord;
        Colour colour = kWhite;
        float alpha = 1;
        friend bool operator==(const Attributes&, const Attributes&) = default;
    };
    static Attributes attributesAt(const SourceMesh& mesh, std::size_t corner);
    std::vector<Use> measure(const SourceMesh& mesh);
    static std::vector<Triangle> renumbered(const SourceMesh& mesh, const std::vector<Use>& uses,
                                            const std::vector<std::uint32_t>& numbers);
    void setTriangles(const SourceMesh& mesh, const std::vector<Use>& uses, bool maySpare);
    void addFirst(const SourceMesh& mesh, const std::vector<Use>& uses);
    void shadeLike(const std::vector<Triangle>& corners, std::uint32_t material);
    std::vector<std::uint32_t> firstOfSame(const SourceMesh& mesh);
    void addFirstEntries(const SourceMesh& mesh, const std::vector<std::uint32_t>& corners);
    void findVerticesOfEntries();
    void addFurther(const SourceMesh& mesh, const std::vector<Use>& uses);
    void addTriangle(const SourceMesh& mesh, const Triangle& t);
    std::uint32_t knownVertexAt(Vec3 p);
    std::uint32_t vertexAt(Vec3 p);
    void tabulateVertices();
    void tabulateEntries();
    void findAlone();
    std::uint32_t plainEntryFor(std::uint32_t vertex);
    std::uint32_t appendEntry(std::uint32_t vertex, const Attributes& attributes);
    std::uint32_t entryFor(std::uint32_t vertex, const Attributes& attributes);
    std::uint32_t onlyEntryFor(std::uint32_t vertex, const Attributes& attributes);
    void tabulate(std::uint64_t hash, std::uint32_t entry);
    std::uint64_t hashOf(std::uint32_t vertex, const Attributes& attributes) const;
    Attributes attributesOf(std::uint32_t entry) const;
    std::uint32_t entryOfCorner(const SourceMesh& mesh, std::uint32_t corner, std::uint32_t vertex);
    void widen(const SourceMesh& mesh);
    void takeFurther(const SourceMesh& mesh, std::uint32_t corner);
    void takeFurtherOf(std::uint32_t entry);
    bool hasFurther(std::uint32_t entry) const;
    void makeEntries();

    ModelBuffers out_;
    /// All meshes so far have only positions, as scanned ones: entries are vertices, and none is stored yet.
    bool entriesAreVertices_ = true;
    std::vector<std::uint32_t> vertexOfEntry_;
    std::vector<std::uint32_t> hashedEntries_; ///< entries by their number in `entries_`
    IndexTable vertices_, entries_;
    struct Range {
        std::uint32_t begin, end;
    };
    std::vector<Range> untabulated_;        ///< entries that are not in `entries_` yet
    std::vector<std::uint32_t> plainEntry_; ///< by vertex: the one with nothing of its own, if there is one
    /// Indexed by the own vertices of the mesh being added; numbers in the model are kNone until a triangle
    /// needs them.
    std::vector<std::uint32_t> firstOfEqual_, localVertex_, localEntry_;
    std::vector<std::uint8_t> alone_;  ///< no other vertex of the mesh has this position
    std::uint32_t firstNewVertex_ = 0; ///< in the model: of those that the mesh being added brought
    /// In each further set, of the corner that an entry is looked for or made for.
    std::vector<Vec2> cornerFurther_;
    std::vector<std::vector<Vec2>> further_; ///< by set
    bool hasTexcoords_ = false, hasColours_ = false, hasAlphas_ = false;
    Box3 bounds_;
    std::uint64_t degenerate_ = 0, nonFinite_ = 0;
};

} // namespace rtcore

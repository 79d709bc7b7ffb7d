#include "rtcore/io/import/mesh/equal_positions.h"
#include "rtcore/io/import/mesh/first_use.h"
#include "rtcore/io/import/mesh/hash.h"
#include "rtcore/io/import/mesh/mesh_lists.h"
#include "rtcore/platform/large_vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace rtcore {

namespace {

/// Elements that are only copied.
constexpr std::size_t kManyElements = 1'000'000;

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

/// The attributes of a corner other than its position.
struct Attributes {
    Vec3 normal;
    Vec2 texcoord;
    Colour colour = kWhite;
    float alpha = 1;
    friend bool operator==(const Attributes&, const Attributes&) = default;
};

class Welder {
  public:
    Welder(MeshLists& from, ModelBuffers& to) : from_(from), to_(to) {}

    void run() {
        const std::size_t count = from_.positions.size();
        firstOfEqual_ = firstOfEqualPositions(from_.positions);
        std::vector<Triangle> corners; // where they are not those of vertices
        if (from_.hasAttributes && !firstOfEqual_.empty()) corners = renumbered(firstOfSameCorners());
        if (!firstOfEqual_.empty()) renumber(from_.triangles, firstOfEqual_);
        firstOfEqual_ = {};
        std::vector<std::uint32_t> order = renumberByFirstUse(from_.triangles, count);
        setVertices(order);
        if (!corners.empty()) order = renumberByFirstUse(corners, count);
        shadeLike(corners.empty() ? from_.triangles : corners);
        if (from_.hasAttributes) setEntries(order);
        to_.triangles = std::move(from_.triangles);
    }

  private:
    std::vector<Triangle> renumbered(const std::vector<std::uint32_t>& numbers) const {
        std::vector<Triangle> list;
        resizeLarge(list, from_.triangles.size());
#pragma omp parallel for schedule(static) if (list.size() > kManyElements)
        for (std::size_t i = 0; i < list.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) list[i].v[k] = numbers[from_.triangles[i].v[k]];
        return list;
    }

    static void renumber(std::vector<Triangle>& list, const std::vector<std::uint32_t>& numbers) {
#pragma omp parallel for schedule(static) if (list.size() > kManyElements)
        for (Triangle& t : list)
            for (std::uint32_t& v : t.v) v = numbers[v];
    }

    /// `order`: the vertices of the file that those of the model are made of.
    void setVertices(const std::vector<std::uint32_t>& order) {
        resizeLarge(to_.vertices, order.size());
#pragma omp parallel for schedule(static) if (order.size() > kManyElements)
        for (std::size_t i = 0; i < order.size(); ++i) {
            const Vec3 p = withoutTraces(from_.positions[order[i]]);
            to_.vertices[i] = {p.x, p.y, p.z, 0};
        }
        from_.positions = {};
    }

    /// Gives all triangles the entries that `corners` has.
    void shadeLike(const std::vector<Triangle>& corners) {
        resizeLarge(to_.shading, corners.size());
        std::size_t begin = 0;
        for (const MeshLists::Run& run : from_.materials) {
#pragma omp parallel for schedule(static) if (run.end - begin > kManyElements)
            for (std::size_t i = begin; i < run.end; ++i) {
                const Triangle& t = corners[i];
                to_.shading[i] = {{t.v[0], t.v[1], t.v[2]}, run.value};
            }
            begin = run.end;
        }
    }

    /// As they go into entries.
    Attributes attributesAt(std::size_t corner) const {
        const auto at = [corner](const auto& list, auto usual) {
            return list.empty() ? usual : list[corner];
        };
        return {normalize(at(from_.normals, Vec3{})), finiteOrZero(at(from_.texcoords, Vec2{})),
                finiteOrWhite(at(from_.colours, kWhite)), finiteOrOne(at(from_.alphas, 1.0F))};
    }
    Vec2 furtherAt(const std::vector<Vec2>& set, std::size_t corner) const {
        return set.empty() ? Vec2{} : finiteOrZero(set[corner]);
    }

    /// `corners`: the vertices of the file that entries are made of.
    void setEntries(const std::vector<std::uint32_t>& corners) {
        const std::size_t count = corners.size(), sets = from_.furtherTexcoords.size();
        resizeLarge(to_.normals, count);
        if (from_.hasTexcoords) resizeLarge(to_.texcoords, count);
        if (from_.hasColours) resizeLarge(to_.colours, count);
        if (from_.hasAlphas) resizeLarge(to_.alphas, count);
        resizeLarge(to_.furtherTexcoords, count * sets);
#pragma omp parallel for schedule(static) if (count > kManyElements)
        for (std::size_t i = 0; i < count; ++i) {
            const Attributes of = attributesAt(corners[i]);
            to_.normals[i] = of.normal;
            if (from_.hasTexcoords) to_.texcoords[i] = of.texcoord;
            if (from_.hasColours) to_.colours[i] = of.colour;
            if (from_.hasAlphas) to_.alphas[i] = of.alpha;
            for (std::size_t set = 0; set < sets; ++set)
                to_.furtherTexcoords[i * sets + set] = furtherAt(from_.furtherTexcoords[set], corners[i]);
        }
    }

    /// By vertex: 1 for those of bare meshes, which share their entries among themselves alone.
    std::vector<std::uint8_t> bareVertices() const {
        std::vector<std::uint8_t> bare;
        for (const MeshLists::Run& run : from_.bare)
            bare.resize(run.end, static_cast<std::uint8_t>(run.value));
        return bare;
    }

    /// What tells a corner from others at its position.
    struct Corner {
        std::uint32_t number;
        std::uint8_t bare;
        Attributes attributes;
    };
    bool same(const Corner& a, const Corner& b) const {
        return a.bare == b.bare && a.attributes == b.attributes &&
               std::ranges::all_of(from_.furtherTexcoords, [&](const std::vector<Vec2>& set) {
                   return furtherAt(set, a.number) == furtherAt(set, b.number);
               });
    }

    std::uint64_t hashOf(const Corner& corner) const {
        const auto& [normal, texcoord, colour, alpha] = corner.attributes;
        std::uint64_t hash =
            mixedHash(mixedHash(0, bitsOfPair(normal.x, normal.y)), bitsOfPair(normal.z, texcoord.x));
        hash = mixedHash(mixedHash(hash, bitsOfPair(texcoord.y, colour.r)), bitsOfPair(colour.g, colour.b));
        hash = mixedHash(hash, bitsOfPair(alpha, 0));
        for (const std::vector<Vec2>& set : from_.furtherTexcoords) {
            const Vec2 t = furtherAt(set, corner.number);
            hash = mixedHash(hash, bitsOfPair(t.x, t.y));
        }
        return finishedHash(hash);
    }

    /// By vertex: the next one with its position, ascending; 0 behind the last.
    std::vector<std::uint32_t> nextWithPosition() const {
        std::vector<std::uint32_t> next;
        resizeLarge(next, firstOfEqual_.size());
        for (std::size_t i = next.size(); i-- > 0;) {
            const std::uint32_t first = firstOfEqual_[i];
            if (first != i) next[i] = std::exchange(next[first], static_cast<std::uint32_t>(i));
        }
        return next;
    }

    /// Of the vertices with the position of `first`: for each the first that is the same corner.
    void matchCorners(std::uint32_t first, const std::vector<std::uint32_t>& next,
                      const std::vector<std::uint8_t>& bare, std::vector<std::uint32_t>& firstSame) const {
        constexpr std::size_t kSearched = 8; // different ones; others are found by their hashes
        const auto cornerOf = [&](std::uint32_t i) { return Corner{i, bare[i], attributesAt(i)}; };
        std::array<Corner, kSearched> different{cornerOf(first)};
        std::size_t count = 1;
        std::unordered_multimap<std::uint64_t, Corner> others;
        for (std::uint32_t i = next[first]; i != 0; i = next[i]) {
            const Corner corner = cornerOf(i);
            const auto isSame = [&](const Corner& other) { return same(other, corner); };
            const auto end = different.begin() + static_cast<std::ptrdiff_t>(count);
            if (const auto at = std::find_if(different.begin(), end, isSame); at != end) {
                firstSame[i] = at->number;
            } else if (count < kSearched) {
                different[count++] = corner;
            } else {
                const std::uint64_t hash = hashOf(corner);
                const auto [from, to] = others.equal_range(hash);
                const auto known =
                    std::find_if(from, to, [&](const auto& each) { return isSame(each.second); });
                if (known != to) {
                    firstSame[i] = known->second.number;
                } else {
                    others.emplace(hash, corner);
                }
            }
        }
    }

    /// For each vertex the number of the first with its position and attributes.
    std::vector<std::uint32_t> firstOfSameCorners() const {
        const std::vector<std::uint8_t> bare = bareVertices();
        const std::vector<std::uint32_t> next = nextWithPosition();
        std::vector<std::uint32_t> first;
        resizeLarge(first, next.size());
        std::iota(first.begin(), first.end(), 0U);
#pragma omp parallel for schedule(static) if (first.size() > kManyElements)
        for (std::size_t i = 0; i < first.size(); ++i)
            if (next[i] != 0 && firstOfEqual_[i] == i)
                matchCorners(static_cast<std::uint32_t>(i), next, bare, first);
        return first;
    }

    MeshLists& from_;
    ModelBuffers& to_;
    std::vector<std::uint32_t> firstOfEqual_; ///< empty: all positions differ
};

} // namespace

void weld(MeshLists lists, ModelBuffers& model) { Welder(lists, model).run(); }

} // namespace rtcore

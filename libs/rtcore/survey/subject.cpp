#include "rtcore/survey/subject.h"

#include "rtcore/scene/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

constexpr std::size_t kMaxTriangles = 8'000'000; ///< what is larger is scanned, not modelled
constexpr std::size_t kMaxSurroundings = 64;     ///< pieces: tiles of a ground, sides of a sky
constexpr float kWider = 2.5F;                   ///< than what stands on it
constexpr float kFlatGround = 0.2F;              ///< height of a ground, of its width
constexpr float kPlot = 15;                      ///< metres: no thing that lies flat is as wide
constexpr float kSkyWide = 60;                   ///< metres: no room is as wide, and as empty
constexpr std::size_t kFewest = 8;               ///< triangles of what anything is about

/// Triangles that hang together.
struct Piece {
    Box3 bounds;
    std::uint32_t number = 0;
    std::size_t triangles = 0;
    double upwards = 0, downwards = 0; ///< area of its faces, seen from above
};

float widthOf(const Box3& box, const Axes& axes) {
    return std::max(extentAlong(box, axes.right), extentAlong(box, axes.front));
}

/// The widest first. Sets `pieceOf` to the number of each triangle's piece.
std::vector<Piece> piecesOf(const Mesh& mesh, const Axes& axes, std::vector<std::uint32_t>& pieceOf) {
    pieceOf.resize(mesh.triangles.size());
    DisjointSets sets(mesh.vertices.size());
    for (const Triangle& t : mesh.triangles) {
        sets.join(t.v[0], t.v[1]);
        sets.join(t.v[0], t.v[2]);
    }
    constexpr std::uint32_t kNone = 0xFFFFFFFFU;
    std::vector<std::uint32_t> number(mesh.vertices.size(), kNone);
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto id = static_cast<std::uint32_t>(i);
        std::uint32_t& of = number[sets.find(mesh.triangles[i].v[0])];
        if (of == kNone) {
            of = static_cast<std::uint32_t>(pieces.size());
            pieces.emplace_back().number = of;
        }
        pieceOf[i] = of;
        Piece& piece = pieces[of];
        ++piece.triangles;
        for (int corner = 0; corner < 3; ++corner) piece.bounds.extend(mesh.position(id, corner));
        const double area = double{dot(mesh.geometricNormal(id), axes.up)};
        (area > 0 ? piece.upwards : piece.downwards) += std::fabs(area);
    }
    std::stable_sort(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
        return widthOf(a.bounds, axes) > widthOf(b.bounds, axes);
    });
    return pieces;
}

/// `inner` within `outer` along the axis, but for `slack`.
bool holds(const Box3& outer, const Box3& inner, Vec3 axis, float slack) {
    const Range o = rangeAlong(outer, axis), i = rangeAlong(inner, axis);
    return i.low >= o.low - slack && i.high <= o.high + slack;
}

bool isGroundOf(const Piece& piece, const Box3& rest, const Axes& axes) {
    const float width = widthOf(piece.bounds, axes), height = extentAlong(piece.bounds, axes.up);
    if (height > kFlatGround * width || width < kWider * widthOf(rest, axes)) return false;
    // A sheet faces one way only, or is wider than any thing.
    const bool sheet = std::min(piece.upwards, piece.downwards) < 0.01 * (piece.upwards + piece.downwards);
    if (!sheet && width < kPlot * axes.metre) return false;
    const float slack = 0.5F * widthOf(rest, axes);
    const Range ground = rangeAlong(piece.bounds, axes.up), thing = rangeAlong(rest, axes.up);
    return thing.high > ground.low && thing.low < ground.high + slack &&
           holds(piece.bounds, rest, axes.right, slack) && holds(piece.bounds, rest, axes.front, slack);
}

bool isDomeOf(const Piece& piece, const Box3& rest, const Axes& axes) {
    const float width = widthOf(piece.bounds, axes);
    if (width < kWider * widthOf(rest, axes) || width < kSkyWide * axes.metre) return false;
    const float slack = 0.05F * width;
    const Range sky = rangeAlong(piece.bounds, axes.up), thing = rangeAlong(rest, axes.up);
    return sky.high - sky.low > kFlatGround * width && thing.high < sky.high && thing.low > sky.low - slack &&
           holds(piece.bounds, rest, axes.right, 0) && holds(piece.bounds, rest, axes.front, 0);
}

/// Flat, below the rest, and somewhat wider.
bool isPlotOf(const Piece& piece, const Box3& rest, const Axes& axes) {
    constexpr float kReaches = 1.15F;
    const float width = widthOf(piece.bounds, axes);
    if (extentAlong(piece.bounds, axes.up) > kFlatGround * width || width < kReaches * widthOf(rest, axes))
        return false;
    const Range plot = rangeAlong(piece.bounds, axes.up), thing = rangeAlong(rest, axes.up);
    return (plot.low + plot.high) / 2 < (thing.low + thing.high) / 2 && thing.high > plot.high &&
           holds(piece.bounds, rest, axes.right, 0) && holds(piece.bounds, rest, axes.front, 0);
}

/// The bounds of what stands on the widest of the pieces, if that is a plot; else of all.
Box3 standingOn(std::span<const Piece> pieces, const Box3& bulk, const Axes& axes) {
    if (pieces.empty()) return bulk;
    Box3 rest;
    std::size_t triangles = 0;
    for (const Piece& piece : pieces.subspan(1)) {
        rest.extend(piece.bounds);
        triangles += piece.triangles;
    }
    return triangles >= kFewest && isPlotOf(pieces.front(), rest, axes) ? rest : bulk;
}

/// The number of pieces, from the widest on, that are surroundings of the others; Subject::domes becomes the
/// numbers of those that are skies.
std::size_t surroundingsOf(std::span<const Piece> pieces, const Axes& axes, Subject& subject) {
    std::vector<Box3> rest(pieces.size() + 1);
    std::vector<std::size_t> triangles(pieces.size() + 1, 0);
    for (std::size_t i = pieces.size(); i-- > 0;) {
        rest[i] = rest[i + 1];
        rest[i].extend(pieces[i].bounds);
        triangles[i] = triangles[i + 1] + pieces[i].triangles;
    }
    const std::size_t max = std::min(kMaxSurroundings, pieces.size());
    for (std::size_t count = 1; count < max && triangles[count] >= kFewest; ++count) {
        Subject found;
        bool all = true;
        for (const Piece& piece : pieces.first(count)) {
            const bool below = isGroundOf(piece, rest[count], axes);
            found.ground = found.ground || below;
            if (below) continue;
            all = all && isDomeOf(piece, rest[count], axes);
            found.domes.push_back(piece.number);
        }
        if (!all) continue;
        subject = found;
        return count;
    }
    return 0;
}

/// Whether a piece beside the bulk is lost: far away, or a crumb that lies well apart.
bool isLost(const Box3& piece, const Box3& bulk) {
    constexpr float kFar = 3, kApart = 0.5F, kCrumb = 0.03F; // of the bulk
    const float size = bulk.diagonal();
    const float reach = (piece.diagonal() < kCrumb * size ? kApart : kFar) * size;
    const Vec3 above = piece.lo - bulk.hi, below = bulk.lo - piece.hi;
    return std::max({above.x, above.y, above.z, below.x, below.y, below.z}) > reach;
}

/// Without pieces that are few and lost outside of where most are.
Box3 bulkOf(std::span<const Piece> pieces) {
    std::size_t all = 0;
    for (const Piece& piece : pieces) all += piece.triangles;
    Box3 bulk;
    std::vector<std::pair<float, std::size_t>> middles;
    for (int axis = 0; axis < 3; ++axis) {
        middles.clear();
        for (const Piece& piece : pieces) middles.emplace_back(piece.bounds.centre()[axis], piece.triangles);
        std::sort(middles.begin(), middles.end());
        constexpr double kOutside = 0.01;
        const auto min = static_cast<std::size_t>(kOutside * static_cast<double>(all));
        std::size_t before = 0;
        bool begun = false;
        for (const auto& [middle, count] : middles) {
            before += count;
            if (!begun && before > min) {
                bulk.lo[axis] = middle;
                begun = true;
            }
            if (before + min >= all) {
                bulk.hi[axis] = middle;
                break;
            }
        }
    }
    Box3 near;
    for (const Piece& piece : pieces) {
        const Vec3 middle = piece.bounds.centre();
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis)
            inside = inside && middle[axis] >= bulk.lo[axis] && middle[axis] <= bulk.hi[axis];
        if (inside) near.extend(piece.bounds);
    }
    if (near.empty()) return near;
    Box3 result = near;
    for (const Piece& piece : pieces)
        if (!isLost(piece.bounds, near)) result.extend(piece.bounds);
    return result;
}

} // namespace

Subject subjectOf(const Mesh& mesh, const Axes& axes) {
    Subject subject;
    if (mesh.triangles.size() > kMaxTriangles) {
        subject.bounds = subject.standing = mesh.bounds();
        return subject;
    }
    std::vector<std::uint32_t> pieceOf;
    const std::vector<Piece> pieces = piecesOf(mesh, axes, pieceOf);
    const std::size_t around = surroundingsOf(pieces, axes, subject);
    const std::vector<std::uint32_t> skies = std::exchange(subject.domes, {});
    for (std::uint32_t t = 0; !skies.empty() && t < pieceOf.size(); ++t)
        if (std::ranges::find(skies, pieceOf[t]) != skies.end()) subject.domes.push_back(t);
    const std::span<const Piece> things = std::span(pieces).subspan(around);
    subject.bounds = bulkOf(things);
    subject.standing = standingOn(things, subject.bounds, axes);
    return subject;
}

} // namespace rtcore

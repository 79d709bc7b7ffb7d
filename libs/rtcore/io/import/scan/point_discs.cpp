#include "rtcore/io/import/scan/point_discs.h"

#include "rtcore/io/import/mesh/equal_positions.h"
#include "rtcore/io/import/scan/point_tree.h"
#include "rtcore/math/box.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/large_vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace rtcore {

namespace {

constexpr std::uint64_t kBytesPerPoint = 330;

template <typename T>
void keep(std::vector<T>& list, const std::vector<char>& kept) {
    if (list.empty()) return;
    std::size_t to = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (kept[i] != 0) list[to++] = list[i];
    list.resize(to);
}

LostPoints dropUseless(ScanMesh& points) {
    LostPoints lost;
    for (Vec3& p : points.positions) p = withoutTraces(p);
    std::vector<char> kept(points.positions.size(), 1);
    {
        const std::vector<std::uint32_t> first = firstOfEqualPositions(points.positions);
        for (std::size_t i = 0; i < kept.size(); ++i) {
            const bool usable = isUsablePosition(points.positions[i]);
            const bool isFirst = first.empty() || first[i] == i;
            kept[i] = usable && isFirst ? 1 : 0;
            lost.nonFinite += usable ? 0 : 1;
            lost.equal += usable && !isFirst ? 1 : 0;
        }
    }
    if (lost.nonFinite + lost.equal == 0) return lost;
    keep(points.positions, kept);
    keep(points.normals, kept);
    keep(points.colours, kept);
    return lost;
}

/// Of a symmetric matrix, by Jacobi's rotations: the eigenvector of the smallest eigenvalue.
Vec3 minEigenvector(std::array<std::array<double, 3>, 3> a) {
    std::array<std::array<double, 3>, 3> vectors{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    constexpr int kSweeps = 6;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
            if (a[p][q] == 0) continue;
            const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
            const double t = std::copysign(1 / (std::fabs(theta) + std::sqrt(theta * theta + 1)), theta);
            const double c = 1 / std::sqrt(t * t + 1), s = t * c;
            for (std::size_t k = 0; k < 3; ++k) {
                const double kp = a[k][p], kq = a[k][q];
                a[k][p] = c * kp - s * kq;
                a[k][q] = s * kp + c * kq;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const double pk = a[p][k], qk = a[q][k];
                a[p][k] = c * pk - s * qk;
                a[q][k] = s * pk + c * qk;
                const double vp = vectors[k][p], vq = vectors[k][q];
                vectors[k][p] = c * vp - s * vq;
                vectors[k][q] = s * vp + c * vq;
            }
        }
    }
    std::size_t min = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (a[k][k] < a[min][min]) min = k;
    return {static_cast<float>(vectors[0][min]), static_cast<float>(vectors[1][min]),
            static_cast<float>(vectors[2][min])};
}

/// Across the plane that lies nearest to a point and its neighbours, on the side away from `middle`.
Vec3 normalOfPlane(std::span<const Vec3> positions, std::uint32_t point, const Neighbours& nearest,
                   Vec3 middle) {
    const Vec3 at = positions[point];
    if (nearest.count < 2 || !(nearest.squares[nearest.count - 1] > 0)) return {0, 0, 1};
    // In units of the farthest neighbour, as seen from the point: large coordinates lose nothing.
    const float scale = 1 / std::sqrt(nearest.squares[nearest.count - 1]);
    std::array<double, 3> mean{};
    std::array<std::array<double, 3>, 3> products{};
    for (std::size_t n = 0; n < nearest.count; ++n) {
        const Vec3 d = (positions[nearest.points[n]] - at) * scale;
        for (int i = 0; i < 3; ++i) {
            mean[static_cast<std::size_t>(i)] += double{d[i]};
            for (int j = 0; j < 3; ++j)
                products[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] +=
                    double{d[i]} * double{d[j]};
        }
    }
    const auto count = static_cast<double>(nearest.count + 1);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) products[i][j] -= mean[i] * mean[j] / count;
    const Vec3 normal = minEigenvector(products);
    return dot(normal, at - middle) < 0 ? normal * -1.0F : normal;
}

bool isDirection(Vec3 v) {
    const float square = dot(v, v);
    return square > 1e-20F && square < 1e20F;
}

/// What the neighbours tell of every point.
struct Shapes {
    std::vector<float> reaches; ///< distances
    std::vector<Vec3> normals;  ///< of unit length
};

/// How far a disc may reach: to the sixth neighbour, but at most twice as far as those reach themselves.
std::vector<float> boundedReaches(const std::vector<float>& reaches,
                                  const std::vector<std::uint32_t>& sixths) {
    std::vector<float> sorted = reaches;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    constexpr float kOfNeighbours = 2, kOfAll = 8;
    const float max = kOfAll * *middle;
    for (std::size_t i = 0; i < reaches.size(); ++i)
        sorted[i] = std::min({reaches[i], kOfNeighbours * reaches[sixths[i]], max});
    return sorted;
}

Shapes shapesOf(ScanMesh& points, const std::function<void()>& alive) {
    const std::vector<Vec3>& positions = points.positions;
    Box3 bounds;
    for (const Vec3 p : positions) bounds.extend(p);
    const Vec3 middle = bounds.lo + bounds.size() * 0.5F;
    Shapes shapes{std::vector<float>(positions.size(), 1), std::move(points.normals)};
    shapes.normals.resize(positions.size());
    std::vector<std::uint32_t> sixths(positions.size(), 0);
    const PointTree tree(positions);
    alive();
    const auto use = [&](std::uint32_t point, const Neighbours& nearest) {
        Vec3& normal = shapes.normals[point];
        if (!isDirection(normal)) normal = normalOfPlane(positions, point, nearest, middle);
        normal = normalize(normal);
        if (nearest.count == 0) return;
        const std::size_t sixth = std::min<std::size_t>(nearest.count, 6) - 1;
        shapes.reaches[point] = std::sqrt(nearest.squares[sixth]);
        sixths[point] = nearest.points[sixth];
    };
    tree.forEach(use, alive);
    shapes.reaches = boundedReaches(shapes.reaches, sixths);
    return shapes;
}

/// A regular polygon around the origin, in coordinates of its plane, that holds the circle of radius 1.
struct Outline {
    explicit Outline(std::size_t corners) : count(corners) {
        const double step = 2 * std::numbers::pi / static_cast<double>(corners), out = 1 / std::cos(step / 2);
        for (std::size_t i = 0; i < corners; ++i) {
            const double angle = step * (static_cast<double>(i) + 0.5);
            at[i] = {static_cast<float>(out * std::cos(angle)), static_cast<float>(out * std::sin(angle))};
        }
    }
    std::size_t count;
    std::array<Vec2, 6> at{};
};

/// Two directions that span the plane across `n`, of unit length.
std::pair<Vec3, Vec3> planeAcross(Vec3 n) {
    const Vec3 aside = std::fabs(n.x) < std::fabs(n.z) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 u = normalize(cross(aside, n));
    return {u, cross(n, u)};
}

void addDisc(const Outline& outline, Vec3 centre, Vec3 normal, float radius, std::uint32_t number,
             ModelBuffers& model) {
    const auto [u, v] = planeAcross(normal);
    const auto first = static_cast<std::uint32_t>(number * outline.count);
    for (std::size_t i = 0; i < outline.count; ++i) {
        const Vec3 p = centre + (u * outline.at[i].x + v * outline.at[i].y) * radius;
        const Vec3 q = withoutTraces(p);
        model.vertices[first + i] = Vertex{q.x, q.y, q.z};
    }
    const std::size_t triangles = outline.count - 2;
    for (std::size_t t = 0; t < triangles; ++t) {
        const auto corner = static_cast<std::uint32_t>(first + t);
        model.triangles[number * triangles + t] = {{first, corner + 1, corner + 2}};
        model.shading[number * triangles + t] = {{number, number, number}, 0};
    }
}

} // namespace

void refuseManyPoints(std::uint64_t count, std::uint64_t memoryLimit) {
    if (count > kMaxPoints) {
        throw FileError(
            FailureKind::BadData, "",
            say("it is a cloud of {0} points, more than the {1} that are shown; thin it out or make a "
                "mesh of it (CloudCompare, MeshLab) and save that as PLY",
                count, kMaxPoints));
    }
    if (memoryLimit > 0 && count > memoryLimit / kBytesPerPoint) {
        throw FileError(
            FailureKind::BadData, "",
            say("it is a cloud of {0} points, more than fit into the memory that it may use; raise the "
                "limit or thin it out (CloudCompare, MeshLab)",
                count));
    }
}

LostPoints addDiscs(ScanMesh points, ModelBuffers& model, const std::function<void()>& alive) {
    const LostPoints lost = dropUseless(points);
    if (points.positions.empty()) return lost;
    Shapes shapes = shapesOf(points, alive);
    const std::size_t count = points.positions.size();
    const Outline outline(count <= kMaxHexagons ? 6 : 4);
    resizeLarge(model.vertices, count * outline.count);
    resizeLarge(model.triangles, count * (outline.count - 2));
    resizeLarge(model.shading, count * (outline.count - 2));
    // Of a surface with points at random 4 of 100 parts stay open; the third neighbour would leave a fifth.
    constexpr float kRadius = 0.72F;
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < count; ++i) {
        // What rounds to nothing at its coordinates would be no triangle.
        const Vec3 p = points.positions[i];
        const float coarse = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) * 1e-6F;
        const float radius = std::max({kRadius * shapes.reaches[i], coarse, 1e-12F});
        addDisc(outline, p, shapes.normals[i], radius, static_cast<std::uint32_t>(i), model);
    }
    model.normals = std::move(shapes.normals);
    model.colours = std::move(points.colours);
    return lost;
}

} // namespace rtcore

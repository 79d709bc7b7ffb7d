#include "rtcore/scene/sky_ground.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

constexpr float kReach = 8;          ///< from its middle to its sides, in diagonals of the model
constexpr float kFadingReach = 2.5F; ///< the same, of one that fades
constexpr std::uint32_t kFadingCells = 32;
constexpr float kBelow = 0.0001F; ///< the same: so that flat undersides do not lie in it

struct GroundedMesh {
    std::shared_ptr<const void> model; ///< owns what is not copied
    std::vector<Vertex> vertices;
    std::vector<Triangle> triangles;
    std::vector<ShadingTriangle> shading;
    std::vector<Vec3> normals;
    std::vector<Vec2> texcoords;
    std::vector<Colour> colours;
    std::vector<float> alphas;
    std::vector<Vec2> furtherTexcoords;
};

/// With room for so many more.
template <typename T>
std::vector<T> copyOf(std::span<const T> all, std::size_t more) {
    std::vector<T> copy;
    copy.reserve(all.size() + more);
    copy.assign(all.begin(), all.end());
    return copy;
}

std::uint32_t sizeOf(const auto& all) { return static_cast<std::uint32_t>(all.size()); }

/// The opacity of a ground that fades; `x` and `y` go from -1 to 1 between its sides, 0 in the middle.
float opacityAt(float x, float y) {
    constexpr float kOpaque = 0.25F, kEnd = 0.95F; // parts of the way to a side
    const float t = std::clamp((std::sqrt(x * x + y * y) - kOpaque) / (kEnd - kOpaque), 0.0F, 1.0F);
    return 1 - t * t * (3 - 2 * t);
}

/// Behind what the mesh has: the corners of the square's cells, row by row, and two triangles for each cell.
void addSquare(GroundedMesh& to, const SkyGround& ground, std::uint32_t material) {
    const std::uint32_t first = sizeOf(to.vertices), attribute = sizeOf(to.normals);
    const std::uint32_t corners = ground.cells + 1;
    const bool fades = ground.edge == GroundEdge::Fades;
    if (fades) to.alphas.resize(to.normals.size(), 1);
    for (std::uint32_t i = 0; i < corners * corners; ++i) {
        const auto cells = static_cast<float>(ground.cells);
        const float across = static_cast<float>(i % corners) / cells,
                    along = static_cast<float>(i / corners) / cells;
        const Vec3 p = ground.corner + ground.right * across + ground.front * along;
        to.vertices.push_back({p.x, p.y, p.z});
        to.normals.push_back(ground.up);
        if (!to.texcoords.empty()) to.texcoords.push_back({});
        if (!to.colours.empty()) to.colours.push_back(kWhite);
        if (!to.alphas.empty()) to.alphas.push_back(fades ? opacityAt(2 * across - 1, 2 * along - 1) : 1);
    }
    for (std::uint32_t i = 0; i < ground.cells * ground.cells; ++i) {
        const std::uint32_t corner = i / ground.cells * corners + i % ground.cells;
        const std::uint32_t around[] = {corner, corner + 1, corner + corners + 1, corner + corners};
        for (const std::uint32_t third : {2U, 3U}) {
            const std::uint32_t of[] = {around[0], around[third - 1], around[third]};
            to.triangles.push_back({{first + of[0], first + of[1], first + of[2]}});
            to.shading.push_back({{attribute + of[0], attribute + of[1], attribute + of[2]}, material});
        }
    }
}

} // namespace

std::shared_ptr<const SkyGround> makeGround(const Model& model, Vec3 up, Colour albedo, GroundEdge edge) {
    const Box3 bounds = model.mesh.bounds();
    const bool fades = edge == GroundEdge::Fades;
    const float reach = (fades ? kFadingReach : kReach) * bounds.diagonal();
    const float height = std::fabs(dot(bounds.size(), up)) * 0.5F + kBelow * bounds.diagonal();
    const Vec3 right = up.x == 0 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};

    auto ground = std::make_shared<SkyGround>();
    ground->edge = edge;
    ground->cells = fades ? kFadingCells : 1;
    ground->up = up;
    ground->right = right * (2 * reach);
    ground->front = cross(up, right) * (2 * reach);
    ground->corner = bounds.centre() - up * height - (ground->right + ground->front) * 0.5F;
    ground->material.diffuse = albedo;
    ground->material.vertexAlpha = fades ? 1 : 0;

    const Mesh& mesh = model.mesh;
    auto grounded = std::make_shared<GroundedMesh>();
    grounded->model = model.storage;
    const std::size_t corners = std::size_t{ground->cells + 1} * (ground->cells + 1),
                      triangles = std::size_t{2} * ground->cells * ground->cells;
    grounded->vertices = copyOf(mesh.vertices, corners);
    grounded->triangles = copyOf(mesh.triangles, triangles);
    grounded->shading = copyOf(mesh.shading, triangles);
    grounded->normals = copyOf(mesh.normals, corners);
    grounded->texcoords = copyOf(mesh.texcoords, corners);
    grounded->colours = copyOf(mesh.colours, corners);
    grounded->alphas = copyOf(mesh.alphas, corners);
    grounded->furtherTexcoords = copyOf(mesh.furtherTexcoords, corners * mesh.furtherSets());
    addSquare(*grounded, *ground, sizeOf(model.materials));
    grounded->furtherTexcoords.resize(grounded->normals.size() * mesh.furtherSets());
    ground->mesh = {grounded->vertices,  grounded->triangles, grounded->shading, grounded->normals,
                    grounded->texcoords, grounded->colours,   grounded->alphas,  grounded->furtherTexcoords};
    ground->storage = std::move(grounded);
    return ground;
}

std::optional<float> distanceToGround(const SkyGround& ground, Vec3 origin, Vec3 direction) {
    const float down = -dot(direction, ground.up);
    const float height = dot(origin - ground.corner, ground.up);
    if (!(down > 0) || height < 0) return std::nullopt;
    return height / down;
}

std::optional<GroundPoint> pointOnGround(const SkyGround& ground, Vec3 position) {
    const Vec3 from = position - ground.corner;
    const float across = dot(from, ground.right) / dot(ground.right, ground.right);
    const float along = dot(from, ground.front) / dot(ground.front, ground.front);
    if (!(across >= 0 && across <= 1 && along >= 0 && along <= 1)) return std::nullopt;
    const auto cells = static_cast<float>(ground.cells);
    const auto cellAt = [&](float part) {
        return std::min(static_cast<std::uint32_t>(part * cells), ground.cells - 1);
    };
    const std::uint32_t column = cellAt(across), row = cellAt(along);
    const float x = std::clamp(across * cells - static_cast<float>(column), 0.0F, 1.0F),
                y = std::clamp(along * cells - static_cast<float>(row), 0.0F, 1.0F);
    const std::uint32_t triangle = 2 * (row * ground.cells + column);
    if (x >= y) return GroundPoint{triangle, x - y, y};
    return GroundPoint{triangle + 1, x, y - x};
}

} // namespace rtcore

#include "rtcore/scene/sky_ground.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

constexpr float kReach = 8;       ///< from its middle to its sides, in diagonals of the model
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

/// Behind what the mesh has: the square's corners as they stand around it, and its two triangles.
void addSquare(GroundedMesh& to, const SkyGround& ground, std::uint32_t material) {
    const std::uint32_t first = sizeOf(to.vertices), attribute = sizeOf(to.normals);
    for (const Vec3 p : {ground.corner, ground.corner + ground.right,
                         ground.corner + ground.right + ground.front, ground.corner + ground.front})
        to.vertices.push_back({p.x, p.y, p.z});
    to.normals.push_back(ground.up);
    if (!to.texcoords.empty()) to.texcoords.push_back({});
    if (!to.colours.empty()) to.colours.push_back(kWhite);
    if (!to.alphas.empty()) to.alphas.push_back(1);
    for (const std::uint32_t third : {2U, 3U}) {
        to.triangles.push_back({{first, first + third - 1, first + third}});
        to.shading.push_back({{attribute, attribute, attribute}, material});
    }
}

} // namespace

std::shared_ptr<const SkyGround> makeGround(const Model& model, Vec3 up, Colour albedo) {
    const Box3 bounds = model.mesh.bounds();
    const float reach = kReach * bounds.diagonal();
    const float height = std::fabs(dot(bounds.size(), up)) * 0.5F + kBelow * bounds.diagonal();
    const Vec3 right = up.x == 0 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};

    auto ground = std::make_shared<SkyGround>();
    ground->up = up;
    ground->right = right * (2 * reach);
    ground->front = cross(up, right) * (2 * reach);
    ground->corner = bounds.centre() - up * height - (ground->right + ground->front) * 0.5F;
    ground->material.diffuse = albedo;

    const Mesh& mesh = model.mesh;
    auto grounded = std::make_shared<GroundedMesh>();
    grounded->model = model.storage;
    grounded->vertices = copyOf(mesh.vertices, 4);
    grounded->triangles = copyOf(mesh.triangles, 2);
    grounded->shading = copyOf(mesh.shading, 2);
    grounded->normals = copyOf(mesh.normals, 1);
    grounded->texcoords = copyOf(mesh.texcoords, 1);
    grounded->colours = copyOf(mesh.colours, 1);
    grounded->alphas = copyOf(mesh.alphas, 1);
    addSquare(*grounded, *ground, sizeOf(model.materials));
    ground->mesh = {grounded->vertices,  grounded->triangles, grounded->shading, grounded->normals,
                    grounded->texcoords, grounded->colours,   grounded->alphas};
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
    if (across >= along) return GroundPoint{0, across - along, along};
    return GroundPoint{1, across, along - across};
}

} // namespace rtcore

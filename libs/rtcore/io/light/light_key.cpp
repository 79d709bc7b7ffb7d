#include "rtcore/io/light/light_key.h"

#include "rtcore/io/light/content_hash.h"
#include "rtcore/scene/photometry.h"
#include "rtcore/settings/settings_table.h"

#include <algorithm>
#include <array>
#include <span>

namespace rtcore {

namespace {

void addVec(Vec3 v, ContentHash& to) { to.add(std::span<const float>(std::array{v.x, v.y, v.z})); }
void addColour(Colour c, ContentHash& to) { to.add(std::span<const float>(std::array{c.r, c.g, c.b})); }

/// A record of words whose name does not count.
template <typename Record>
void addNameless(Record record, ContentHash& to) {
    static_assert(sizeof(Record) % sizeof(std::uint32_t) == 0 && alignof(Record) == alignof(std::uint32_t));
    record.nameOffset = 0;
    to.add(std::span<const Record>(&record, 1));
}

void addLight(Light light, ContentHash& to) {
    const Photometry& measured = photometryOf(light);
    to.add(std::span(measured.gammas, measured.gammaCount));
    to.add(std::span(measured.planes, measured.planeCount));
    to.add(std::span(measured.relative, std::size_t{measured.gammaCount} * measured.planeCount));
    light.photometry = light.photometry != 0 ? 1 : 0; // numbers go by the order in which files were read
    addNameless(light, to);
}

void addShading(const Mesh& mesh, ContentHash& to) {
    to.add(mesh.shading);
    to.add(mesh.normals);
    to.add(mesh.texcoords);
    to.add(mesh.colours);
    to.add(mesh.alphas);
    if (!mesh.furtherTexcoords.empty()) to.add(mesh.furtherTexcoords);
}

void addMaterials(const Scene& scene, ContentHash& to) {
    for (const Material& material : scene.materials) addNameless(material, to);
    to.add(scene.model.textures);
    to.add(scene.model.texels);
    if (!scene.model.blocks.empty()) to.add(scene.model.blocks);
}

void addGround(const Scene& scene, ContentHash& to) {
    to.add(scene.showsGround());
    if (!scene.showsGround()) return;
    const SkyGround& ground = *scene.ground;
    for (const Vec3 v : {ground.up, ground.corner, ground.right, ground.front}) addVec(v, to);
    to.add(ground.cells);
    to.add(static_cast<std::uint32_t>(ground.edge));
    addNameless(ground.material, to);
}

void addSurroundings(const Scene& scene, ContentHash& to) {
    addColour(scene.background, to);
    addColour(scene.ambient, to);
    const Environment* const environment = scene.environment();
    to.add(environment != nullptr);
    if (environment == nullptr) return;
    to.add(environment->intensity);
    to.add(environment->isCube());
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        addVec(environment->turned(axis), to);
    for (const HdrImage& image : environment->images()) {
        to.add(image.width);
        to.add(std::span<const Colour>(image.pixels));
    }
}

void addFog(const Scene& scene, ContentHash& to) {
    const Fog& fog = scene.fog;
    to.add(static_cast<std::uint32_t>(fog.kind));
    for (const float x : {fog.density, fog.scaleHeight, fog.groundHeight, fog.surroundings}) to.add(x);
    for (const Colour c : {fog.colour, fog.albedo, fog.emission}) addColour(c, to);
    addVec(scene.up, to);
}

/// Of those that change light; how many rays of a kind an image takes is no matter of what is learned.
constexpr const char* kLearnedWith[] = {
    "shadows",           "reflections",  "refractions",   "textures",           "maxDepth",
    "environmentFilter", "path.bounces", "path.caustics", "path.clampIndirect", "path.rouletteFrom",
    "path.emitters",     "fog.on",
};

void addSettings(const RenderSettings& settings, ContentHash& to) {
    for (const char* const name : kLearnedWith)
        to.add(std::string_view(settingText(requireSetting(name).get(settings))));
}

void addParts(const Model& model, const PartSet& set, ContentHash& to) {
    const std::vector<std::uint8_t> triangles = partTriangles(model, set);
    if (std::ranges::any_of(triangles, [](std::uint8_t each) { return each != 0; }))
        to.add(std::span<const std::uint8_t>(triangles));
}

void addSections(const Scene& scene, ContentHash& to) {
    for (const SectionPlane& plane : scene.sections.planes) {
        addVec(plane.point, to);
        addVec(plane.normal, to);
    }
    addParts(scene.model, scene.uncutParts, to);
}

std::uint64_t surfacesOf(const Scene& scene, const Box3& bounds) {
    ContentHash hash;
    hash.add(scene.model.mesh.vertices);
    hash.add(scene.model.mesh.triangles);
    addParts(scene.model, scene.hiddenParts, hash);
    addVec(bounds.lo, hash);
    addVec(bounds.hi, hash);
    if (scene.sections.letLightIn()) addSections(scene, hash);
    return hash.value();
}

std::uint64_t lightOf(const Scene& scene, const RenderSettings& settings) {
    ContentHash hash;
    for (const SceneLight& each : scene.lights) addLight(each.light, hash);
    addShading(scene.model.mesh, hash);
    addMaterials(scene, hash);
    addGround(scene, hash);
    addSurroundings(scene, hash);
    addFog(scene, hash);
    addSettings(settings, hash);
    return hash.value();
}

} // namespace

LightKey lightKeyOf(const Scene& scene, const Box3& bounds, const RenderSettings& settings) {
    return {surfacesOf(scene, bounds), lightOf(scene, settings), bounds};
}

} // namespace rtcore

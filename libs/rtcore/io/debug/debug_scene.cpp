#include "rtcore/io/debug/debug_scene.h"

#include "rtcore/io/debug/obj_sketch.h"
#include "rtcore/platform/files.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/shading/surface/surface.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace rtcore {

namespace {

constexpr std::size_t kCells = 1000;     ///< of all depths together, but for the last
constexpr std::size_t kHeaviest = 100;   ///< leaves
constexpr int kColumns = 48, kRows = 36; ///< of rays for normals
constexpr float kThin = 0.0007F;         ///< bars, in diagonals of the scene

struct Cell {
    std::uint32_t node = 0;
    Box3 box;
};

/// From blue at the root by green to red.
Colour depthColour(int depth) {
    constexpr std::array<Colour, 6> kRamp{{{0.1F, 0.2F, 0.9F},
                                           {0, 0.6F, 0.9F},
                                           {0, 0.7F, 0.4F},
                                           {0.5F, 0.8F, 0},
                                           {0.9F, 0.7F, 0},
                                           {0.9F, 0.2F, 0}}};
    return kRamp[std::min(static_cast<std::size_t>(depth) / 2, kRamp.size() - 1)];
}

void addChildren(const KdTree& tree, const Cell& cell, std::vector<Cell>& children) {
    const KdNode& node = tree.nodes[cell.node];
    if (node.isLeaf()) return;
    Box3 lower = cell.box, upper = cell.box;
    lower.hi[node.axis()] = node.split;
    upper.lo[node.axis()] = node.split;
    children.push_back({node.lowerChild(), lower});
    children.push_back({node.lowerChild() + 1, upper});
}

void sketchCells(const KdTree& tree, float thickness, ObjSketch& sketch) {
    std::vector<Cell> level{{0, tree.bounds}};
    std::size_t drawn = 0;
    for (int depth = 0; !level.empty() && drawn + level.size() <= kCells; ++depth) {
        sketch.object(fmt::format("tree_depth_{:02}", depth), depthColour(depth));
        std::vector<Cell> next;
        for (const Cell& cell : level) {
            sketch.edges(cell.box, thickness);
            addChildren(tree, cell, next);
        }
        drawn += level.size();
        level = std::move(next);
    }
}

std::vector<Cell> heaviestLeaves(const KdTree& tree) {
    std::vector<Cell> open{{0, tree.bounds}}, leaves;
    const auto heavier = [&](const Cell& a, const Cell& b) {
        const std::uint32_t ofA = tree.nodes[a.node].count(), ofB = tree.nodes[b.node].count();
        return ofA != ofB ? ofA > ofB : a.node < b.node;
    };
    while (!open.empty()) {
        const Cell cell = open.back();
        open.pop_back();
        addChildren(tree, cell, open);
        const KdNode& node = tree.nodes[cell.node];
        if (!node.isLeaf() || node.count() == 0) continue;
        leaves.push_back(cell);
        std::push_heap(leaves.begin(), leaves.end(), heavier); // its top is the lightest
        if (leaves.size() <= kHeaviest) continue;
        std::pop_heap(leaves.begin(), leaves.end(), heavier);
        leaves.pop_back();
    }
    return leaves;
}

/// Lights without a position are drawn above the middle of the scene.
Vec3 positionOf(const Light& light, const Box3& bounds) {
    if (traitsOf(light).position) return light.position;
    return bounds.centre() - light.direction * (0.6F * bounds.diagonal());
}

void sketchLight(const Light& light, const Box3& bounds, ObjSketch& sketch) {
    const float unit = bounds.diagonal();
    const Vec3 middle = positionOf(light, bounds);
    const LightTraits& traits = traitsOf(light);
    sketch.octahedron(middle, traits.radius ? std::max(light.radius, 0.002F * unit) : 0.008F * unit);
    if (!traits.direction) return;
    sketch.bar(middle, middle + light.direction * (0.1F * unit), 3 * kThin * unit);
    if (!traits.sides) return;
    const Vec3 right = light.right * (light.width / 2);
    const Vec3 down = cross(light.direction, light.right) * (light.height / 2);
    sketch.triangle(middle - right - down, middle + right - down, middle + right + down);
    sketch.triangle(middle - right - down, middle + right + down, middle - right + down);
}

void sketchLights(const Scene& scene, const Box3& bounds, ObjSketch& sketch) {
    for (const bool on : {true, false}) {
        sketch.object(on ? "lights_on" : "lights_off",
                      on ? Colour{1, 0.85F, 0.2F} : Colour{0.3F, 0.3F, 0.3F});
        for (const SceneLight& each : scene.lights) {
            if ((each.light.on != 0) == on) sketchLight(each.light, bounds, sketch);
        }
    }
}

/// As far as the middle of the image sees, or a third of the scene.
float viewDistance(const RayTracer& tracer, const CameraRays& rays, float unit, int width, int height) {
    RayWave wave;
    wave.push(rays.at(static_cast<float>(width) / 2, static_cast<float>(height) / 2));
    HitWave hits;
    tracer.intersect(RayKind::Primary, wave, hits);
    return hits.isHit(0) ? hits.t[0] : unit / 3;
}

void sketchCamera(const CameraRays& rays, float distance, int width, int height, float thickness,
                  ObjSketch& sketch) {
    sketch.object("camera", {0.9F, 0.1F, 0.6F});
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    const Vec3 ahead = rays.at(w / 2, h / 2).direction;
    const std::array<Ray, 4> edges{rays.at(0, 0), rays.at(w, 0), rays.at(w, h), rays.at(0, h)};
    std::array<Vec3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 direction = edges[i].direction;
        corners[i] = edges[i].origin + direction * (distance / dot(direction, ahead));
    }
    for (std::size_t i = 0; i < 4; ++i) {
        sketch.bar(edges[i].origin, corners[i], thickness);
        sketch.bar(corners[i], corners[(i + 1) % 4], thickness);
    }
    const Vec3 top = (corners[0] + corners[1]) * 0.5F;
    sketch.bar(top, top + (corners[0] - corners[3]) * 0.1F, 3 * thickness);
}

void sketchNormals(const Scene& scene, const RayTracer& tracer, const CameraRays& rays, int width, int height,
                   float unit, ObjSketch& sketch) {
    RayWave wave;
    for (int j = 0; j < kRows; ++j) {
        for (int i = 0; i < kColumns; ++i) {
            wave.push(rays.at((static_cast<float>(i) + 0.5F) * static_cast<float>(width) / kColumns,
                              (static_cast<float>(j) + 0.5F) * static_cast<float>(height) / kRows));
        }
    }
    HitWave hits;
    tracer.intersect(RayKind::Primary, wave, hits);
    for (const bool shading : {true, false}) {
        sketch.object(shading ? "normals_shading" : "normals_geometric",
                      shading ? Colour{0.1F, 0.8F, 0.9F} : Colour{0.9F, 0.4F, 0.1F});
        for (std::size_t i = 0; i < wave.size(); ++i) {
            if (!hits.isHit(i)) continue;
            const Surface surface = surfaceAt(scene, true, wave.ray(i).direction, hits.hit(i));
            const Vec3 normal = shading ? surface.shadingNormal : surface.geometricNormal;
            sketch.bar(surface.position, surface.position + normal * (0.01F * unit), kThin * unit);
        }
    }
}

} // namespace

DebugScene sketchScene(const Scene& scene, const KdTree& tree, const RayTracer& tracer, const Camera& camera,
                       int width, int height, std::string_view materials) {
    ObjSketch sketch(materials);
    Box3 bounds = tree.bounds;
    if (bounds.empty()) bounds = {camera.eye - Vec3{1, 1, 1}, camera.eye + Vec3{1, 1, 1}};
    const float unit = std::max(bounds.diagonal(), 1e-6F);
    const CameraRays rays(camera, width, height);
    if (!tree.bounds.empty()) {
        sketchCells(tree, kThin * unit, sketch);
        sketch.object("tree_heaviest_leaves", {0.9F, 0, 0});
        for (const Cell& leaf : heaviestLeaves(tree)) sketch.edges(leaf.box, 2 * kThin * unit);
    }
    sketchLights(scene, bounds, sketch);
    sketchCamera(rays, viewDistance(tracer, rays, unit, width, height), width, height, kThin * unit, sketch);
    sketchNormals(scene, tracer, rays, width, height, unit, sketch);
    return {sketch.text(), sketch.materials()};
}

std::filesystem::path debugMaterials(std::filesystem::path path) { return path.replace_extension(".mtl"); }

void writeDebugScene(const std::filesystem::path& path, const Scene& scene, const KdTree& tree,
                     const RayTracer& tracer, const Camera& camera, int width, int height) {
    const std::filesystem::path materials = debugMaterials(path);
    const DebugScene drawn =
        sketchScene(scene, tree, tracer, camera, width, height, materials.filename().string());
    const auto write = [](const std::filesystem::path& file, const std::string& text) {
        const std::span<const std::byte> bytes = std::as_bytes(std::span(text));
        writeFileAtomically(file, std::span(&bytes, 1));
    };
    write(materials, drawn.mtl);
    write(path, drawn.obj);
}

} // namespace rtcore

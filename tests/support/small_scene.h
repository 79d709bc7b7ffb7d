/// Scenes of a few triangles, and rays through them. For tests of what light does.
#pragma once

#include "rtcore/accel/builder.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/closed_surfaces.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/shading/whitted.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace test {

inline constexpr double kPi = 3.14159265358979323846;

inline rtcore::Vec3 atAngle(double degrees) { ///< in the plane z = 0, from the y axis towards x
    const double a = degrees * kPi / 180;
    return {static_cast<float>(std::sin(a)), static_cast<float>(std::cos(a)), 0};
}

inline rtcore::Material matte(float albedo) {
    rtcore::Material m;
    m.diffuse = {albedo, albedo, albedo};
    return m;
}
inline rtcore::Material emitter(rtcore::Colour radiance) {
    rtcore::Material m = matte(0);
    m.emission = radiance;
    return m;
}
inline rtcore::Material mirror(float reflectance) {
    rtcore::Material m = matte(0);
    m.mirror = {reflectance, reflectance, reflectance};
    return m;
}
inline rtcore::Material glass(float indexOfRefraction = 1.5F) {
    rtcore::Material m = matte(0);
    m.opacity = 0;
    m.indexOfRefraction = indexOfRefraction;
    return m;
}
inline rtcore::Light pointLight(rtcore::Vec3 position, float intensity) {
    rtcore::Light light;
    light.position = position;
    light.intensity = {intensity, intensity, intensity};
    return light;
}

/// Adds shapes of one material each; faces with flat normals unless they say otherwise.
class SceneBuilder {
  public:
    using Vec3 = rtcore::Vec3;

    std::uint32_t material(const rtcore::Material& m) {
        buffers.materials.push_back(m);
        return static_cast<std::uint32_t>(buffers.materials.size() - 1);
    }

    /// Counter-clockwise seen from the front, texture coordinates (0,0) (1,0) (1,1) (0,1).
    void quad(Vec3 a, Vec3 b, Vec3 c, Vec3 d, std::uint32_t material) {
        const std::uint32_t v = addVertices({a, b, c, d});
        quadOf({v, v + 1, v + 2, v + 3}, material);
    }
    /// Square of half side `half`, seen from its `normal`.
    void square(Vec3 centre, Vec3 normal, float half, std::uint32_t material) {
        const auto [t, b] = rtcore::basisAround(normal);
        quad(centre - t * half - b * half, centre + t * half - b * half, centre + t * half + b * half,
             centre - t * half + b * half, material);
    }
    void triangle(Vec3 a, Vec3 b, Vec3 c, std::uint32_t material) {
        const std::uint32_t v = addVertices({a, b, c});
        triangleOf(v, v + 1, v + 2, material);
    }
    /// Closed: its faces share eight vertices. `faces` of them, in the order -x +x -y +y -z +z.
    void box(Vec3 lo, Vec3 hi, std::uint32_t material, int faces = 6) {
        std::vector<Vec3> corners;
        corners.reserve(8);
        for (int i = 0; i < 8; ++i) {
            corners.push_back(
                {(i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y, (i & 4) != 0 ? hi.z : lo.z});
        }
        const std::uint32_t v = addVertices(corners);
        constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
            {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
        for (std::size_t f = 0; f < static_cast<std::size_t>(faces); ++f) {
            const auto& q = kFaces[f];
            quadOf({v + q[0], v + q[1], v + q[2], v + q[3]}, material);
        }
    }
    /// Closed, with smooth normals; poles on the y axis. Returns its first vertex: the pole above, then
    /// rings.
    std::uint32_t sphere(Vec3 centre, float radius, std::uint32_t rings, std::uint32_t material) {
        const std::uint32_t slices = 2 * rings;
        std::vector<Vec3> points{{0, 1, 0}};
        for (std::uint32_t r = 1; r < rings; ++r) {
            // Portable, so that images of it have the same bits everywhere.
            const auto polar = static_cast<float>(kPi * r / rings);
            for (std::uint32_t s = 0; s < slices; ++s) {
                const auto azimuth = static_cast<float>(2 * kPi * s / slices);
                const float ring = rtcore::portableSin(polar);
                points.push_back({ring * rtcore::portableSin(azimuth), rtcore::portableCos(polar),
                                  ring * rtcore::portableCos(azimuth)});
            }
        }
        points.push_back({0, -1, 0});
        std::vector<Vec3> places;
        places.reserve(points.size());
        for (const Vec3 p : points) places.push_back(centre + p * radius);
        const std::uint32_t first = addVertices(places);
        const auto firstNormal = static_cast<std::uint32_t>(buffers.normals.size());
        buffers.normals.insert(buffers.normals.end(), points.begin(), points.end());
        buffers.texcoords.resize(buffers.normals.size());
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            buffers.triangles.push_back({{first + a, first + b, first + c}});
            buffers.shading.push_back({{firstNormal + a, firstNormal + b, firstNormal + c}, material});
        };
        const auto at = [&](std::uint32_t r, std::uint32_t s) { return 1 + (r - 1) * slices + s % slices; };
        const auto last = static_cast<std::uint32_t>(points.size() - 1);
        for (std::uint32_t s = 0; s < slices; ++s) {
            add(0, at(1, s), at(1, s + 1));
            for (std::uint32_t r = 1; r + 1 < rings; ++r) {
                add(at(r, s), at(r + 1, s), at(r + 1, s + 1));
                add(at(r, s), at(r + 1, s + 1), at(r, s + 1));
            }
            add(at(rings - 1, s), last, at(rings - 1, s + 1));
        }
        return first;
    }
    std::uint32_t texture(std::uint32_t width, std::uint32_t height,
                          const std::vector<rtcore::Rgba8>& texels) {
        buffers.textures.push_back({buffers.texels.size(), width, height});
        buffers.texels.insert(buffers.texels.end(), texels.begin(), texels.end());
        return static_cast<std::uint32_t>(buffers.textures.size() - 1);
    }

    /// Takes what was added.
    rtcore::Scene finish() {
        if (buffers.materials.empty()) material({});
        scene.materials = buffers.materials;
        scene.model = rtcore::makeModel(std::move(buffers));
        scene.closed = rtcore::findClosedSurfaces(scene.mesh(), scene.materials);
        scene.solids = rtcore::findGlassSolids(scene.mesh(), scene.materials, scene.closed);
        return std::move(scene);
    }

    rtcore::ModelBuffers buffers;
    rtcore::Scene scene; ///< lights, background and the like

  private:
    std::uint32_t addVertices(const std::vector<Vec3>& points) {
        const auto first = static_cast<std::uint32_t>(buffers.vertices.size());
        for (const Vec3 p : points) buffers.vertices.push_back({p.x, p.y, p.z, 0});
        return first;
    }
    void addCorner(rtcore::ShadingTriangle& shading, int corner, Vec3 normal, rtcore::Vec2 uv) {
        shading.v[corner] = static_cast<std::uint32_t>(buffers.normals.size());
        buffers.normals.push_back(normal);
        buffers.texcoords.push_back(uv);
    }
    void face(std::array<std::uint32_t, 3> v, std::array<rtcore::Vec2, 3> uv, std::uint32_t material) {
        const auto place = [&](std::size_t i) { return buffers.vertices[v[i]].position(); };
        const Vec3 normal = rtcore::normalize(rtcore::cross(place(1) - place(0), place(2) - place(0)));
        rtcore::ShadingTriangle shading;
        shading.material = material;
        for (int i = 0; i < 3; ++i) addCorner(shading, i, normal, uv[static_cast<std::size_t>(i)]);
        buffers.triangles.push_back({{v[0], v[1], v[2]}});
        buffers.shading.push_back(shading);
    }
    void triangleOf(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t material) {
        face({a, b, c}, {{{0, 0}, {1, 0}, {0, 1}}}, material);
    }
    void quadOf(std::array<std::uint32_t, 4> v, std::uint32_t material) {
        face({v[0], v[1], v[2]}, {{{0, 0}, {1, 0}, {1, 1}}}, material);
        face({v[0], v[2], v[3]}, {{{0, 0}, {1, 1}, {0, 1}}}, material);
    }
};

/// No ray is left out because it matters little.
inline rtcore::RenderSettings exactSettings(int maxDepth = 30) {
    rtcore::RenderSettings settings;
    settings.maxDepth = maxDepth;
    settings.minContribution = 0;
    return settings;
}

/// A scene with its kd-tree.
class TracedScene {
  public:
    explicit TracedScene(rtcore::Scene s, rtcore::BuildMethod method = rtcore::BuildMethod::Exact)
        : scene(std::move(s)), tree(rtcore::buildKdTree(scene.mesh(), options(method))),
          tracer(tree, scene.mesh()) {}
    TracedScene(const TracedScene&) = delete;
    TracedScene& operator=(const TracedScene&) = delete;

    struct Result {
        rtcore::Colour radiance;
        bool hit = false;
        rtcore::RayStatistics statistics;
    };
    Result trace(rtcore::Vec3 origin, rtcore::Vec3 direction,
                 const rtcore::RenderSettings& settings = exactSettings()) const {
        rtcore::RayWave wave;
        wave.push({origin, 0, rtcore::normalize(direction), std::numeric_limits<float>::max()});
        std::array<rtcore::Colour, 1> radiance;
        std::array<std::uint8_t, 1> hit{};
        rtcore::WhittedIntegrator integrator(scene, tracer, settings);
        integrator.trace(wave, radiance, hit);
        return {radiance[0], hit[0] != 0, integrator.statistics()};
    }
    /// The red radiance from `target` to `eye`.
    float see(rtcore::Vec3 eye, rtcore::Vec3 target,
              const rtcore::RenderSettings& settings = exactSettings()) const {
        return trace(eye, target - eye, settings).radiance.r;
    }

    rtcore::Scene scene;
    rtcore::KdTree tree;
    rtcore::KdRayTracer tracer;

  private:
    static rtcore::BuildOptions options(rtcore::BuildMethod method) {
        rtcore::BuildOptions o;
        o.method = method;
        return o;
    }
};

} // namespace test

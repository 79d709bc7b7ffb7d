#include "rtcore/look/shell_picture.h"

#include "rtcore/accel/visible_tree.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/render/visible_scene.h"
#include "rtcore/scene/sphere_texels.h"
#include "rtcore/shading/whitted.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

constexpr int kWidth = 1024, kHeight = kWidth / 2;

/// The scene's shell alone, which nothing else lights.
Scene shellAlone(const Scene& scene, std::span<const std::uint8_t> pieces) {
    Scene shell;
    shell.model = scene.model;
    shell.materials = scene.materials;
    auto others = std::make_shared<std::vector<std::uint8_t>>(pieces.begin(), pieces.end());
    for (std::uint8_t& piece : *others) piece = piece != 0 ? 0 : 1;
    shell.hiddenParts = std::move(others);
    return shell;
}

Vec3 middleOfTheRest(const Model& model, std::span<const std::uint8_t> pieces) {
    Box3 rest;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const ModelPart& part = model.parts[i];
        for (std::uint32_t t = 0; pieces[i] == 0 && t < part.triangleCount; ++t)
            for (int corner = 0; corner < 3; ++corner)
                rest.extend(model.mesh.position(part.firstTriangle + t, corner));
    }
    return rest.empty() ? model.mesh.bounds().centre() : rest.centre();
}

RayWave raysOfRow(const SphereTexels& texels, Vec3 origin, int y) {
    const SphereTexels::Row row = texels.row(y);
    RayWave rays;
    for (int x = 0; x < kWidth; ++x)
        rays.push({origin, 0, normalize(texels.direction(row, x)), std::numeric_limits<float>::max()});
    return rays;
}

struct Seen {
    HdrImage picture{kWidth, kHeight};
    std::vector<std::uint8_t> hit = std::vector<std::uint8_t>(std::size_t{kWidth} * kHeight);
};

Seen lookAround(const Scene& shell, const KdTree& tree, Vec3 origin) {
    const KdTree visible = visibleTree(tree, shell);
    const KdRayTracer tracer(visible, shell.model.mesh);
    const RenderSettings settings;
    const SphereTexels texels(kHeight);
    Seen seen;
#pragma omp parallel
    {
        WhittedIntegrator integrator(shell, tracer, settings);
#pragma omp for schedule(dynamic)
        for (int y = 0; y < kHeight; ++y) {
            const std::size_t first = static_cast<std::size_t>(y) * kWidth;
            integrator.trace(raysOfRow(texels, origin, y),
                             std::span(seen.picture.pixels).subspan(first, kWidth),
                             std::span(seen.hit).subspan(first, kWidth));
        }
    }
    return seen;
}

/// Brightness of the surfaces that were hit.
struct Brightness {
    Colour mean;
    float lowest = std::numeric_limits<float>::max(), highest = 0;
};
Brightness brightnessOf(const Seen& seen) {
    Brightness result;
    double sum[3] = {}, count = 0;
    for (std::size_t i = 0; i < seen.hit.size(); ++i) {
        if (seen.hit[i] == 0) continue;
        const Colour c = seen.picture.pixels[i];
        ++count;
        sum[0] += static_cast<double>(c.r);
        sum[1] += static_cast<double>(c.g);
        sum[2] += static_cast<double>(c.b);
        result.lowest = std::min(result.lowest, luminance(c));
        result.highest = std::max(result.highest, luminance(c));
    }
    if (count > 0)
        result.mean = {static_cast<float>(sum[0] / count), static_cast<float>(sum[1] / count),
                       static_cast<float>(sum[2] / count)};
    return result;
}

} // namespace

std::optional<Environment> pictureOfShell(const Scene& scene, const KdTree& tree,
                                          std::span<const std::uint8_t> pieces, std::string name) {
    constexpr float kEven = 1.1F; // the brightest is less than that many times the darkest
    if (std::ranges::count(pieces, 0) == std::ssize(pieces)) return std::nullopt;
    Seen seen = lookAround(shellAlone(scene, pieces), tree, middleOfTheRest(scene.model, pieces));
    const Brightness brightness = brightnessOf(seen);
    if (!(brightness.highest > 0) || !std::isfinite(brightness.highest) ||
        brightness.highest < kEven * brightness.lowest)
        return std::nullopt;
    for (std::size_t i = 0; i < seen.hit.size(); ++i)
        if (seen.hit[i] == 0) seen.picture.pixels[i] = brightness.mean;
    return Environment::fromEquirectangular(seen.picture, std::move(name));
}

} // namespace rtcore

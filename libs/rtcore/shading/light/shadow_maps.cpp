#include "rtcore/shading/light/shadow_maps.h"

#include "rtcore/shading/light/shadows.h"
#include "rtcore/shading/surface/material_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

constexpr std::size_t kTexels = 3 << 17;                 ///< of a light, at most: 256 x 256 for each side
constexpr std::size_t kAllTexels = std::size_t{1} << 22; ///< of all lights, 12 bytes each
constexpr std::size_t kMaxLights = 1000;
constexpr int kBlock = 8;            ///< rays of neighbours are traced together
constexpr float kOffSurface = 0.75F; ///< texels: the middle of one is no further away than 0.71
constexpr float kRounding = 1.0001F;
constexpr float kFitting = 1e-4F; ///< of the scene's diagonal

Vec3 anyAcross(Vec3 axis) {
    const Vec3 other = std::fabs(axis.x) < 0.5F ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    return normalize(cross(axis, other));
}

int texelAt(float coordinate, int side) {
    return static_cast<int>(
        std::clamp(coordinate * static_cast<float>(side), 0.0F, static_cast<float>(side - 1)));
}

} // namespace

ShadowMap::ShadowMap(const Light& light, const Box3& bounds, std::size_t texels) : light_(light) {
    const bool sun = !traitsOf(light).position;
    sides_ = sun ? 1 : 6;
    const double side = std::sqrt(static_cast<double>(texels) / sides_);
    side_ = std::max(kBlock, static_cast<int>(side) / kBlock * kBlock);
    texels_.resize(static_cast<std::size_t>(sides_ * side_) * static_cast<std::size_t>(side_));
    nearest_ = std::max(ballRadius(light), kFitting * bounds.diagonal());
    if (!sun) return;
    across_ = anyAcross(light.direction);
    along_ = cross(light.direction, across_);
    half_ = bounds.diagonal() * 0.5F;
    start_ = bounds.centre() - light.direction * half_;
    nearest_ = 0;
}

/// There.
float ShadowMap::texelWidth(Vec3 position) const {
    const float texel = 2 / static_cast<float>(side_);
    if (sides_ == 1) return half_ * texel;
    const Vec3 offset = position - light_.position;
    return std::max({std::fabs(offset.x), std::fabs(offset.y), std::fabs(offset.z)}) * texel;
}

ShadowMap::Lookup ShadowMap::lookUp(Vec3 position) const {
    if (sides_ == 1) {
        const Vec3 offset = position - start_;
        const float scale = 0.5F / half_;
        const int column = texelAt(dot(offset, across_) * scale + 0.5F, side_);
        const int row = texelAt(dot(offset, along_) * scale + 0.5F, side_);
        const float distance = std::max(dot(offset, light_.direction), 0.0F);
        return {static_cast<std::size_t>(row * side_ + column), distance * distance};
    }
    const Vec3 offset = position - light_.position;
    const Vec3 size{std::fabs(offset.x), std::fabs(offset.y), std::fabs(offset.z)};
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const float scale = size[axis] > 0 ? 0.5F / size[axis] : 0;
    const int column = texelAt(offset[(axis + 1) % 3] * scale + 0.5F, side_);
    const int row = texelAt(offset[(axis + 2) % 3] * scale + 0.5F, side_);
    const int face = axis * 2 + (offset[axis] < 0 ? 1 : 0);
    return {static_cast<std::size_t>((face * side_ + row) * side_ + column), dot(offset, offset)};
}

/// The way back.
Ray ShadowMap::rayThrough(int face, int column, int row) const {
    const auto coordinate = [this](int i) {
        return (static_cast<float>(i) + 0.5F) * 2 / static_cast<float>(side_) - 1;
    };
    const float infinity = std::numeric_limits<float>::max();
    if (sides_ == 1) {
        const Vec3 origin =
            start_ + across_ * (coordinate(column) * half_) + along_ * (coordinate(row) * half_);
        return {origin, 0, light_.direction, infinity};
    }
    const int axis = face / 2;
    Vec3 direction;
    direction[axis] = face % 2 == 0 ? 1.0F : -1.0F;
    direction[(axis + 1) % 3] = coordinate(column);
    direction[(axis + 2) % 3] = coordinate(row);
    return {light_.position, nearest_, normalize(direction), infinity};
}

Colour ShadowMap::arriving(Vec3 position, Vec3 normal) const {
    const Lookup at = lookUp(position + normal * (texelWidth(position) * kOffSurface));
    const Texel& texel = texels_[at.texel];
    if (at.squareDistance <= texel.squareClear) return kWhite;
    if (at.squareDistance > texel.squareReach) return {};
    constexpr float kUnit = 1.0F / 255;
    return Colour{static_cast<float>(texel.tint[0]), static_cast<float>(texel.tint[1]),
                  static_cast<float>(texel.tint[2])} *
           kUnit;
}

void ShadowMap::set(std::size_t texel, const LightEnd& end) {
    Texel& to = texels_[texel];
    to.squareClear = end.clear * end.clear * kRounding;
    to.squareReach = end.distance * end.distance * kRounding;
    const auto byte = [](float weight) {
        return static_cast<std::uint8_t>(std::clamp(weight, 0.0F, 1.0F) * 255 + 0.5F);
    };
    to.tint[0] = byte(end.tint.r);
    to.tint[1] = byte(end.tint.g);
    to.tint[2] = byte(end.tint.b);
}

bool ShadowMap::fill(ShadowTracer& shadows, const std::atomic<bool>& cancel) {
    RayWave rays;
    std::vector<std::size_t> texels;
    for (int top = 0; top < sides_ * side_; top += kBlock) {
        if (cancel.load(std::memory_order_relaxed)) return false;
        rays.clear();
        texels.clear();
        for (int left = 0; left < side_; left += kBlock) {
            for (int i = 0; i < kBlock * kBlock; ++i) {
                const int row = top + i / kBlock, column = left + i % kBlock;
                rays.push(rayThrough(row / side_, column, row % side_));
                texels.push_back(static_cast<std::size_t>(row * side_ + column));
            }
        }
        const std::vector<LightEnd>& ends = shadows.ends(rays);
        for (std::size_t i = 0; i < ends.size(); ++i) set(texels[i], ends[i]);
    }
    return true;
}

std::unique_ptr<const ShadowMaps> ShadowMaps::make(const Scene& scene, const RayTracer& tracer,
                                                   const std::atomic<bool>& cancel) {
    if (scene.lights.size() > kMaxLights) return nullptr;
    auto maps = std::make_unique<ShadowMaps>();
    const RenderSettings settings;
    MaterialTable materials;
    materials.prepare(scene, settings);
    maps->tinted_ = materials.tintedShadows();
    ShadowTracer shadows;
    shadows.begin(scene, tracer, settings, materials.clear());
    const std::size_t texels = std::min(kTexels, kAllTexels / std::max<std::size_t>(1, scene.lights.size()));
    for (const SceneLight& each : scene.lights) {
        maps->maps_.emplace_back(ShadowMap(each.light, tracer.bounds(), texels));
        if (!maps->maps_.back().fill(shadows, cancel)) return nullptr;
    }
    return maps;
}

bool ShadowMaps::suit(const RenderSettings& settings) const {
    return !tinted_ || (settings.textures && settings.refractions);
}

} // namespace rtcore

#include "rtcore/lights/emitters.h"

#include "rtcore/lights/emitters-inl.h"
#include "rtcore/scene/material_edit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rtcore {

namespace {

namespace plain = HWY_NAMESPACE;

constexpr std::size_t kMaxEmitters = std::size_t{1} << 24U;
constexpr std::uint32_t kNoEmitter = std::numeric_limits<std::uint32_t>::max();
/// Squares of double areas between which all digits of the densities are there.
constexpr float kMinSquareOfArea = 1e-36F, kMaxSquareOfArea = 1e36F;

double luminanceOf(Colour radiance, Colour texture) {
    const auto product = [](float a, float b, float c) {
        return static_cast<double>(a) * static_cast<double>(b) * static_cast<double>(c);
    };
    return product(kLuminance.r, radiance.r, texture.r) + product(kLuminance.g, radiance.g, texture.g) +
           product(kLuminance.b, radiance.b, texture.b);
}

/// Luminance of each material's emission; 0 where it lights nothing.
std::vector<double> emissions(const Scene& scene, const EmitterChoice& choice) {
    std::vector<double> all;
    for (std::size_t i = 0; i < scene.materials.size() + (scene.ground ? 1 : 0); ++i) {
        const Material& m = scene.material(static_cast<std::uint32_t>(i));
        const bool black =
            isBlack(m.emission) || (i < choice.emitsNoLight.size() && choice.emitsNoLight[i] != 0);
        const bool textured = !black && choice.textures && m.emissionTexture != kNoTexture;
        const Colour mean = textured ? textureMean(scene.model, m.emissionTexture) : kWhite;
        const double luminance = black ? 0 : luminanceOf(m.emission, mean);
        all.push_back(luminance > 0 && std::isfinite(luminance) ? luminance : 0);
    }
    return all;
}

double areaOf(Vec3 normal) {
    const float square = dot(normal, normal);
    const bool exact = square > kMinSquareOfArea && square < kMaxSquareOfArea;
    return exact ? 0.5 * static_cast<double>(plain::doubleArea<float>(normal)) : 0;
}

/// The mean of positions.
class WeightedPosition {
  public:
    void add(Vec3 p, double weight) {
        sum_ = sum_ + Vec3d{p.x, p.y, p.z} * weight;
        weights_ += weight;
    }
    Vec3 get() const {
        const Vec3d mean = sum_ / weights_;
        return {static_cast<float>(mean.x), static_cast<float>(mean.y), static_cast<float>(mean.z)};
    }

  private:
    Vec3d sum_;
    double weights_ = 0;
};

} // namespace

void Emitters::prepare(const Scene& scene, const EmitterChoice& choice) {
    *this = {};
    mesh_ = scene.mesh();
    std::vector<double> powers;
    addTriangles(scene, choice, powers);
    if (triangles_.empty()) return;
    if (triangles_.size() > kMaxEmitters) {
        *this = {};
        return;
    }
    if (triangles_.size() > kMaxWithoutTree) {
        clusters_.prepare(mesh_, triangles_, powers);
    } else {
        table_ = AliasTable(powers);
    }
    const double max = *std::max_element(powers.begin(), powers.end());
    WeightedPosition centre;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 p = mesh_.position(triangles_[i], corner);
            bounds_.extend(p);
            centre.add(p, powers[i] / max);
        }
        power_ += powers[i];
    }
    centre_ = centre.get();
}

void Emitters::addTriangles(const Scene& scene, const EmitterChoice& choice, std::vector<double>& powers) {
    const std::vector<double> luminances = emissions(scene, choice);
    if (std::all_of(luminances.begin(), luminances.end(), [](double l) { return l == 0; })) return;
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
        const double luminance = luminances[mesh_.shading[i].material];
        if (luminance == 0 || (i < choice.hidden.size() && choice.hidden[i] != 0)) continue;
        const double power = 2 * std::numbers::pi * luminance * areaOf(mesh_.geometricNormal(i));
        if (power == 0) continue;
        if (triangles_.empty() || triangles_.back() + 1 != i)
            runs_.push_back({i, static_cast<std::uint32_t>(triangles_.size())});
        triangles_.push_back(i);
        powers.push_back(power);
    }
}

float Emitters::density(std::uint32_t triangle, float distance, float cosine) const {
    return plain::bySolidAngle<float>(areaDensity(triangle), distance, cosine);
}

float Emitters::areaDensity(std::uint32_t triangle) const {
    const std::uint32_t emitter = emitterOf(triangle);
    if (emitter == kNoEmitter) return 0;
    const float twice = plain::doubleArea<float>(plain::normalOf(plain::cornersOf<float>(rows(), triangle)));
    const float probability =
        clusters_.empty() ? table_.probability(emitter) : clusters_.probability(emitter);
    return 2.0F * probability / twice;
}

std::uint32_t Emitters::clusterOf(std::uint32_t triangle) const {
    return clusters_.empty() ? 0 : clusters_.clusterOf(emitterOf(triangle));
}

std::uint32_t Emitters::emitterOf(std::uint32_t triangle) const {
    const auto after =
        std::upper_bound(runs_.begin(), runs_.end(), triangle,
                         [](std::uint32_t t, const Run& run) { return t < run.firstTriangle; });
    if (after == runs_.begin()) return kNoEmitter;
    const Run& run = *(after - 1);
    const std::uint32_t emitter = run.firstEmitter + (triangle - run.firstTriangle);
    return emitter < triangles_.size() && triangles_[emitter] == triangle ? emitter : kNoEmitter;
}

EmitterRows Emitters::rows() const {
    EmitterRows rows;
    if (empty()) return rows;
    rows.corners = mesh_.triangles.data()->v;
    rows.vertices = &mesh_.vertices.data()->x;
    if (clusters_.empty()) {
        rows.choice = table_.rows();
        rows.triangles = triangles_.data();
        return rows;
    }
    const EmitterClusterRows clusters = clusters_.rows();
    rows.choice = clusters.choice;
    rows.triangles = clusters.triangles;
    rows.tree = clusters.tree;
    rows.rowBits = clusters.rowBits;
    return rows;
}

} // namespace rtcore

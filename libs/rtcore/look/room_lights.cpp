#include "rtcore/look/room_lights.h"

#include "rtcore/survey/closest_hit.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

namespace rtcore {

namespace {

constexpr float kBelowCeiling = 0.25F; ///< of the room's height
constexpr float kSize = 0.06F;         ///< radius, of the room's height
constexpr float kLittle = 0.04F;       ///< of what all places want: what one more light must bring
constexpr float kMaxScale = 2;

/// Above a place to stand on.
struct LightCandidate {
    Vec3 position;
    float height = 0; ///< over the floor
    float room = 0;   ///< height of the room
};

class RoomLighting {
  public:
    RoomLighting(const KdTree& tree, const Mesh& mesh, Vec3 up, const std::vector<Stand>& rooms)
        : tree_(tree), mesh_(mesh) {
        for (const Stand& stand : rooms) {
            eyes_.push_back(stand.eye);
            if (const auto found = above(stand.eye, up)) candidates_.push_back(*found);
        }
        light_.assign(eyes_.size(), 0);
    }

    std::vector<Light> choose() {
        std::vector<LightCandidate> chosen;
        const auto wanted = static_cast<float>(eyes_.size());
        while (std::cmp_less(chosen.size(), kMaxRoomLights)) {
            const LightCandidate* const best = bestCandidate();
            if (best == nullptr) break;
            const std::vector<float> with = lightWith(*best);
            if (satisfied(with) - satisfied(light_) < kLittle * wanted) break;
            light_ = with;
            chosen.push_back(*best);
        }
        const float scale = std::min(wanted / std::max(satisfied(light_), 1e-6F), kMaxScale);
        std::vector<Light> lights;
        for (const LightCandidate& candidate : chosen) lights.push_back(lightOf(candidate, scale));
        return lights;
    }

  private:
    static Light lightOf(const LightCandidate& candidate, float scale) {
        Light light;
        light.kind = LightKind::Sphere;
        light.position = candidate.position;
        light.radius = kSize * candidate.room;
        light.intensity = kWhite * (scale * candidate.height * candidate.height);
        return light;
    }

    std::optional<LightCandidate> above(Vec3 eye, Vec3 up) const {
        const auto ceiling = closestHit(tree_, mesh_, eye, up), floor = closestHit(tree_, mesh_, eye, -up);
        if (!ceiling || !floor) return std::nullopt;
        const float room = ceiling->t + floor->t;
        const float above = std::max(ceiling->t - kBelowCeiling * room, 0.5F * ceiling->t);
        return LightCandidate{eye + up * above, above + floor->t, room};
    }

    /// At each eye, with one more light there; 1 as on the floor below a light.
    std::vector<float> lightWith(const LightCandidate& candidate) const {
        std::vector<float> light = light_;
        for (std::size_t i = 0; i < eyes_.size(); ++i) {
            const Vec3 toLight = candidate.position - eyes_[i];
            if (!occluded(tree_, mesh_, {eyes_[i], 0, toLight, 1}))
                light[i] += std::min(candidate.height * candidate.height / dot(toLight, toLight), 1.0F);
        }
        return light;
    }

    static float satisfied(const std::vector<float>& light) {
        return std::accumulate(light.begin(), light.end(), 0.0F,
                               [](float sum, float each) { return sum + std::min(each, 1.0F); });
    }

    const LightCandidate* bestCandidate() const {
        const LightCandidate* best = nullptr;
        float max = 0;
        for (const LightCandidate& candidate : candidates_) {
            const float sum = satisfied(lightWith(candidate));
            if (sum <= max) continue;
            max = sum;
            best = &candidate;
        }
        return best;
    }

    const KdTree& tree_;
    const Mesh& mesh_;
    std::vector<Vec3> eyes_;
    std::vector<LightCandidate> candidates_;
    std::vector<float> light_; ///< of the lights that were chosen, at each eye
};

} // namespace

std::vector<Light> roomLights(const KdTree& tree, const Mesh& mesh, const Survey& survey) {
    if (!survey.inside()) return {};
    return RoomLighting(tree, mesh, survey.axes.up, survey.rooms).choose();
}

} // namespace rtcore

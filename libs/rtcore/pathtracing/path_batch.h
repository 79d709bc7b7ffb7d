/// The rays of a step of many paths: a path goes on by one ray at most.
#pragma once

#include "rtcore/kernels/wave_memory.h"
#include "rtcore/shading/paths/path_queue.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// Bits of ScatterState::state: how often the path has scattered, and which light its ray counts.
namespace path_state {
inline constexpr std::uint32_t kScatters = 0xFFFF;
inline constexpr std::uint32_t kDropped = 1U << 16; ///< neither emission nor surroundings
inline constexpr std::uint32_t kWhole = 1U << 17;   ///< all of them: next event leaves them out
inline constexpr std::uint32_t kMatte = 1U << 18;   ///< the last scattering sampled a matte lobe
/// The ray gathers light for a point that takes that of lights and emitters by itself.
inline constexpr std::uint32_t kGathers = 1U << 19;
} // namespace path_state

/// Where each ray of a batch was scattered, for the weights of what it finds: one element for each ray, and
/// room for a block more.
struct ScatterState {
    ArraysOf3 point, normal;       ///< the ray's line begins there; the shading normal, unit
    float* total = nullptr;        ///< ChosenLight::total there
    std::uint32_t* cell = nullptr; ///< ChosenLight::cell there
    float* density = nullptr; ///< of the ray's direction by all lobes that scatter, 1/sr; 0: it comes from
                              ///< the camera, or was mirrored or refracted since
    std::uint32_t* state = nullptr; ///< path_state

    void clear(std::size_t i) const {
        point.set(i, Vec3());
        normal.set(i, Vec3());
        total[i] = density[i] = 0;
        cell[i] = state[i] = 0;
    }
    void copy(std::size_t i, const ScatterState& from, std::size_t k) const {
        point.set(i, from.point.at(k));
        normal.set(i, from.normal.at(k));
        total[i] = from.total[k];
        density[i] = from.density[k];
        cell[i] = from.cell[k];
        state[i] = from.state[k];
    }
};

/// Keeps its memory.
class PathBatch {
  public:
    PathQueue queue;

    const ScatterState& scattered() const { return scattered_; }
    /// Empties the batch and makes room for `count` rays and a block more.
    void start(std::size_t count) {
        queue.clear();
        queue.grow(count + kWaveBlock);
        queue.truncate(0);
        memory_.resize(8, count + kWaveBlock);
        const std::size_t room = count + 2 * kWaveBlock;
        if (states_.size() < room) {
            states_.resize(room);
            cells_.resize(room);
        }
        scattered_ = {memory_.arraysOf3(0), memory_.arraysOf3(3), memory_.array(6),
                      cells_.data(),        memory_.array(7),     states_.data()};
    }

    /// Adds a ray that leaves a matte point for the sample of this number (path_state::kGathers).
    void pushGathering(const Ray& ray, std::uint32_t sample) {
        Path path;
        path.sample = sample;
        pushStraight(ray, path, nullptr, 0);
        scattered_.state[queue.size() - 1] = 1U | path_state::kMatte | path_state::kGathers;
    }

    /// Adds a ray that continues ray `i` of `from` (null: a ray of the camera) in a straight line.
    void pushStraight(const Ray& ray, const Path& path, const PathBatch* from, std::size_t i) {
        const std::size_t to = queue.size();
        queue.push(ray, path);
        if (from == nullptr) {
            scattered_.clear(to);
            return;
        }
        scattered_.copy(to, from->scattered_, i);
    }

  private:
    WaveMemory memory_;
    std::vector<std::uint32_t> states_, cells_;
    ScatterState scattered_;
};

} // namespace rtcore

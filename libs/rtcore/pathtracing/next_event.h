/// Next event estimation: from each point one light is sampled, and one shadow ray goes there.
#pragma once

#include "rtcore/kernels/wave_memory.h"
#include "rtcore/pathtracing/kept_light.h"
#include "rtcore/pathtracing/light_set.h"
#include "rtcore/pathtracing/path_names.h"
#include "rtcore/pathtracing/sampling_strategy.h"
#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/wave.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// One sample of a light from each point of a wave, and room for whole blocks.
struct LightSamples {
    std::uint32_t* group = nullptr; ///< LightRows; kNone where nothing is sampled
    ArraysOf3 toLight;              ///< unit
    ArraysOf3 irradiance;           ///< before shadows, over the probability that this group is sampled
    float* free = nullptr;          ///< length of the shadow ray
    float* density = nullptr;       ///< of the direction among all samples, 1/sr; 0: no ray meets this light
    float* total = nullptr;         ///< ChosenLight::total
    std::uint32_t* cell = nullptr;  ///< ChosenLight::cell

    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
};

/// How the next events of a wave count.
struct NextEventTask {
    const LightSet& lights;
    const LightRows& rows;
    const Scene& scene;
    bool textures; ///< RenderSettings::textures
    PathNames names;
    const std::uint32_t* scatters; ///< of each path of the wave (path_state); null: none yet
    std::uint32_t bounces;         ///< paths with more scatters sample nothing
    SamplingStrategy strategy;
    bool
        apart; ///< the samples' weights are not multiplied in: glass may leave scattered rays no part in them
};

/// One for each thread; keeps its memory.
class NextEvents {
  public:
    /// Samples a light from each point with the trait kPoint, with the numbers of its path.
    void sample(const NextEventTask& task, const Wave& wave);
    const LightSamples& samples() const { return samples_; }
    /// Adds to `kept`, which has room for all points, each sample that adds something: what it adds
    /// unshadowed, weighted by the power heuristic against the lobes (path_lobes-inl.h) unless task.apart.
    void add(const NextEventTask& task, const MaterialTable& materials, const Wave& wave,
             KeptLight& kept) const;

  private:
    void resize(std::size_t count);
    void lookUp(const NextEventTask& task, const Wave& wave);
    Colour radianceOf(const NextEventTask& task, std::size_t i) const;

    WaveMemory memory_;
    std::vector<std::uint32_t> group_, triangle_, cell_;
    std::vector<float> u_, v_;
    LightSamples samples_;
};

} // namespace rtcore

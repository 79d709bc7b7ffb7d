/// The light of next event that a step of paths found, kept until the shadows of all of it are traced at
/// once.
#pragma once

#include "rtcore/kernels/ray_wave.h"
#include "rtcore/kernels/wave_memory.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// One element for each shadow ray, and room for a block more. Keeps its memory.
class KeptLight {
  public:
    RayWave rays;            ///< longer than size() until finish()
    ArraysOf3 light;         ///< that it adds to its sample, unshadowed
    float* weight = nullptr; ///< by the power heuristic
    std::uint32_t* sample = nullptr;
    std::uint32_t* group = nullptr;    ///< LightSamples
    std::uint32_t* scatters = nullptr; ///< of the path so far

    /// Empties it and makes room for `count` rays. What is added goes behind the others, into the arrays
    /// themselves.
    void start(std::size_t count) {
        const std::size_t room = count + kWaveBlock;
        size_ = 0;
        rays.resize(room);
        memory_.resize(4, room);
        light = memory_.arraysOf3(0);
        weight = memory_.array(3);
        if (numbers_.size() < 3 * room) numbers_.resize(3 * room);
        sample = numbers_.data();
        group = sample + room;
        scatters = group + room;
    }
    std::size_t size() const { return size_; }
    void added(std::size_t count) { size_ += count; }
    /// Once all are there.
    void finish() { rays.resize(size_); }

  private:
    std::size_t size_ = 0;
    WaveMemory memory_;
    std::vector<std::uint32_t> numbers_;
};

} // namespace rtcore

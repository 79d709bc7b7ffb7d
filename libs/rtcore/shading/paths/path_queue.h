/// Rays that wait to be traced, and what each is for.
#pragma once

#include "rtcore/kernels/arrays_of_3.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/kernels/wave_memory.h"
#include "rtcore/math/colour.h"
#include "rtcore/scene/media_list.h"

#include <cstdint>
#include <vector>

namespace rtcore {

struct Path {
    std::uint32_t sample = 0;   ///< index of the primary ray it began with
    Colour weight{1, 1, 1};     ///< throughput: the fraction of its radiance that reaches the sample
    Colour extinction;          ///< of the solid that it is inside of, per scene unit
    std::uint16_t depth = 0;    ///< mirrored or refracted so often
    std::uint16_t passes = 0;   ///< went straight through thin walls and holes so often; below 2^14
    bool inside = false;        ///< of a transparent solid
    bool lobeSeesDiscs = false; ///< discs of lights count for the highlight of the surface that it was
                                ///< mirrored at last: it does not see them
    MediaList media;            ///< solids that it is inside of, where some may overlap
    /// How far from the primary ray's origin this one seems to begin, as seen along that: mirrors and
    /// panes that are flat only fold the way. Once a curved one has bent it, minus the way up to that.
    float length = 0;
};

inline constexpr std::uint32_t kInsideBit = 0x80000000U; ///< of PathQueue::bounces
inline constexpr std::uint32_t kLobeBit = 0x40000000U;   ///< the same
constexpr bool isInside(std::uint32_t bounces) { return (bounces & kInsideBit) != 0; }

/// One array for each value, as vector code likes it: those of the paths have room for a block more than
/// there are rays.
struct PathQueue {
    RayWave rays;
    std::vector<std::uint32_t> sample;
    std::vector<std::uint32_t> bounces; ///< depth in the lower 16 bits, passes in 14, lobeSeesDiscs, inside
    std::vector<float> weight[3], extinction[3];
    std::vector<float> length;
    std::vector<std::uint32_t> media[2]; ///< lower and higher bits; empty as long as all are

    std::size_t size() const { return rays.size(); }
    bool empty() const { return rays.empty(); }
    void clear() { rays.clear(); }
    void push(const Ray& ray, const Path& path);
    Path path(std::size_t i) const;
    ArraysOf3 weights() { return {weight[0].data(), weight[1].data(), weight[2].data()}; }
    ArraysOf3 extinctions() { return {extinction[0].data(), extinction[1].data(), extinction[2].data()}; }

    bool hasMedia() const { return !media[0].empty(); }
    /// From now on it has.
    void keepMedia();
    /// Null where it has none.
    std::uint32_t* mediaFrom(int half, std::size_t first) {
        return hasMedia() ? media[half].data() + first : nullptr;
    }

    /// Appends `count` rays with undefined origins, directions and paths, from 0 to infinity, and returns how
    /// many there were before.
    std::size_t grow(std::size_t count);
    void truncate(std::size_t count) { rays.resize(count); }

    /// Moves the last `count` (or all, when there are fewer) into `taken`, whose content is replaced.
    void takeLast(std::size_t count, PathQueue& taken);
    /// Room for `count`, or for as many as the largest of the queues has ever had.
    void reserve(std::size_t count);
    std::size_t capacity() const { return rays.ox.capacity(); }
};

} // namespace rtcore

/// The memory that waves are traced in.
#pragma once

#include "rtcore/accel/uninitialized_array.h"
#include "rtcore/kernels/bundle_choice.h"

#include <cstddef>
#include <cstdint>

namespace rtcore {

/// One for each thread; kept from wave to wave, since making it anew costs more than tracing. Takes 83 MB of
/// address space for streams of up to 16,384 rays and 331 MB for longer ones; a wave touches what it needs.
class StreamScratch {
  public:
    /// Rays that are traced together at most.
    static constexpr std::size_t kRays = 65536;
    static constexpr std::size_t kGroup = 64; ///< rays that are judged coherent or not together
    static constexpr std::size_t kPadding = 64;
    /// Values of each ray in a list: slot, t0, t1, origin, direction.
    static constexpr std::size_t kColumns = 9;

    static constexpr std::size_t kTurns = 2; ///< walks that take turns, each with columns of its own

    /// Before a stream of `rays` is walked. Whatever the columns held may be lost, and `column` moves.
    /// @throws std::bad_alloc
    void makeRoom(std::size_t rays);

    float* column(std::size_t turn, std::size_t i) {
        return columns_.data() + (turn * kColumns + i) * stride_;
    }

    /// By slot: the state of each ray of the stream.
    alignas(64) float tMin[kRays + kPadding];
    alignas(
        64) float best[kRays + kPadding]; ///< distance of the closest hit; for any hit tMax, or -1 once hit
    alignas(64) std::int32_t triangle[kRays + kPadding];
    alignas(64) float v[kRays + kPadding], w[kRays + kPadding], det[kRays + kPadding];
    alignas(64) float rootBegin[kRays + kPadding], rootEnd[kRays + kPadding]; ///< in the root's cell
    alignas(64) std::int32_t octant[kRays + kPadding]; ///< 0..7; 8 outside the root's cell
    /// Where the rays of the list being split leave the near child, and where they enter the far one.
    alignas(64) float nearEnd[kRays + kPadding], farBegin[kRays + kPadding];
    /// First rays of the groups that wait to be streamed.
    std::uint32_t groups[kRays / kGroup];
    std::size_t groupCount = 0;

    BundleChoice bundleChoice;

  private:
    std::size_t rays_ = 0; ///< that the columns have room for
    std::size_t stride_ = 0;
    UninitializedArray<float> columns_;
};

} // namespace rtcore

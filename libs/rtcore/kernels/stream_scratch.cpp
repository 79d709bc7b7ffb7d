#include "rtcore/kernels/stream_scratch.h"

#include "rtcore/accel/kd_node.h"

namespace rtcore {

namespace {

constexpr std::size_t kShortStream = 16384;

// A walk holds at most one list at each level of the tree, none longer than the stream, and of the lists
// being split a series of copies, each at most three quarters of the one before.
constexpr std::size_t strideFor(std::size_t rays) {
    constexpr std::size_t kLists = kMaxKdDepth + 6;
    constexpr std::size_t kOtherSet = 80; // columns begin in different sets of the cache
    return kLists * (rays + StreamScratch::kPadding) + kOtherSet;
}
static_assert(strideFor(kShortStream) * sizeof(float) % 64 == 0);
static_assert(strideFor(StreamScratch::kRays) * sizeof(float) % 64 == 0);

} // namespace

void StreamScratch::makeRoom(std::size_t rays) {
    if (rays <= rays_) return;
    columns_ = {}; // first, so that both are never held at once
    rays_ = 0;
    const std::size_t room = rays <= kShortStream ? kShortStream : kRays;
    stride_ = strideFor(room);
    columns_ = UninitializedArray<float>(stride_ * kColumns * kTurns);
    rays_ = room;
}

} // namespace rtcore

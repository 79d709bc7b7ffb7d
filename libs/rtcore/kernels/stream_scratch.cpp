#include "rtcore/kernels/stream_scratch.h"

#include "rtcore/accel/kd_node.h"

namespace rtcore {

namespace {

// A walk holds at most one list at each level of the tree, none longer than the stream, and of the lists
// being split a series of copies, each at most three quarters of the one before.
constexpr std::size_t kRoom = (kMaxKdDepth + 6) * (StreamScratch::kRays + StreamScratch::kPadding);
// Columns begin in different sets of the cache.
constexpr std::size_t kStride = kRoom + 80;
static_assert(kStride * sizeof(float) % 64 == 0);

} // namespace

StreamScratch::StreamScratch() : stride_(kStride), columns_(kStride * kColumns * kTurns) {}

} // namespace rtcore

#include "rtcore/kernels/stream_scratch.h"

#include "rtcore/accel/kd_node.h"

namespace rtcore {

namespace {

// A walk holds at most one list at each level of the tree, none longer than the stream.
constexpr std::size_t kRoom = (kMaxKdDepth + 2) * (StreamScratch::kRays + StreamScratch::kPadding);
// Columns begin in different sets of the cache.
constexpr std::size_t kStride = kRoom + 80;

} // namespace

StreamScratch::StreamScratch() : stride_(kStride), columns_(new float[kStride * kColumns]) {}

} // namespace rtcore

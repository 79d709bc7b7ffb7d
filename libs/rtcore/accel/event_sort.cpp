#include "rtcore/accel/event_sort.h"

#include "rtcore/accel/float4.h"
#include "rtcore/accel/pool.h"
#include "rtcore/accel/rank_sort.h"
#include "rtcore/accel/task_loop.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

constexpr unsigned kDigitBits = 11;
/// Lists of fewer events are sorted by smaller digits, since counters cost as much as they.
constexpr std::size_t kLargeDigitsFrom = 2048;
constexpr unsigned kSmallDigitBits = 8;
/// Below this insertion is quickest.
constexpr std::size_t kRankedFrom = 8;

/// One stable pass of a radix sort by the digit of `bits` bits from `shift` on.
void radixPass(const Event* from, std::size_t count, Event* to, Event min, unsigned shift, unsigned bits) {
    std::array<std::uint32_t, std::size_t{1} << kDigitBits> next;
    const Event mask = (Event{1} << bits) - 1;
    std::fill_n(next.begin(), mask + 1, 0U);
    for (std::size_t i = 0; i < count; ++i) ++next[((from[i] >> 30U) - min) >> shift & mask];
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i <= mask; ++i) sum += std::exchange(next[i], sum);
    for (std::size_t i = 0; i < count; ++i) {
        to[next[((from[i] >> 30U) - min) >> shift & mask]++] = from[i];
    }
}

/// Slices of space along each axis, so that the events of each fit into a cache. Planes in order fall into
/// slices in order.
struct Slices {
    Slices(const Box3& bounds, std::size_t number) : last(set4(static_cast<float>(number - 1))) {
        for (int a = 0; a < 3; ++a) {
            lo[a] = bounds.lo[a];
            scale[a] = static_cast<float>(number) / (bounds.hi[a] - bounds.lo[a]);
            if (!(scale[a] > 0 && scale[a] < Box3::kHuge)) scale[a] = 0;
        }
    }
    Int4 of(Float4 position) const { return truncate4(min4(max4((position - lo) * scale, Float4{}), last)); }

    Float4 lo{}, scale{}, last;
};

constexpr std::size_t kEventsPerSlice = 24'000;
constexpr std::size_t kMaxSlices = 128;
constexpr std::size_t kTrianglesPerChunk = 32'768;

/// For each axis and slice, events of one chunk of triangles: how many, and later where the next goes.
using Counters = std::array<std::array<std::size_t, kMaxSlices>, 3>;

class MeshEvents {
  public:
    MeshEvents(const Mesh& mesh, const Box3& bounds)
        : mesh_(mesh), count_(mesh.triangles.size()),
          sliceCount_(std::clamp<std::size_t>(2 * count_ / kEventsPerSlice, 1, kMaxSlices)),
          slices_(bounds, sliceCount_), counters_((count_ + kTrianglesPerChunk - 1) / kTrianglesPerChunk) {}

    std::array<EventList, 3> make() {
        forEachInTasks(counters_.size(), [&](std::size_t chunk) { countEvents(chunk); });
        for (std::size_t a = 0; a < 3; ++a) assignPlaces(a);
        forEachInTasks(counters_.size(), [&](std::size_t chunk) { placeEvents(chunk); });
        forEachInTasks(3 * sliceCount_, [&](std::size_t i) {
            const std::size_t a = i / sliceCount_;
            const std::size_t slice = i % sliceCount_;
            const auto scratch = scratch_.borrow([] { return std::make_unique<EventList>(); });
            sortEvents(lists_[a].data() + sliceFirst_[a][slice],
                       sliceFirst_[a][slice + 1] - sliceFirst_[a][slice], *scratch);
        });
        return std::move(lists_);
    }

  private:
    template <typename Visit>
    void visitEvents(std::size_t chunk, const Visit& visit) const {
        const std::size_t end = std::min(count_, (chunk + 1) * kTrianglesPerChunk);
        for (std::size_t i = chunk * kTrianglesPerChunk; i < end; ++i) {
            Bounds4 box = boundsOf(mesh_, i);
            box.lo[3] = box.hi[3] = 0;
            const Int4 startSlice = slices_.of(box.lo);
            const Int4 endSlice = slices_.of(box.hi);
            for (int axis = 0; axis < 3; ++axis) {
                const auto a = static_cast<std::size_t>(axis);
                std::array<Event, 2> pair{};
                const Event* const last =
                    writeEvents(box.lo[axis], box.hi[axis], static_cast<std::uint32_t>(i), pair.data());
                visit(a, static_cast<std::size_t>(startSlice[axis]), pair[0]);
                if (last == pair.data() + 2) visit(a, static_cast<std::size_t>(endSlice[axis]), pair[1]);
            }
        }
    }

    void countEvents(std::size_t chunk) {
        Counters& counters = counters_[chunk];
        visitEvents(chunk, [&](std::size_t a, std::size_t slice, Event) { ++counters[a][slice]; });
    }

    void assignPlaces(std::size_t a) {
        std::size_t offset = 0;
        for (std::size_t slice = 0; slice < sliceCount_; ++slice) {
            sliceFirst_[a][slice] = offset;
            for (Counters& chunk : counters_) offset += std::exchange(chunk[a][slice], offset);
        }
        sliceFirst_[a][sliceCount_] = offset;
        lists_[a] = EventList(offset);
        lists_[a].setSize(offset);
    }

    void placeEvents(std::size_t chunk) {
        Counters& next = counters_[chunk];
        visitEvents(chunk, [&](std::size_t a, std::size_t slice, Event e) {
            lists_[a].data()[next[a][slice]++] = e;
        });
    }

    const Mesh& mesh_;
    std::size_t count_;
    std::size_t sliceCount_;
    Slices slices_;
    std::vector<Counters> counters_;
    std::array<std::array<std::size_t, kMaxSlices + 1>, 3> sliceFirst_{};
    std::array<EventList, 3> lists_;
    Pool<EventList> scratch_;
};

} // namespace

void sortFewEvents(Event* events, std::size_t count) {
    if (count < kRankedFrom || count > kMaxRanked) {
        std::sort(events, events + count);
    } else {
        rankSort(events, count);
    }
}

void sortEvents(Event* events, std::size_t count, EventList& scratch) {
    if (count <= kMaxRanked) {
        sortFewEvents(events, count);
        return;
    }
    // Kind and position are the upper 34 bits; the triangles below them are in order already.
    const auto [first, last] = std::minmax_element(events, events + count);
    const Event min = *first >> 30U;
    const auto bits = static_cast<unsigned>(std::bit_width((*last >> 30U) - min));
    const unsigned max = count < kLargeDigitsFrom ? kSmallDigitBits : kDigitBits;
    const unsigned passes = (bits + max - 1) / max;
    if (passes == 0) return;
    const unsigned digit = (bits + passes - 1) / passes;
    if (scratch.capacity() < count) scratch = EventList(count);
    Event* from = events;
    Event* to = scratch.data();
    for (unsigned pass = 0; pass < passes; ++pass) {
        radixPass(from, count, to, min, pass * digit, digit);
        std::swap(from, to);
    }
    if (from != events) std::copy(from, from + count, events);
}

std::array<EventList, 3> makeEvents(const Mesh& mesh, const Box3& bounds) {
    return MeshEvents(mesh, bounds).make();
}

} // namespace rtcore

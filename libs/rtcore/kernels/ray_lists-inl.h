// Lists of the rays of a stream, one for each node on the way of a walk. Included once for each target.
#if defined(RTCORE_KERNELS_RAY_LISTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_RAY_LISTS_INL_H_
#undef RTCORE_KERNELS_RAY_LISTS_INL_H_
#else
#define RTCORE_KERNELS_RAY_LISTS_INL_H_
#endif

#include "rtcore/kernels/ray_box-inl.h"
#include "rtcore/kernels/stream_scratch.h"
#include "rtcore/simd/compaction-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The lists of one walk, in columns of the scratch.
class RayLists {
  public:
    /// The rays that enter a node. Their slots, origins and directions lie at [rays, rays + size) of the
    /// columns, their intervals at [intervals, intervals + size). Some of these are empty: a list is only
    /// copied where too few of its rays go on, else the two children share the rays. Vectors are always
    /// whole.
    struct List {
        std::uint32_t node;
        std::size_t rays, intervals, size;
        std::size_t active; ///< rays whose interval is not empty
    };

    static constexpr std::size_t wholeVectors(std::size_t rays) {
        return (rays + kLanes - 1) / kLanes * kLanes;
    }

    /// `turn`: which of the scratch's columns it works in.
    RayLists(StreamScratch& scratch, std::size_t turn) : scratch_(scratch) {
        for (std::size_t i = 0; i < StreamScratch::kColumns; ++i) columns_[i] = scratch.column(turn, i);
    }

    /// The list of the rays of one octant, of those in the scratch's groups, at the root.
    HWY_INLINE List collect(const RaySpan& rays, std::uint32_t octant) {
        const FloatTag d;
        const IntTag di;
        List list{0, 0, 0, 0, 0};
        for (std::size_t group = 0; group < scratch_.groupCount; ++group) {
            for (std::size_t lane = 0; lane < StreamScratch::kGroup; lane += kLanes) {
                const std::size_t from = scratch_.groups[group] + lane;
                const std::size_t slot = group * StreamScratch::kGroup + lane;
                const Mask here = hn::RebindMask(d, hn::Eq(hn::Load(di, scratch_.octant + slot),
                                                           hn::Set(di, static_cast<std::int32_t>(octant))));
                if (hn::AllFalse(d, here)) continue;
                const RayVector ray = loadRays(rays, from);
                const Ints slots = hn::Iota(di, static_cast<std::int32_t>(slot));
                const Compaction some(here);
                some.store(hn::BitCast(d, slots), columns_[Slot] + list.active);
                some.store(hn::Load(d, scratch_.rootBegin + slot), columns_[T0] + list.active);
                some.store(hn::Load(d, scratch_.rootEnd + slot), columns_[T1] + list.active);
                some.store(ray.ox, columns_[Origin] + list.active);
                some.store(ray.oy, columns_[Origin + 1] + list.active);
                some.store(ray.oz, columns_[Origin + 2] + list.active);
                some.store(ray.dx, columns_[Direction] + list.active);
                some.store(ray.dy, columns_[Direction + 1] + list.active);
                some.store(ray.dz, columns_[Direction + 2] + list.active);
                list.active += hn::CountTrue(d, here);
            }
        }
        finish(list);
        return list;
    }

    // Values of the rays [i, i + kLanes) of a list, i a multiple of kLanes:

    HWY_INLINE Floats begin(const List& list, std::size_t i) const { return get(T0, list.intervals + i); }
    HWY_INLINE Floats end(const List& list, std::size_t i) const { return get(T1, list.intervals + i); }
    HWY_INLINE void setEnd(const List& list, std::size_t i, Floats end) const {
        hn::Store(end, FloatTag(), columns_[T1] + list.intervals + i);
    }
    HWY_INLINE Mask entering(const List& list, std::size_t i) const {
        return hn::Le(begin(list, i), end(list, i));
    }
    HWY_INLINE Floats origin(const List& list, std::size_t i, std::size_t axis) const {
        return get(Origin + axis, list.rays + i);
    }
    HWY_INLINE Floats direction(const List& list, std::size_t i, std::size_t axis) const {
        return get(Direction + axis, list.rays + i);
    }
    HWY_INLINE Floats slotBits(const List& list, std::size_t i) const { return get(Slot, list.rays + i); }

    /// Lanes that are not active may hold no slot at all: they read the first.
    HWY_INLINE Ints slotsAt(const List& list, std::size_t i) const {
        const IntTag di;
        const Mask used = entering(list, i);
        return hn::IfThenElseZero(hn::RebindMask(di, used), hn::BitCast(di, slotBits(list, i)));
    }

    /// Where each ray of the list leaves the near child and enters the far one, and how many do.
    HWY_INLINE void measure(KdNode node, const List& list, std::size_t& entersNear, std::size_t& entersFar) {
        const FloatTag d;
        const Floats plane = hn::Set(d, node.split);
        const float* const origin = columns_[Origin + node.axis()] + list.rays;
        const float* const direction = columns_[Direction + node.axis()] + list.rays;
        const float* const begin = columns_[T0] + list.intervals;
        const float* const end = columns_[T1] + list.intervals;
        const Floats one = hn::Set(d, 1.0F);
        for (std::size_t i = 0; i < list.size; i += kLanes) {
            const Floats inverse = hn::Div(one, hn::Load(d, direction + i));
            const Floats t = hn::Mul(hn::Sub(plane, hn::Load(d, origin + i)), inverse);
            const Floats t0 = hn::Load(d, begin + i);
            const Floats t1 = hn::Load(d, end + i);
            const Floats nearEnd = min(hn::Mul(t, hn::Set(d, kPlaneUp)), t1);
            const Floats farBegin = max(hn::Mul(t, hn::Set(d, kPlaneDown)), t0);
            hn::Store(nearEnd, d, scratch_.nearEnd + i);
            hn::Store(farBegin, d, scratch_.farBegin + i);
            entersNear += hn::CountTrue(d, hn::Le(t0, nearEnd));
            entersFar += hn::CountTrue(d, hn::Le(farBegin, t1));
        }
    }

    /// The list of those that enter the far child, at `top`.
    HWY_INLINE List enterFar(const List& list, std::uint32_t node, std::size_t active, std::size_t& top) {
        const FloatTag d;
        if (isSparse(active, list.size)) {
            return copy(list, node, active, scratch_.farBegin, columns_[T1] + list.intervals, top);
        }
        for (std::size_t i = 0; i < list.size; i += kLanes) {
            hn::Store(hn::Load(d, scratch_.farBegin + i), d, columns_[T0] + top + i);
            hn::Store(hn::Load(d, columns_[T1] + list.intervals + i), d, columns_[T1] + top + i);
        }
        const List far{node, list.rays, top, list.size, active};
        top += list.size;
        return far;
    }

    /// Leaves in `list` those that enter the near child.
    HWY_INLINE void enterNear(List& list, std::uint32_t node, std::size_t active, std::size_t& top) {
        const FloatTag d;
        if (isSparse(active, list.size)) {
            list = copy(list, node, active, columns_[T0] + list.intervals, scratch_.nearEnd, top);
            return;
        }
        for (std::size_t i = 0; i < list.size; i += kLanes) {
            hn::Store(hn::Load(d, scratch_.nearEnd + i), d, columns_[T1] + list.intervals + i);
        }
        list.node = node;
        list.active = active;
    }

  private:
    enum Column { Slot, T0, T1, Origin, Direction = Origin + 3 };

    /// Whether so few rays go on that they are worth copying.
    static bool isSparse(std::size_t active, std::size_t size) { return active * 4 < size * 3; }

    HWY_INLINE Floats get(std::size_t column, std::size_t at) const {
        return hn::LoadU(FloatTag(), columns_[column] + at);
    }

    /// Empty intervals from the last active ray to the end of its vector.
    HWY_INLINE void finish(List& list) {
        const FloatTag d;
        const std::size_t end = list.intervals + list.active;
        hn::StoreU(hn::Set(d, 1.0F), d, columns_[T0] + end);
        hn::StoreU(hn::Set(d, -1.0F), d, columns_[T1] + end);
        list.size = wholeVectors(list.active);
    }

    /// Copies the rays whose interval [begin, end] is not empty to `top`.
    HWY_INLINE List copy(const List& list, std::uint32_t node, std::size_t active, const float* begin,
                         const float* end, std::size_t& top) {
        const FloatTag d;
        List out{node, top, top, 0, active};
        std::size_t to = top;
        for (std::size_t i = 0; i < list.size; i += kLanes) {
            const Floats t0 = hn::Load(d, begin + i);
            const Floats t1 = hn::Load(d, end + i);
            const Mask which = hn::Le(t0, t1);
            const std::size_t count = hn::CountTrue(d, which);
            if (count == 0) continue;
            const Compaction some(which);
            some.store(get(Slot, list.rays + i), columns_[Slot] + to);
            for (std::size_t c = Origin; c < StreamScratch::kColumns; ++c) {
                some.store(get(c, list.rays + i), columns_[c] + to);
            }
            some.store(t0, columns_[T0] + to);
            some.store(t1, columns_[T1] + to);
            to += count;
        }
        finish(out);
        top += out.size + kLanes;
        return out;
    }

    StreamScratch& scratch_;
    float* columns_[StreamScratch::kColumns];
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif

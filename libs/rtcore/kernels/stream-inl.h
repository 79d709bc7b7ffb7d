// A stream: thousands of rays of any directions walk the tree at once. One depth-first walk carries lists of
// rays, split at each node; short lists go on as packets (docs/lab/kernels.md). Included once for each
// target.
#if defined(RTCORE_KERNELS_STREAM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_STREAM_INL_H_
#undef RTCORE_KERNELS_STREAM_INL_H_
#else
#define RTCORE_KERNELS_STREAM_INL_H_
#endif

#include "rtcore/kernels/packet-inl.h"
#include "rtcore/kernels/ray_box-inl.h"
#include "rtcore/simd/compaction-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The walk of the rays of one octant of directions. While a leaf comes from memory it can halt and let
/// another walk go on.
template <Search kSearch>
class OctantWalk {
  public:
    /// `turn`: which of the scratch's columns it works in.
    OctantWalk(const KernelScene& scene, StreamScratch& scratch, std::size_t turn)
        : scene_(scene), scratch_(scratch), shortWalk_(scene, short_) {
        for (std::size_t i = 0; i < StreamScratch::kColumns; ++i) columns_[i] = scratch.column(turn, i);
    }

    /// Takes over the rays of the scratch's groups that have this octant; none's search needs more `slack`.
    HWY_NOINLINE void begin(const RaySpan& rays, std::uint32_t octant, float slack) {
        slack_ = slack;
        for (int axis = 0; axis < 3; ++axis) {
            culling_.uniform[axis] = true;
            culling_.upperFirst[axis] = octant >> axis & 1U;
        }
        list_ = collect(rays, octant);
        top_ = list_.size + kLanes;
        waiting_ = 0;
        halted_ = false;
    }

    /// Goes on until few rays reach a leaf; false when all is done.
    HWY_NOINLINE bool advance() {
        if (halted_) {
            if (shortWalk_.step(culling_)) return true;
            halted_ = false;
            endShort();
            if (!nextList()) return false;
        }
        while (true) {
            bool more = false;
            if (list_.active > kShort) {
                const KdNode node = scene_.nodes[list_.node];
                if (node.isLeaf()) {
                    if (node.count() != 0) testLeaf({scene_, node}, list_);
                } else {
                    more = split(node, list_, waiting_, top_);
                }
            } else if (list_.active > 0) {
                beginShort(list_);
                halted_ = shortWalk_.begin(list_.node, culling_);
                if (halted_) return true;
                endShort();
            }
            if (!more && !nextList()) return false;
        }
    }

  private:
    enum Column { Slot, T0, T1, Origin, Direction = Origin + 3 };
    /// The rays that enter a node. Their slots, origins and directions lie at [rays, rays + size) of the
    /// columns, their intervals at [intervals, intervals + size). Some of these are empty: a list is only
    /// copied where too few of its rays go on, else the two children share the rays. Vectors are always
    /// whole.
    struct List {
        std::uint32_t node;
        std::size_t rays, intervals, size;
        std::size_t active; ///< rays whose interval is not empty
    };
    struct WaitingList {
        List list;
        std::size_t top;   ///< what lies from here on is free once this list's turn comes
        std::size_t found; ///< of found_, when it was made
    };
    static constexpr std::size_t kShortVectors = 2;
    static constexpr std::size_t kShort = kShortVectors * kLanes;

    static std::size_t wholeVectors(std::size_t rays) { return (rays + kLanes - 1) / kLanes * kLanes; }

    /// Whether so few rays go on that they are worth copying.
    static bool isSparse(std::size_t active, std::size_t size) { return active * 4 < size * 3; }

    /// The list of all rays of one octant, at the root.
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

    /// The next list that waits with a ray still searching; false when there is none.
    HWY_INLINE bool nextList() {
        do {
            if (waiting_ == 0) return false;
            const WaitingList& waiting = stack_[--waiting_];
            list_ = waiting.list;
            top_ = waiting.top;
            if (waiting.found != found_) dropDone(list_);
        } while (list_.active == 0);
        return true;
    }

    HWY_INLINE bool isEmptyLeaf(std::uint32_t node) const {
        return scene_.nodes[node].isLeaf() && scene_.nodes[node].count() == 0;
    }

    /// Leaves in `list` the rays that enter the nearer child that has anything in it, and on the stack those
    /// that enter the other; false when there are none.
    HWY_INLINE bool split(KdNode node, List& list, std::size_t& waiting, std::size_t& top) {
        const std::uint32_t upperFirst = culling_.upperFirst[node.axis()];
        const std::uint32_t near = node.lowerChild() + upperFirst;
        const std::uint32_t far = node.lowerChild() + 1 - upperFirst;
        std::size_t entersNear = 0;
        std::size_t entersFar = 0;
        measure(node, list, entersNear, entersFar);
        const bool goNear = entersNear > 0 && !isEmptyLeaf(near);
        const bool goFar = entersFar > 0 && !isEmptyLeaf(far);
        if (goFar && goNear) {
            const List other = enterFar(list, far, entersFar, top);
            stack_[waiting++] = {other, top, found_};
        } else if (goFar) {
            const bool same = entersNear == 0;
            if (!same) list = enterFar(list, far, entersFar, top);
            list.node = far;
            return true;
        }
        if (!goNear) return false;
        // Those that pass the far child by keep their intervals.
        if (entersFar == 0) {
            list.node = near;
        } else {
            enterNear(list, near, entersNear, top);
        }
        return true;
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

    /// Empties the intervals of the rays whose search has ended before this cell.
    HWY_INLINE void dropDone(List& list) {
        const FloatTag d;
        list.active = 0;
        for (std::size_t i = 0; i < list.size; i += kLanes) {
            const Floats t0 = get(T0, list.intervals + i);
            const Floats t1 = get(T1, list.intervals + i);
            const Floats end = hn::Min(t1, endOf(slotsAt(list, i)));
            hn::Store(end, d, columns_[T1] + list.intervals + i);
            list.active += hn::CountTrue(d, hn::Le(t0, end));
        }
    }

    /// Lanes that are not active may hold no slot at all: they read the first.
    HWY_INLINE Ints slotsAt(const List& list, std::size_t i) const {
        const IntTag di;
        const Mask used = hn::Le(get(T0, list.intervals + i), get(T1, list.intervals + i));
        return hn::IfThenElseZero(hn::RebindMask(di, used), hn::BitCast(di, get(Slot, list.rays + i)));
    }

    HWY_INLINE Floats endOf(Ints slot) const {
        const FloatTag d;
        const Floats best = hn::GatherIndex(d, scratch_.best, slot);
        const Floats end = hn::Add(best, hn::Set(d, slack_));
        if constexpr (!kSearch.any) return end;
        return hn::IfThenElse(hn::Lt(best, hn::Zero(d)), best, end);
    }

    HWY_INLINE void testLeaf(const Leaf& leaf, const List& list) {
        for (std::size_t i = 0; i < list.size; i += kLanes) testLeafVector(leaf, list, i);
    }

    /// The triangles of a leaf against one vector of the list.
    HWY_INLINE void testLeafVector(const Leaf& leaf, const List& list, std::size_t i) {
        const FloatTag d;
        const IntTag di;
        const Mask inCell = hn::Le(get(T0, list.intervals + i), get(T1, list.intervals + i));
        if (hn::AllFalse(d, inCell)) return;
        const Ints slot = slotsAt(list, i);
        const std::size_t at = list.rays + i;
        const Floats dx = get(Direction, at);
        const Floats dy = get(Direction + 1, at);
        const Floats dz = get(Direction + 2, at);
        const AxisOrder order(dx, dy, dz);
        const ShearedRays rays =
            shear(order, get(Origin, at), get(Origin + 1, at), get(Origin + 2, at), dx, dy, dz);
        const Floats tMin = hn::GatherIndex(d, scratch_.tMin, slot);
        Found found{hn::GatherIndex(d, scratch_.best, slot),
                    hn::Zero(di),
                    hn::Zero(d),
                    hn::Zero(d),
                    hn::Zero(d),
                    hn::FirstN(d, 0),
                    hn::FirstN(d, 0),
                    hn::Set(d, slack_ * kTieFraction)};
        if constexpr (!kSearch.any) found.triangle = hn::GatherIndex(di, scratch_.triangle, slot);
        const auto forget = [](const Corners&) HWY_ATTR {}; // a stream has too many occluders
        const int axis = order.common();
        if (axis < 3) {
            testTriangles<kSearch>(scene_, leaf, alongAxis(axis), rays, tMin, inCell, found, forget);
        } else {
            testTriangles<kSearch>(scene_, leaf, AlongEach{order}, rays, tMin, inCell, found, forget);
        }
        if (HWY_UNLIKELY(leaf.common < leaf.count)) {
            testNarrowTriangles<kSearch>(scene_, leaf, AlongEach{order}, rays, tMin, inCell, found);
        }
        if constexpr (kSearch.any) notePassed(slot, found);
        if (!hn::AllFalse(d, found.changed)) keep(slot, found);
    }

    /// As PacketWalk's.
    HWY_INLINE void notePassed(Ints slots, const Found& found) {
        if (HWY_LIKELY(hn::AllFalse(FloatTag(), found.passed))) return;
        alignas(64) std::int32_t slot[kLanes];
        hn::Store(slots, IntTag(), slot);
        forEachLane(found.passed, [&](std::size_t lane) { scratch_.triangle[slot[lane]] = 0; });
    }

    HWY_INLINE void keep(Ints slots, const Found& found) {
        const FloatTag d;
        ++found_;
        const IntTag di;
        alignas(64) std::int32_t slot[kLanes];
        alignas(64) std::int32_t triangles[kLanes];
        alignas(64) float values[4][kLanes];
        hn::Store(slots, di, slot);
        hn::Store(found.triangle, di, triangles);
        hn::Store(found.best, d, values[0]);
        hn::Store(found.v, d, values[1]);
        hn::Store(found.w, d, values[2]);
        hn::Store(found.det, d, values[3]);
        forEachLane(found.changed, [&](std::size_t lane) {
            const std::int32_t at = slot[lane];
            scratch_.best[at] = values[0][lane];
            if constexpr (kSearch.any) return;
            scratch_.triangle[at] = triangles[lane];
            scratch_.v[at] = values[1][lane];
            scratch_.w[at] = values[2][lane];
            scratch_.det[at] = values[3][lane];
        });
    }

    /// A list of at most kShort rays goes on as a packet.
    HWY_INLINE void beginShort(const List& list) {
        const FloatTag d;
        const IntTag di;
        std::size_t to = 0;
        for (std::size_t i = 0; i < list.size; i += kLanes) {
            const Floats t0 = get(T0, list.intervals + i);
            const Floats t1 = get(T1, list.intervals + i);
            const Mask which = hn::Le(t0, t1);
            const std::size_t count = hn::CountTrue(d, which);
            if (count == 0) continue;
            const Compaction some(which);
            some.store(t0, short_.t0 + to);
            some.store(t1, short_.t1 + to);
            some.store(get(Slot, list.rays + i), shortSlot_ + to);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                some.store(get(Origin + axis, list.rays + i), short_.origin[axis] + to);
                some.store(get(Direction + axis, list.rays + i), short_.direction[axis] + to);
            }
            to += count;
        }
        hn::StoreU(hn::Set(d, 1.0F), d, short_.t0 + to);
        hn::StoreU(hn::Set(d, -1.0F), d, short_.t1 + to);
        for (std::size_t i = wholeVectors(to); i < kShort; i += kLanes) {
            hn::Store(hn::Set(d, 1.0F), d, short_.t0 + i);
            hn::Store(hn::Set(d, -1.0F), d, short_.t1 + i);
        }
        for (std::size_t i = 0; i < to; i += kLanes) {
            const Mask used = hn::Le(hn::Load(d, short_.t0 + i), hn::Load(d, short_.t1 + i));
            const Ints slot =
                hn::IfThenElseZero(hn::RebindMask(di, used), hn::BitCast(di, hn::Load(d, shortSlot_ + i)));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                hn::Store(hn::Div(hn::Set(d, 1.0F), hn::Load(d, short_.direction[axis] + i)), d,
                          short_.inverse[axis] + i);
            }
            hn::Store(hn::GatherIndex(d, scratch_.tMin, slot), d, short_.tMin + i);
            hn::Store(hn::GatherIndex(d, scratch_.best, slot), d, short_.best + i);
            hn::Store(hn::GatherIndex(di, scratch_.triangle, slot), di, short_.triangle + i);
        }
        short_.setSlack(slack_);
        shortSize_ = to;
    }

    /// Keeps what the packet has found.
    HWY_INLINE void endShort() {
        for (std::size_t i = 0; i < shortSize_; ++i) {
            const std::int32_t slot = std::bit_cast<std::int32_t>(shortSlot_[i]);
            if constexpr (kSearch.any) {
                found_ += short_.best[i] < 0 ? 1 : 0;
                scratch_.best[slot] = short_.best[i];
                scratch_.triangle[slot] = short_.triangle[i];
            } else if (scratch_.triangle[slot] != short_.triangle[i] ||
                       scratch_.best[slot] != short_.best[i]) { // of ties the last met is kept
                ++found_;
                scratch_.best[slot] = short_.best[i];
                scratch_.triangle[slot] = short_.triangle[i];
                scratch_.v[slot] = short_.v[i];
                scratch_.w[slot] = short_.w[i];
                scratch_.det[slot] = short_.det[i];
            }
        }
    }

    const KernelScene& scene_;
    StreamScratch& scratch_;
    List list_; ///< the one at hand
    std::size_t top_ = 0, waiting_ = 0;
    bool halted_ = false; ///< in the walk of a short list
    float* columns_[StreamScratch::kColumns];
    float slack_ = 0;
    std::size_t found_ = 0; ///< grows with each hit
    Culling culling_{};
    Packet<kShortVectors> short_;
    PacketWalk<kShortVectors, Shared::Nothing, false, kSearch> shortWalk_;
    alignas(64) float shortSlot_[kShort + kLanes]; ///< their bits
    std::size_t shortSize_ = 0;
    WaitingList stack_[kMaxKdDepth];
};

/// The walks of two octants take turns, so that one has something to do while the other waits for memory.
template <Search kSearch>
class StreamWalk {
  public:
    StreamWalk(const KernelScene& scene, StreamScratch& scratch)
        : scene_(scene), scratch_(scratch), walks_{{scene, scratch, 0}, {scene, scratch, 1}} {}

    /// Traces the rays of the scratch's groups.
    HWY_NOINLINE void run(const RaySpan& rays) {
        std::uint32_t octants = start(rays);
        bool busy[kWalks] = {};
        do {
            for (std::size_t i = 0; i < kWalks; ++i) {
                if (!busy[i] && octants != 0) {
                    walks_[i].begin(rays, static_cast<std::uint32_t>(std::countr_zero(octants)), slack_);
                    octants &= octants - 1;
                    busy[i] = true;
                }
                busy[i] = busy[i] && walks_[i].advance();
            }
        } while (busy[0] || busy[1] || octants != 0);
    }

  private:
    static constexpr std::size_t kWalks = StreamScratch::kTurns;
    static constexpr std::int32_t kOutside = 8; ///< octant of rays that miss the box
    using UIntTag = hn::ScalableTag<std::uint32_t>;

    /// Fills the slots; returns which octants there are.
    HWY_INLINE std::uint32_t start(const RaySpan& rays) {
        const FloatTag d;
        const IntTag di;
        std::uint32_t octants = 0;
        slack_ = 0;
        for (std::size_t group = 0; group < scratch_.groupCount; ++group) {
            for (std::size_t lane = 0; lane < StreamScratch::kGroup; lane += kLanes) {
                const std::size_t from = scratch_.groups[group] + lane;
                const std::size_t slot = group * StreamScratch::kGroup + lane;
                const RayVector ray = loadRays(rays, from);
                const Floats slack = slackOf(scene_, ray);
                slack_ = std::max(slack_, hn::GetLane(hn::MaxOfLanes(d, slack)));
                const IntervalVector inside = clipToBox(scene_, ray, inverseOf(ray), slack);
                const auto sign = [&](Floats x) HWY_ATTR {
                    return hn::BitCast(di, hn::ShiftRight<31>(hn::BitCast(UIntTag(), x)));
                };
                const Ints code = hn::Or(
                    sign(ray.dx), hn::Or(hn::ShiftLeft<1>(sign(ray.dy)), hn::ShiftLeft<2>(sign(ray.dz))));
                const Mask enters = hn::Le(inside.t0, inside.t1);
                hn::Store(hn::IfThenElse(hn::RebindMask(di, enters), code, hn::Set(di, kOutside)), di,
                          scratch_.octant + slot);
                octants |= octantsOf(code, enters);
                hn::Store(inside.t0, d, scratch_.rootBegin + slot);
                hn::Store(inside.t1, d, scratch_.rootEnd + slot);
                hn::Store(ray.tMin, d, scratch_.tMin + slot);
                hn::Store(ray.tMax, d, scratch_.best + slot);
                hn::Store(hn::Set(di, kNone), di, scratch_.triangle + slot);
                if constexpr (kSearch.any) continue;
                hn::Store(hn::Zero(d), d, scratch_.v + slot);
                hn::Store(hn::Zero(d), d, scratch_.w + slot);
                hn::Store(hn::Set(d, 1.0F), d, scratch_.det + slot);
            }
        }
        return octants;
    }

    HWY_INLINE static std::uint32_t octantsOf(Ints code, Mask enters) {
        const FloatTag d;
        const IntTag di;
        std::uint32_t octants = 0;
        for (int octant = 0; octant < 8; ++octant) {
            const Mask here = hn::RebindMask(d, hn::Eq(code, hn::Set(di, octant)));
            if (!hn::AllFalse(d, hn::And(here, enters))) octants |= 1U << octant;
        }
        return octants;
    }

    const KernelScene& scene_;
    StreamScratch& scratch_;
    float slack_ = 0;
    OctantWalk<kSearch> walks_[kWalks];
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif

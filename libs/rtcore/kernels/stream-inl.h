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
#include "rtcore/kernels/ray_lists-inl.h"
#include "rtcore/kernels/short_list-inl.h"

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
        : scene_(scene), scratch_(scratch), lists_(scratch, turn), short_(scene, scratch) {}

    /// Takes over the rays of the scratch's groups that have this octant; none's search needs more `slack`.
    HWY_NOINLINE void begin(const RaySpan& rays, std::uint32_t octant, float slack) {
        slack_ = slack;
        for (int axis = 0; axis < 3; ++axis) {
            culling_.uniform[axis] = true;
            culling_.upperFirst[axis] = octant >> axis & 1U;
        }
        list_ = lists_.collect(rays, octant);
        top_ = list_.size + kLanes;
        waiting_ = 0;
        halted_ = false;
    }

    /// Goes on until few rays reach a leaf; false when all is done.
    HWY_NOINLINE bool advance() {
        if (halted_) {
            if (short_.step(culling_)) return true;
            halted_ = false;
            short_.keep(found_);
            if (!nextList()) return false;
        }
        while (true) {
            bool more = false;
            if (list_.active > ShortList<kSearch>::kMax) {
                const KdNode node = scene_.nodes[list_.node];
                if (node.isLeaf()) {
                    if (node.count() != 0) testLeaf({scene_, node}, list_);
                } else {
                    more = split(node, list_, waiting_, top_);
                }
            } else if (list_.active > 0) {
                short_.take(lists_, list_, slack_);
                halted_ = short_.begin(list_.node, culling_);
                if (halted_) return true;
                short_.keep(found_);
            }
            if (!more && !nextList()) return false;
        }
    }

  private:
    using List = RayLists::List;
    struct WaitingList {
        List list;
        std::size_t top;   ///< what lies from here on is free once this list's turn comes
        std::size_t found; ///< of found_, when it was made
    };
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
        lists_.measure(node, list, entersNear, entersFar);
        const bool goNear = entersNear > 0 && !isEmptyLeaf(near);
        const bool goFar = entersFar > 0 && !isEmptyLeaf(far);
        if (goFar && goNear) {
            const List other = lists_.enterFar(list, far, entersFar, top);
            stack_[waiting++] = {other, top, found_};
        } else if (goFar) {
            const bool same = entersNear == 0;
            if (!same) list = lists_.enterFar(list, far, entersFar, top);
            list.node = far;
            return true;
        }
        if (!goNear) return false;
        // Those that pass the far child by keep their intervals.
        if (entersFar == 0) {
            list.node = near;
        } else {
            lists_.enterNear(list, near, entersNear, top);
        }
        return true;
    }

    /// Empties the intervals of the rays whose search has ended before this cell.
    HWY_INLINE void dropDone(List& list) {
        const FloatTag d;
        list.active = 0;
        for (std::size_t i = 0; i < list.size; i += kLanes) {
            const Floats t0 = lists_.begin(list, i);
            const Floats t1 = lists_.end(list, i);
            const Floats end = hn::Min(t1, endOf(lists_.slotsAt(list, i)));
            lists_.setEnd(list, i, end);
            list.active += hn::CountTrue(d, hn::Le(t0, end));
        }
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
        const Mask inCell = lists_.entering(list, i);
        if (hn::AllFalse(d, inCell)) return;
        const Ints slot = lists_.slotsAt(list, i);
        const Floats dx = lists_.direction(list, i, 0);
        const Floats dy = lists_.direction(list, i, 1);
        const Floats dz = lists_.direction(list, i, 2);
        const AxisOrder order(dx, dy, dz);
        const ShearedRays rays = shear(order, lists_.origin(list, i, 0), lists_.origin(list, i, 1),
                                       lists_.origin(list, i, 2), dx, dy, dz);
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

    const KernelScene& scene_;
    StreamScratch& scratch_;
    List list_; ///< the one at hand
    std::size_t top_ = 0, waiting_ = 0;
    bool halted_ = false; ///< in the walk of a short list
    RayLists lists_;
    float slack_ = 0;
    std::size_t found_ = 0; ///< grows with each hit
    Culling culling_{};
    ShortList<kSearch> short_;
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

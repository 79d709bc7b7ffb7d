// A stream: thousands of rays of any directions walk the tree at once. One depth-first walk carries lists of
// rays, split at each node; short lists go on as packets (docs/performance.md). Included once for each target.
#if defined(RTCORE_KERNELS_STREAM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_STREAM_INL_H_
#undef RTCORE_KERNELS_STREAM_INL_H_
#else
#define RTCORE_KERNELS_STREAM_INL_H_
#endif

#include "rtcore/kernels/packet-inl.h"
#include "rtcore/kernels/ray_box-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

template <bool kAny>
class StreamWalk {
  public:
    StreamWalk(const KernelScene& scene, StreamScratch& scratch)
        : scene_(scene), scratch_(scratch), shortWalk_(scene, short_) {
        for (std::size_t i = 0; i < StreamScratch::kColumns; ++i) columns_[i] = scratch.column(i);
    }

    /// Traces the rays of the scratch's groups.
    HWY_NOINLINE void run(const RaySpan& rays) {
        const std::uint32_t octants = start(rays);
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            if ((octants >> octant & 1U) == 0) continue;
            for (int axis = 0; axis < 3; ++axis) {
                culling_.uniform[axis] = true;
                culling_.upperFirst[axis] = octant >> axis & 1U;
            }
            walk(collect(rays, octant));
        }
    }

  private:
    enum Column { Slot, T0, T1, Origin, Direction = Origin + 3 };
    /// Rays of a list lie at [begin, begin + count) of every column, followed by a vector of empty intervals.
    struct List {
        std::uint32_t node;
        std::size_t begin, count;
    };
    struct WaitingList {
        List list;
        std::size_t top; ///< what lies from here on is free once this list's turn comes
    };
    static constexpr std::size_t kShortVectors = 2;
    static constexpr std::size_t kShort = kShortVectors * kLanes;
    static constexpr std::uint32_t kOutside = 8; ///< octant of rays that miss the box

    static std::size_t after(const List& list) {
        return (list.begin + list.count + 2 * kLanes - 1) / kLanes * kLanes;
    }

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
                const IntervalVector inside = clipToBox(scene_, ray, slack);
                const auto sign = [&](Floats x) HWY_ATTR {
                    return hn::BitCast(di, hn::ShiftRight<31>(hn::BitCast(UIntTag(), x)));
                };
                const Ints code = hn::Or(sign(ray.dx), hn::Or(hn::ShiftLeft<1>(sign(ray.dy)),
                                                              hn::ShiftLeft<2>(sign(ray.dz))));
                const Lanes enters = hn::Le(inside.t0, inside.t1);
                hn::Store(hn::IfThenElse(hn::RebindMask(di, enters), code, hn::Set(di, kOutside)), di,
                          scratch_.octant + slot);
                octants |= octantsOf(code, enters);
                hn::Store(inside.t0, d, scratch_.rootBegin + slot);
                hn::Store(inside.t1, d, scratch_.rootEnd + slot);
                hn::Store(hn::LoadU(d, rays.tMin + from), d, scratch_.tMin + slot);
                hn::Store(hn::LoadU(d, rays.tMax + from), d, scratch_.best + slot);
                if constexpr (kAny) continue;
                hn::Store(hn::Set(di, kNone), di, scratch_.triangle + slot);
                hn::Store(hn::Zero(d), d, scratch_.v + slot);
                hn::Store(hn::Zero(d), d, scratch_.w + slot);
                hn::Store(hn::Set(d, 1.0F), d, scratch_.det + slot);
            }
        }
        return octants;
    }

    HWY_INLINE static std::uint32_t octantsOf(Ints code, Lanes enters) {
        const FloatTag d;
        const IntTag di;
        std::uint32_t octants = 0;
        for (int octant = 0; octant < 8; ++octant) {
            const Lanes here = hn::RebindMask(d, hn::Eq(code, hn::Set(di, octant)));
            if (!hn::AllFalse(d, hn::And(here, enters))) octants |= 1U << octant;
        }
        return octants;
    }

    /// The list of all rays of one octant, at the root.
    HWY_INLINE List collect(const RaySpan& rays, std::uint32_t octant) {
        const FloatTag d;
        const IntTag di;
        List list{0, 0, 0};
        for (std::size_t group = 0; group < scratch_.groupCount; ++group) {
            for (std::size_t lane = 0; lane < StreamScratch::kGroup; lane += kLanes) {
                const std::size_t from = scratch_.groups[group] + lane;
                const std::size_t slot = group * StreamScratch::kGroup + lane;
                const Lanes here = hn::RebindMask(
                    d, hn::Eq(hn::Load(di, scratch_.octant + slot), hn::Set(di, static_cast<std::int32_t>(octant))));
                if (hn::AllFalse(d, here)) continue;
                const RayVector ray = loadRays(rays, from);
                const Ints slots = hn::Iota(di, static_cast<std::int32_t>(slot));
                put(Slot, list.count, hn::BitCast(d, slots), here);
                put(T0, list.count, hn::Load(d, scratch_.rootBegin + slot), here);
                put(T1, list.count, hn::Load(d, scratch_.rootEnd + slot), here);
                put(Origin, list.count, ray.ox, here);
                put(Origin + 1, list.count, ray.oy, here);
                put(Origin + 2, list.count, ray.oz, here);
                put(Direction, list.count, ray.dx, here);
                put(Direction + 1, list.count, ray.dy, here);
                put(Direction + 2, list.count, ray.dz, here);
                list.count += hn::CountTrue(d, here);
            }
        }
        close(list);
        return list;
    }

    /// Writes the lanes in `which` side by side.
    HWY_INLINE void put(std::size_t column, std::size_t at, Floats values, Lanes which) {
        const FloatTag d;
        hn::StoreU(hn::Compress(values, which), d, columns_[column] + at);
    }

    HWY_INLINE Floats get(std::size_t column, std::size_t at) const {
        return hn::LoadU(FloatTag(), columns_[column] + at);
    }

    /// Empty intervals behind the last ray: the vector that it lies in has no others.
    HWY_INLINE void close(const List& list) {
        const FloatTag d;
        const std::size_t end = list.begin + list.count;
        hn::StoreU(hn::Set(d, 1.0F), d, columns_[T0] + end);
        hn::StoreU(hn::Set(d, -1.0F), d, columns_[T1] + end);
    }

    HWY_INLINE void walk(List list) {
        std::size_t waiting = 0;
        std::size_t top = after(list);
        while (true) {
            bool more = false;
            if (list.count > kShort) {
                const KdNode node = scene_.nodes[list.node];
                if (node.isLeaf()) {
                    if (node.count() != 0) testLeaf({node.firstReference, node.count()}, list);
                } else {
                    more = split(node, list, waiting, top);
                }
            } else if (list.count > 0) {
                walkShort(list);
            }
            while (!more) {
                if (waiting == 0) return;
                list = stack_[--waiting].list;
                top = stack_[waiting].top;
                dropDone(list);
                more = list.count > 0;
            }
        }
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
        const std::size_t all = list.count;
        const bool goNear = entersNear > 0 && !isEmptyLeaf(near);
        const bool goFar = entersFar > 0 && !isEmptyLeaf(far);
        if (!goNear && !goFar) return false;
        if (goNear && !goFar) {
            if (entersFar > 0 || entersNear < all) keepNear(list, entersNear);
            list.node = near;
            return true;
        }
        if (goFar && !goNear) {
            if (entersNear > 0 || entersFar < all) keepFar(list, entersFar);
            list.node = far;
            return true;
        }
        if (entersFar == all && entersNear < all) {
            const List kept{near, top, entersNear};
            copyNear(list, kept);
            keepFar(list, entersFar);
            stack_[waiting++] = {{far, list.begin, list.count}, top};
            list = kept;
            top = after(list);
        } else {
            const List other{far, top, entersFar};
            copyFar(list, other);
            keepNear(list, entersNear);
            list.node = near;
            top = after(other);
            stack_[waiting++] = {other, top};
        }
        return true;
    }

    /// Where each ray of the list leaves the near child and enters the far one, and how many do.
    HWY_INLINE void measure(KdNode node, const List& list, std::size_t& entersNear, std::size_t& entersFar) {
        const FloatTag d;
        const Floats plane = hn::Set(d, node.split);
        const float* const origin = columns_[Origin + node.axis()] + list.begin;
        const float* const direction = columns_[Direction + node.axis()] + list.begin;
        const float* const begin = columns_[T0] + list.begin;
        const float* const end = columns_[T1] + list.begin;
        const Floats one = hn::Set(d, 1.0F);
        for (std::size_t i = 0; i < list.count; i += kLanes) {
            const Floats inverse = hn::Div(one, hn::LoadU(d, direction + i));
            const Floats t = hn::Mul(hn::Sub(plane, hn::LoadU(d, origin + i)), inverse);
            const Floats t0 = hn::LoadU(d, begin + i);
            const Floats t1 = hn::LoadU(d, end + i);
            const Floats nearEnd = smaller(hn::Mul(t, hn::Set(d, kPlaneUp)), t1);
            const Floats farBegin = larger(hn::Mul(t, hn::Set(d, kPlaneDown)), t0);
            hn::Store(nearEnd, d, scratch_.nearEnd + i);
            hn::Store(farBegin, d, scratch_.farBegin + i);
            entersNear += hn::CountTrue(d, hn::Le(t0, nearEnd));
            entersFar += hn::CountTrue(d, hn::Le(farBegin, t1));
        }
    }

    /// Keeps the `count` rays that enter the near child, with the intervals they have there.
    HWY_INLINE void keepNear(List& list, std::size_t count) {
        if (count < list.count) {
            List kept{list.node, list.begin, count};
            copyNear(list, kept);
            list = kept;
            return;
        }
        const FloatTag d;
        for (std::size_t i = 0; i < list.count; i += kLanes) {
            hn::StoreU(hn::Load(d, scratch_.nearEnd + i), d, columns_[T1] + list.begin + i);
        }
        close(list);
    }

    HWY_INLINE void keepFar(List& list, std::size_t count) {
        if (count < list.count) {
            List kept{list.node, list.begin, count};
            copyFar(list, kept);
            list = kept;
            return;
        }
        const FloatTag d;
        for (std::size_t i = 0; i < list.count; i += kLanes) {
            hn::StoreU(hn::Load(d, scratch_.farBegin + i), d, columns_[T0] + list.begin + i);
        }
        close(list);
    }

    /// Copies the rays that enter the near child into `to`, which may begin where `from` does.
    HWY_INLINE void copyNear(const List& from, const List& to) {
        const FloatTag d;
        std::size_t out = to.begin;
        for (std::size_t i = 0; i < from.count; i += kLanes) {
            const std::size_t in = from.begin + i;
            const Floats end = hn::Load(d, scratch_.nearEnd + i);
            const Floats begin = get(T0, in);
            const Lanes which = hn::Le(begin, end);
            copyRays(in, out, which);
            put(T0, out, begin, which);
            put(T1, out, end, which);
            out += hn::CountTrue(d, which);
        }
        close(to);
    }

    HWY_INLINE void copyFar(const List& from, const List& to) {
        const FloatTag d;
        std::size_t out = to.begin;
        for (std::size_t i = 0; i < from.count; i += kLanes) {
            const std::size_t in = from.begin + i;
            const Floats begin = hn::Load(d, scratch_.farBegin + i);
            const Floats end = get(T1, in);
            const Lanes which = hn::Le(begin, end);
            copyRays(in, out, which);
            put(T0, out, begin, which);
            put(T1, out, end, which);
            out += hn::CountTrue(d, which);
        }
        close(to);
    }

    /// All columns but the intervals.
    HWY_INLINE void copyRays(std::size_t in, std::size_t out, Lanes which) {
        put(Slot, out, get(Slot, in), which);
        for (std::size_t c = Origin; c < StreamScratch::kColumns; ++c) put(c, out, get(c, in), which);
    }

    /// Drops the rays whose search has ended before this cell.
    HWY_INLINE void dropDone(List& list) {
        const FloatTag d;
        std::size_t open = 0;
        for (std::size_t i = 0; i < list.count; i += kLanes) {
            const std::size_t at = list.begin + i;
            const Floats end = hn::Min(get(T1, at), endOf(slotsAt(at)));
            hn::Store(end, d, scratch_.nearEnd + i);
            open += hn::CountTrue(d, hn::Le(get(T0, at), end));
        }
        keepNear(list, open);
    }

    /// The lanes behind a list's end have any slot: they read the first.
    HWY_INLINE Ints slotsAt(std::size_t at) const {
        const FloatTag d;
        const IntTag di;
        const Lanes used = hn::Le(get(T0, at), get(T1, at));
        return hn::IfThenElseZero(hn::RebindMask(di, used), hn::BitCast(di, get(Slot, at)));
    }

    HWY_INLINE Floats endOf(Ints slot) const {
        const FloatTag d;
        const Floats best = hn::GatherIndex(d, scratch_.best, slot);
        const Floats end = hn::Add(best, hn::Set(d, slack_));
        if constexpr (!kAny) return end;
        return hn::IfThenElse(hn::Lt(best, hn::Zero(d)), best, end);
    }

    HWY_INLINE void testLeaf(const Leaf& leaf, const List& list) {
        for (std::size_t i = 0; i < list.count; i += kLanes) testLeafVector(leaf, list.begin + i);
    }

    /// The triangles of a leaf against one vector of the list.
    HWY_INLINE void testLeafVector(const Leaf& leaf, std::size_t at) {
        const FloatTag d;
        const IntTag di;
        const Ints slot = slotsAt(at);
        const Lanes inCell = hn::Le(get(T0, at), get(T1, at));
        const Floats dx = get(Direction, at);
        const Floats dy = get(Direction + 1, at);
        const Floats dz = get(Direction + 2, at);
        const AxisOrder order(dx, dy, dz);
        const ShearedRays rays =
            shear(order, get(Origin, at), get(Origin + 1, at), get(Origin + 2, at), dx, dy, dz);
        const Floats tMin = hn::GatherIndex(d, scratch_.tMin, slot);
        Found found{hn::GatherIndex(d, scratch_.best, slot), hn::Zero(di), hn::Zero(d), hn::Zero(d),
                    hn::Zero(d), hn::FirstN(d, 0)};
        if constexpr (!kAny) found.triangle = hn::GatherIndex(di, scratch_.triangle, slot);
        testTriangles<kAny>(scene_, leaf, AlongEach{order}, rays, tMin, inCell, found, occluder_);
        if (!hn::AllFalse(d, found.changed)) keep(slot, found);
    }

    HWY_INLINE void keep(Ints slots, const Found& found) {
        const FloatTag d;
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
            if constexpr (kAny) return;
            scratch_.triangle[at] = triangles[lane];
            scratch_.v[at] = values[1][lane];
            scratch_.w[at] = values[2][lane];
            scratch_.det[at] = values[3][lane];
        });
    }

    /// A list of at most kShort rays goes on as a packet.
    HWY_INLINE void walkShort(const List& list) {
        const FloatTag d;
        const IntTag di;
        for (std::size_t i = 0; i < kShort; i += kLanes) {
            const std::size_t at = list.begin + i;
            // The second vector may lie wholly behind the list, where nothing is written.
            const bool used = i < list.count;
            const Ints slot = used ? slotsAt(at) : hn::Zero(di);
            hn::Store(used ? get(T0, at) : hn::Set(d, 1.0F), d, short_.t0 + i);
            hn::Store(used ? get(T1, at) : hn::Set(d, -1.0F), d, short_.t1 + i);
            const std::size_t from = used ? at : list.begin;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Floats direction = get(Direction + axis, from);
                hn::Store(get(Origin + axis, from), d, short_.origin[axis] + i);
                hn::Store(direction, d, short_.direction[axis] + i);
                hn::Store(hn::Div(hn::Set(d, 1.0F), direction), d, short_.inverse[axis] + i);
            }
            hn::Store(hn::GatherIndex(d, scratch_.tMin, slot), d, short_.tMin + i);
            hn::Store(hn::GatherIndex(d, scratch_.best, slot), d, short_.best + i);
            hn::Store(slot, di, shortSlot_ + i);
            if constexpr (kAny) continue;
            hn::Store(hn::GatherIndex(di, scratch_.triangle, slot), di, short_.triangle + i);
        }
        short_.slack = slack_;
        shortWalk_.run(list.node, culling_);
        for (std::size_t i = 0; i < list.count; ++i) {
            const std::int32_t slot = shortSlot_[i];
            if constexpr (kAny) {
                scratch_.best[slot] = short_.best[i];
            } else if (scratch_.triangle[slot] != short_.triangle[i]) {
                scratch_.best[slot] = short_.best[i];
                scratch_.triangle[slot] = short_.triangle[i];
                scratch_.v[slot] = short_.v[i];
                scratch_.w[slot] = short_.w[i];
                scratch_.det[slot] = short_.det[i];
            }
        }
    }

    using UIntTag = hn::ScalableTag<std::uint32_t>;

    const KernelScene& scene_;
    StreamScratch& scratch_;
    float* columns_[StreamScratch::kColumns];
    float slack_ = 0;
    Culling culling_{};
    Corners occluder_; ///< not used: streams have too many
    Packet<kShortVectors> short_;
    PacketWalk<kShortVectors, Shared::Nothing, false, kAny> shortWalk_;
    alignas(64) std::int32_t shortSlot_[kShort];
    WaitingList stack_[kMaxKdDepth];
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif

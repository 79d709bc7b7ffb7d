// The rays of a stream that are left in a small part of the tree: they go on as a packet. Included once for
// each target.
#if defined(RTCORE_KERNELS_SHORT_LIST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTCORE_KERNELS_SHORT_LIST_INL_H_
#undef RTCORE_KERNELS_SHORT_LIST_INL_H_
#else
#define RTCORE_KERNELS_SHORT_LIST_INL_H_
#endif

#include "rtcore/kernels/packet-inl.h"
#include "rtcore/kernels/ray_lists-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// The walk of a short list.
template <Search kSearch>
class ShortList {
    static constexpr std::size_t kVectors = 2;

  public:
    static constexpr std::size_t kMax = kVectors * kLanes; ///< rays

    ShortList(const KernelScene& scene, StreamScratch& scratch) : scratch_(scratch), walk_(scene, packet_) {}

    /// Takes over the rays of a list of at most kMax.
    HWY_INLINE void take(const RayLists& lists, const RayLists::List& list, float slack) {
        const FloatTag d;
        const IntTag di;
        std::size_t to = 0;
        for (std::size_t i = 0; i < list.size; i += kLanes) {
            const Floats t0 = lists.begin(list, i);
            const Floats t1 = lists.end(list, i);
            const Mask which = hn::Le(t0, t1);
            const std::size_t count = hn::CountTrue(d, which);
            if (count == 0) continue;
            const Compaction some(which);
            some.store(t0, packet_.t0 + to);
            some.store(t1, packet_.t1 + to);
            some.store(lists.slotBits(list, i), slot_ + to);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                some.store(lists.origin(list, i, axis), packet_.origin[axis] + to);
                some.store(lists.direction(list, i, axis), packet_.direction[axis] + to);
            }
            to += count;
        }
        hn::StoreU(hn::Set(d, 1.0F), d, packet_.t0 + to);
        hn::StoreU(hn::Set(d, -1.0F), d, packet_.t1 + to);
        for (std::size_t i = RayLists::wholeVectors(to); i < kMax; i += kLanes) {
            hn::Store(hn::Set(d, 1.0F), d, packet_.t0 + i);
            hn::Store(hn::Set(d, -1.0F), d, packet_.t1 + i);
        }
        for (std::size_t i = 0; i < to; i += kLanes) {
            const Mask used = hn::Le(hn::Load(d, packet_.t0 + i), hn::Load(d, packet_.t1 + i));
            const Ints slot =
                hn::IfThenElseZero(hn::RebindMask(di, used), hn::BitCast(di, hn::Load(d, slot_ + i)));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                hn::Store(hn::Div(hn::Set(d, 1.0F), hn::Load(d, packet_.direction[axis] + i)), d,
                          packet_.inverse[axis] + i);
            }
            hn::Store(hn::GatherIndex(d, scratch_.tMin, slot), d, packet_.tMin + i);
            hn::Store(hn::GatherIndex(d, scratch_.best, slot), d, packet_.best + i);
            hn::Store(hn::GatherIndex(di, scratch_.triangle, slot), di, packet_.triangle + i);
        }
        packet_.setSlack(slack);
        size_ = to;
    }

    /// Walks below `node`; true while a leaf comes from memory: then step() goes on.
    HWY_INLINE bool begin(std::uint32_t node, const Culling& culling) { return walk_.begin(node, culling); }
    HWY_INLINE bool step(const Culling& culling) { return walk_.step(culling); }

    /// Hands over what the packet has found; `found` grows by at least one where there is anything.
    HWY_INLINE void keep(std::size_t& found) {
        for (std::size_t i = 0; i < size_; ++i) {
            const std::int32_t slot = std::bit_cast<std::int32_t>(slot_[i]);
            if constexpr (kSearch.any) {
                found += packet_.best[i] < 0 ? 1 : 0;
                scratch_.best[slot] = packet_.best[i];
                scratch_.triangle[slot] = packet_.triangle[i];
            } else if (scratch_.triangle[slot] != packet_.triangle[i] ||
                       scratch_.best[slot] != packet_.best[i]) { // of ties the last met is kept
                ++found;
                scratch_.best[slot] = packet_.best[i];
                scratch_.triangle[slot] = packet_.triangle[i];
                scratch_.v[slot] = packet_.v[i];
                scratch_.w[slot] = packet_.w[i];
                scratch_.det[slot] = packet_.det[i];
            }
        }
    }

  private:
    StreamScratch& scratch_;
    Packet<kVectors> packet_;
    PacketWalk<kVectors, Shared::Nothing, false, kSearch> walk_;
    alignas(64) float slot_[kMax + kLanes]; ///< their bits
    std::size_t size_ = 0;
};

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#endif

#include "ipc/channel/frame_ring.h"

#include "ipc/channel/shared_copy.h"
#include "ipc/platform/fault_point.h"
#include "ipc/platform/rules.h"

namespace ipc {

namespace {

constexpr std::size_t kPage = 4096;
constexpr std::size_t wholePages(std::size_t bytes) { return (bytes + kPage - 1) / kPage * kPage; }

constexpr std::uint64_t writing(std::uint64_t number) { return 2 * number + 1; }
constexpr std::uint64_t whole(std::uint64_t number) { return 2 * number + 2; }

} // namespace

std::size_t pixelBytes(const FrameInfo& info) {
    const bool known = info.format == PixelFormat::Rgba8 || info.format == PixelFormat::Rgb8Error8;
    const bool possible = known && info.width >= 1 && info.width <= kMaxFrameSide && info.height >= 1 &&
                          info.height <= kMaxFrameSide;
    return possible ? std::size_t{4} * info.width * info.height : 0;
}

std::size_t frameSegmentBytes(std::size_t frameBytes, std::uint32_t slotCount) {
    return kPixelsOffset + slotCount * wholePages(frameBytes);
}

FrameRingWriter::FrameRingWriter(void* memory, std::size_t frameBytes, std::uint32_t slotCount,
                                 std::uint64_t epoch, std::uint64_t generation, std::uint64_t firstNumber)
    : segment_(static_cast<FrameSegment*>(memory)), capacity_(frameBytes), slotBytes_(wholePages(frameBytes)),
      slots_(slotCount), epoch_(epoch), generation_(generation), next_(firstNumber) {
    segment_->epoch = epoch;
    segment_->generation = generation;
    segment_->slotBytes = slotBytes_;
    segment_->slotCount = slotCount;
    faultPoint("frames laid out");
    segment_->magic.store(kFramesMagic, std::memory_order_release);
}

void FrameRingWriter::repair() {
    keep(segment_->epoch, epoch_);
    keep(segment_->generation, generation_);
    keep(segment_->slotBytes, std::uint64_t{slotBytes_});
    keep(segment_->slotCount, slots_);
    keep(segment_->magic, kFramesMagic);
    if (last_.number != 0) {
        keep(slot(last_.number).info, last_);
        keep(slot(last_.number).sequence, whole(last_.number));
    }
    keep(segment_->latest, last_.number);
}

std::span<std::byte> FrameRingWriter::begin() {
    if (keeps("a slot is marked while it is written"))
        slot(next_).sequence.store(writing(next_), std::memory_order_relaxed);
    if (!keeps("a frame is announced when it is whole")) segment_->latest.store(next_);
    fenceBeforeWriting();
    const std::size_t offset = kPixelsOffset + next_ % slots_ * slotBytes_;
    return {reinterpret_cast<std::byte*>(segment_) + offset, capacity_};
}

void FrameRingWriter::publish(FrameInfo info) {
    info.number = next_;
    copyToShared(&slot(next_).info, &info, sizeof(info));
    faultPoint("frame drawn");
    slot(next_).sequence.store(whole(next_), std::memory_order_release);
    faultPoint("frame whole");
    segment_->latest.store(next_, std::memory_order_release);
    last_ = info;
    ++next_;
}

FrameRingReader::FrameRingReader(const void* memory, std::size_t bytes, Copy copy)
    : segment_(static_cast<const FrameSegment*>(memory)), bytes_(bytes),
      copy_(copy ? std::move(copy) : Copy(copyFromShared)) {}

bool FrameRingReader::ready(std::uint64_t epoch, std::uint64_t generation) const {
    if (bytes_ < kPixelsOffset || segment_->magic.load(std::memory_order_acquire) != kFramesMagic)
        return false;
    return segment_->epoch == epoch && segment_->generation == generation;
}

FrameRead FrameRingReader::read(FrameInfo& info, std::vector<std::byte>& pixels) const {
    FrameRead result = FrameRead::Old;
    for (int tries = 0; tries < 8; ++tries) {
        const std::uint64_t latest = segment_->latest.load(std::memory_order_acquire);
        if (latest == 0 || latest == info.number) return FrameRead::Old;
        result = tryRead(latest, info, pixels);
        if (result == FrameRead::New) return result;
    }
    return result;
}

FrameRead FrameRingReader::tryRead(std::uint64_t number, FrameInfo& info,
                                   std::vector<std::byte>& pixels) const {
    const std::uint32_t slotCount = segment_->slotCount.load(std::memory_order_relaxed);
    const std::uint64_t slotBytes = segment_->slotBytes.load(std::memory_order_relaxed);
    if (slotCount < kMinFrameSlots || slotCount > kMaxFrameSlots ||
        slotBytes > (bytes_ - kPixelsOffset) / slotCount) {
        return FrameRead::Broken;
    }
    const FrameSlot& slot = segment_->slot[number % slotCount];
    if (slot.sequence.load(std::memory_order_acquire) != whole(number)) return FrameRead::Missed;
    FrameInfo copy;
    copyFromShared(&copy, &slot.info, sizeof(copy));
    const std::size_t size = pixelBytes(copy);
    if (size == 0 || size > slotBytes || copy.number != number) return FrameRead::Broken;
    pixels.resize(size);
    const auto* base = reinterpret_cast<const std::byte*>(segment_);
    copy_(pixels.data(), base + kPixelsOffset + number % slotCount * slotBytes, size);
    fenceAfterReading();
    const bool torn = slot.sequence.load(std::memory_order_relaxed) != whole(number);
    if (torn && keeps("frames are checked after they were copied")) return FrameRead::Missed;
    info = copy;
    return FrameRead::New;
}

} // namespace ipc

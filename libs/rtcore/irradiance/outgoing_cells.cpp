#include "rtcore/irradiance/outgoing_cells.h"

#include "rtcore/irradiance/hashed_cell.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr std::size_t kMinSlots = 4096;
constexpr float kOfLength = 1.0F / 8; ///< side of the cells that a ray reads
constexpr std::uint32_t kEnough = 8;  ///< samples of a cell
/// Finer cells straddle fewer walls and edges of shadows: they are read once they know so much, and where
/// samples of the coarser one differ as those of lit and dark surfaces do, once they know something.
constexpr int kFiner = 2; ///< levels
constexpr std::uint32_t kEnoughOfFiner = 32, kSomeOfFiner = 6;
constexpr float kDiffer = 1.8F; ///< mean square over square mean
/// A cell with so many counts before coarser ones with enough, where its side is at most half of the ray:
/// those may lie in another room.
constexpr std::uint32_t kSome = 4;
constexpr float kMaxSideOfSome = 0.5F;

/// 0 to 5: the axis and sign that a normal is nearest to.
std::uint64_t sideOf(Vec3 normal) {
    const float x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
    const int axis = x >= y && x >= z ? 0 : (y >= z ? 1 : 2);
    return static_cast<std::uint64_t>(2 * axis + (normal[axis] < 0 ? 1 : 0));
}

} // namespace

void OutgoingCells::clear(const Box3& bounds) {
    const float diagonal = bounds.diagonal();
    origin_ = diagonal > 0 ? bounds.lo : Vec3{};
    finest_ = diagonal > 0 ? diagonal / 1024 : 1;
    clearCells();
}

void OutgoingCells::clearCells() {
    slots_.assign(kMinSlots, {});
    used_ = 0;
}

int OutgoingCells::levelOf(float length) const {
    const float wanted = length * kOfLength;
    int level = 0;
    while (level < kLevels - 1 && finest_ * static_cast<float>(2 << level) <= wanted) ++level;
    return level;
}

/// Of all that a cell is told apart by: there are so many keys that none is met twice.
std::uint64_t OutgoingCells::keyOf(int level, const Site& site) const {
    const float side = finest_ * static_cast<float>(1 << level);
    const Vec3 at = (site.point - origin_) / side;
    const auto bits = [](float x) {
        return std::uint64_t{static_cast<std::uint32_t>(cellCoordinate(x)) & 0x3FFFFU};
    };
    const std::uint64_t cell = sideOf(site.normal) << 58 | static_cast<std::uint64_t>(level) << 54 |
                               bits(at.z) << 36 | bits(at.y) << 18 | bits(at.x);
    return hashOfCell(cell + hashOfCell(site.surface)) | 1U;
}

const OutgoingCells::Slot* OutgoingCells::find(int level, const Site& site) const {
    const std::uint64_t key = keyOf(level, site);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = key >> 1 & mask; slots_[i].key != 0; i = (i + 1) & mask)
        if (slots_[i].key == key) return &slots_[i];
    return nullptr;
}

void OutgoingCells::add(const Site& site, Colour radiance, std::uint32_t frame) {
    for (int level = std::max(site.level - kFiner, 0); level < kLevels; ++level) {
        if (2 * (used_ + 1) > slots_.size()) rehash(2 * slots_.size(), 0);
        const std::uint64_t key = keyOf(level, site);
        Slot& slot = slotFor(key);
        if (slot.key == 0) ++used_;
        slot.key = key;
        slot.sum += radiance;
        slot.squares += luminance(radiance) * luminance(radiance);
        ++slot.count;
        slot.frame = frame;
    }
}

/// That of the key, or the free one that it would get.
OutgoingCells::Slot& OutgoingCells::slotFor(std::uint64_t key) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = key >> 1 & mask;
    while (slots_[i].key != 0 && slots_[i].key != key) i = (i + 1) & mask;
    return slots_[i];
}

void OutgoingCells::bound(std::size_t max) {
    if (used_ <= max) return;
    std::vector<std::uint32_t> frames;
    for (const Slot& slot : slots_)
        if (slot.key != 0) frames.push_back(slot.frame);
    const auto middle = frames.begin() + static_cast<std::ptrdiff_t>(frames.size() / 2);
    std::ranges::nth_element(frames, middle);
    const std::uint32_t from = *middle;
    // All of one frame: there is nothing older.
    rehash(slots_.size(), from == *std::ranges::max_element(frames) ? from : from + 1);
    if (used_ > max) clearCells();
}

/// Moves the cells whose last sample is from that frame on to so many slots.
void OutgoingCells::rehash(std::size_t slots, std::uint32_t fromFrame) {
    std::vector<Slot> old(slots);
    old.swap(slots_);
    used_ = 0;
    for (const Slot& slot : old) {
        if (slot.key == 0 || slot.frame < fromFrame) continue;
        slotFor(slot.key) = slot;
        ++used_;
    }
}

bool OutgoingCells::samplesDiffer(const Slot& slot) {
    const float sum = luminance(slot.sum);
    return slot.squares * static_cast<float>(slot.count) > kDiffer * sum * sum;
}

std::uint32_t OutgoingCells::samples(const Site& site) const {
    if (empty()) return 0;
    const Slot* const found = find(site.level, site);
    return found != nullptr ? found->count : 0;
}

std::optional<Colour> OutgoingCells::radiance(const Site& site) const {
    if (empty()) return std::nullopt;
    const auto meanOf = [](const Slot& slot) { return slot.sum / static_cast<float>(slot.count); };
    const Slot* const own = find(site.level, site);
    if (own != nullptr && own->count >= kEnough) {
        const std::uint32_t enough = samplesDiffer(*own) ? kSomeOfFiner : kEnoughOfFiner;
        for (int level = std::max(site.level - kFiner, 0); level < site.level; ++level) {
            const Slot* const finer = find(level, site);
            if (finer != nullptr && finer->count >= enough) return meanOf(*finer);
        }
        return meanOf(*own);
    }
    const Slot* best = own;
    for (int level = site.level + 1; level < kLevels; ++level) {
        const float side = finest_ * static_cast<float>(1 << level);
        if (best != nullptr && best->count >= kSome && side > kMaxSideOfSome * site.length) break;
        const Slot* const found = find(level, site);
        if (found == nullptr) continue;
        best = found; // coarser cells know as much at least
        if (found->count >= kEnough) break;
    }
    if (best == nullptr) return std::nullopt;
    return meanOf(*best);
}

} // namespace rtcore

#include "rtcore/irradiance/outgoing_cells.h"

#include "rtcore/irradiance/hashed_cell.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <utility>

namespace rtcore {

namespace {

constexpr std::size_t kMinSlots = 4096;
constexpr std::size_t kSitesAtOnce = 64; ///< memory is fetched for all of them first
constexpr float kOfLength = 1.0F / 8;    ///< side of the cells that a ray reads
constexpr std::uint32_t kEnough = 8;     ///< samples of a cell
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

std::vector<OutgoingCells::Cell> OutgoingCells::state() const {
    std::vector<Cell> cells;
    cells.reserve(used_);
    std::ranges::copy_if(slots_, std::back_inserter(cells), [](const Slot& slot) { return slot.key != 0; });
    std::ranges::sort(cells, {}, &Cell::key);
    return cells;
}

void OutgoingCells::restore(const Box3& bounds, std::span<const Cell> cells) {
    clear(bounds);
    rehash(std::max(kMinSlots, std::bit_ceil(2 * cells.size())), 0);
    for (const Cell& cell : cells) slotFor(cell.key) = cell;
    used_ = cells.size();
}

bool OutgoingCells::areKeys(std::span<const Cell> cells) {
    std::vector<std::uint64_t> hashes;
    hashes.reserve(cells.size());
    for (const Cell& cell : cells) {
        const std::uint64_t hash = cell.key >> 1;
        if ((cell.key & 1U) == 0 || (!hashes.empty() && hash <= hashes.back())) return false;
        hashes.push_back(hash);
    }
    return areSpread(hashes);
}

int OutgoingCells::levelOf(float length) const { return levelOfSide(length * kOfLength); }

int OutgoingCells::levelOfSide(float side) const {
    int level = 0;
    while (level < kLevels - 1 && finest_ * static_cast<float>(2 << level) <= side) ++level;
    return level;
}

OutgoingCells::Place OutgoingCells::placeOf(const Site& site) const {
    const Vec3 at = (site.point - origin_) / finest_;
    return {cellCoordinate(at.x), cellCoordinate(at.y), cellCoordinate(at.z),
            (sideOf(site.normal) << 58) + hashOfCell(site.surface)};
}

/// Of all that a cell is told apart by: there are so many keys that none is met twice.
std::uint64_t OutgoingCells::Place::keyOf(int level) const {
    const auto bits = [&](std::int32_t at) {
        return std::uint64_t{static_cast<std::uint32_t>(at >> level) & 0x3FFFFU};
    };
    const std::uint64_t cell =
        static_cast<std::uint64_t>(level) << 54 | bits(z) << 36 | bits(y) << 18 | bits(x);
    return hashOfCell(cell + kind) | 1U;
}

const OutgoingCells::Slot* OutgoingCells::find(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = key >> 1 & mask; slots_[i].key != 0; i = (i + 1) & mask)
        if (slots_[i].key == key) return &slots_[i];
    return nullptr;
}

void OutgoingCells::prefetch(std::uint64_t key) const {
    hwy::Prefetch(&slots_[key >> 1 & (slots_.size() - 1)]);
}

void OutgoingCells::prefetch(const Site& site) const {
    const Place place = placeOf(site);
    for (int level = std::max(site.level - kFiner, 0); level < kLevels; ++level) prefetch(place.keyOf(level));
}

void OutgoingCells::add(const Site& site, Colour radiance, std::uint32_t frame) {
    const Place place = placeOf(site);
    for (int level = std::max(site.level - kFiner, 0); level < kLevels; ++level) {
        if (2 * (used_ + 1) > slots_.size()) rehash(2 * slots_.size(), 0);
        const std::uint64_t key = place.keyOf(level);
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

const OutgoingCells::Cell* OutgoingCells::cellOf(const Site& site, std::uint32_t minSamples) const {
    if (site.level == kNowhere) return nullptr;
    const Place place = placeOf(site);
    const Slot* best = nullptr;
    for (int level = site.level; level < kLevels; ++level) {
        const Slot* const found = find(place.keyOf(level));
        if (found == nullptr) continue;
        best = found; // coarser cells know as much at least
        if (found->count >= minSamples) break;
    }
    return best;
}

/// Calls `use` with each cell that add() would change, where it is.
template <typename Use>
void OutgoingCells::forEachCell(const Site& site, Use&& use) {
    if (site.level == kNowhere) return;
    const Place place = placeOf(site);
    for (int level = std::max(site.level - kFiner, 0); level < kLevels; ++level) {
        Slot& slot = slotFor(place.keyOf(level));
        if (slot.key != 0) use(slot);
    }
}

/// What was taken, or must not be, has no samples any more.
void OutgoingCells::takeOver(OutgoingCells& old, std::span<const Site> sites,
                             std::span<const std::uint32_t> kept) {
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (kept[i] == 0) old.forEachCell(sites[i], [](Slot& slot) { slot.count = 0; });
    for (std::size_t i = 0; i < sites.size(); ++i) {
        old.forEachCell(sites[i], [&](Slot& slot) {
            const std::uint32_t all = std::exchange(slot.count, 0), count = std::min(all, kept[i]);
            if (count == 0) return;
            const float part = static_cast<float>(count) / static_cast<float>(all);
            if (2 * (used_ + 1) > slots_.size()) rehash(2 * slots_.size(), 0);
            Slot& own = slotFor(slot.key);
            if (own.key == 0) ++used_;
            own.key = slot.key;
            own.sum += slot.sum * part;
            own.squares += slot.squares * part;
            own.count += count;
            own.frame = std::max(own.frame, slot.frame);
        });
    }
}

bool OutgoingCells::samplesDiffer(const Slot& slot) {
    const float sum = luminance(slot.sum);
    return slot.squares * static_cast<float>(slot.count) > kDiffer * sum * sum;
}

std::uint32_t OutgoingCells::samples(const Site& site) const {
    std::uint32_t found = 0;
    samples({&site, 1}, {&found, 1});
    return found;
}

std::optional<Colour> OutgoingCells::radiance(const Site& site) const {
    std::optional<Colour> found;
    radiance({&site, 1}, {&found, 1});
    return found;
}

std::optional<Colour> OutgoingCells::smoothRadiance(const Site& site) const {
    constexpr int kCoarser = 3;
    constexpr float kLacking = 8; // samples
    if (empty() || site.level == kNowhere) return std::nullopt;
    const Place place = placeOf(site);
    std::optional<Colour> mean;
    for (int level = std::min(site.level + kCoarser, kLevels - 1); level >= site.level; --level) {
        const Slot* const slot = find(place.keyOf(level));
        if (slot == nullptr) break; // finer ones have no samples either
        const auto count = static_cast<float>(slot->count);
        mean = mean ? (slot->sum + *mean * kLacking) / (count + kLacking) : slot->sum / count;
    }
    return mean ? mean : radianceAt(place, site);
}

void OutgoingCells::samples(std::span<const Site> sites, std::span<std::uint32_t> found) const {
    if (empty()) {
        std::ranges::fill(found, 0U);
        return;
    }
    std::array<std::uint64_t, kSitesAtOnce> keys;
    for (std::size_t first = 0; first < sites.size(); first += kSitesAtOnce) {
        const std::size_t count = std::min(kSitesAtOnce, sites.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            const Site& site = sites[first + i];
            if (site.level == kNowhere) continue;
            keys[i] = placeOf(site).keyOf(site.level);
            prefetch(keys[i]);
        }
        for (std::size_t i = 0; i < count; ++i) {
            const Slot* const own = sites[first + i].level != kNowhere ? find(keys[i]) : nullptr;
            found[first + i] = own != nullptr ? own->count : 0;
        }
    }
}

void OutgoingCells::radiance(std::span<const Site> sites, std::span<std::optional<Colour>> found) const {
    if (empty()) {
        std::ranges::fill(found, std::nullopt);
        return;
    }
    std::array<Place, kSitesAtOnce> places;
    for (std::size_t first = 0; first < sites.size(); first += kSitesAtOnce) {
        const std::size_t count = std::min(kSitesAtOnce, sites.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            const Site& site = sites[first + i];
            if (site.level == kNowhere) continue;
            places[i] = placeOf(site);
            for (int level = site.level; level >= std::max(site.level - kFiner, 0); --level)
                prefetch(places[i].keyOf(level));
        }
        for (std::size_t i = 0; i < count; ++i) {
            const Site& site = sites[first + i];
            found[first + i] = site.level != kNowhere ? radianceAt(places[i], site) : std::nullopt;
        }
    }
}

std::optional<Colour> OutgoingCells::radianceAt(const Place& place, const Site& site) const {
    const Slot* const own = find(place.keyOf(site.level));
    if (own == nullptr || own->count < kEnough) return coarserAt(place, site, own);
    const std::uint32_t enough = samplesDiffer(*own) ? kSomeOfFiner : kEnoughOfFiner;
    for (int level = std::max(site.level - kFiner, 0); level < site.level; ++level) {
        const Slot* const finer = find(place.keyOf(level));
        if (finer != nullptr && finer->count >= enough) return meanOf(*finer);
    }
    return meanOf(*own);
}

/// Where the cell of the site's level (may be null) does not know enough.
std::optional<Colour> OutgoingCells::coarserAt(const Place& place, const Site& site, const Slot* own) const {
    const Slot* best = own;
    for (int level = site.level + 1; level < kLevels; ++level) {
        const float side = finest_ * static_cast<float>(1 << level);
        if (best != nullptr && best->count >= kSome && side > kMaxSideOfSome * site.length) break;
        const Slot* const found = find(place.keyOf(level));
        if (found == nullptr) continue;
        best = found; // coarser cells know as much at least
        if (found->count >= kEnough) break;
    }
    if (best == nullptr) return std::nullopt;
    return meanOf(*best);
}

} // namespace rtcore

#include "rtcore/live/point_choice.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rtcore {

namespace {

constexpr int kChoiceTile = 32; ///< pixels; those of one are traced together

// Old light shows where it is from elsewhere (square of pixels), or old, beside light that differs.
constexpr float kLeastOffset = 0.02F, kLeastContrast = 0.02F;
constexpr float kAged = 0.003F;         ///< each frame counts as so many square pixels
constexpr float kAgedOfMirrors = 0.25F; ///< what is mirrored moves on the surface
constexpr float kDark = 1.7F;           ///< of the mean luminance: less contrast is seen there

/// Urgency has four steps for each power of two, from 2^-14 on: the upper bits of a float.
constexpr int kUrgencyShift = 21, kFirstUrgency = (127 - 14) << 2;

int tileRows(const LiveImage& image) { return (image.plane.height + kChoiceTile - 1) / kChoiceTile; }

/// Calls `work` with the rows of pixels from `first` to before `last` of each row of tiles.
template <typename Work>
void forEachRowOfTiles(const LiveImage& image, [[maybe_unused]] int threads, Work&& work) {
    const int rows = tileRows(image);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (int row = 0; row < rows; ++row)
        work(static_cast<std::size_t>(row), row * kChoiceTile,
             std::min((row + 1) * kChoiceTile, image.plane.height));
}

} // namespace

void PointChoice::measureLuminance(const LiveImage& image, int threads) {
    luminance_.resize(image.points.size());
    sums_.assign(static_cast<std::size_t>(tileRows(image)), {});
    forEachRowOfTiles(image, threads, [&](std::size_t row, int first, int last) {
        LightSum& sum = sums_[row];
        for (std::size_t i = image.index(0, first); i < image.index(0, last); ++i) {
            const LivePoint& point = image.points[i];
            luminance_[i] = point.lit() ? luminance(unpackLight(point.light)) : -1;
            if (!point.lit()) continue;
            sum.luminance += static_cast<double>(luminance_[i]);
            ++sum.points;
        }
    });
    double sum = 0;
    std::size_t count = 0;
    for (const LightSum& row : sums_) {
        sum += row.luminance;
        count += row.points;
    }
    dark_ = count > 0 ? kDark * static_cast<float>(sum / static_cast<double>(count)) : 1;
    unknown_ =
        1 - static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, luminance_.size()));
}

std::uint8_t PointChoice::urgencyAt(const LiveImage& image, int x, int y) const {
    const LivePoint& point = image.at(x, y);
    if (!point.lit()) return kUrgencies - 1;
    const float across = point.across / kOffsetSteps, down = point.down / kOffsetSteps;
    const float offset = across * across + down * down;
    if (offset == 0 && point.age == 0) return 0;
    float least = luminance_[image.index(x, y)], most = least;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.plane.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.plane.width - 1); ++u) {
            const float there = luminance_[image.index(u, v)];
            if (there < 0) continue;
            least = std::min(least, there);
            most = std::max(most, there);
        }
    }
    const float contrast = (most - least) / (most + least + dark_);
    const float aged = point.age * (point.viewDependent() ? kAgedOfMirrors : kAged);
    const float shows = (offset + kLeastOffset + aged) * (contrast + kLeastContrast);
    const int step = static_cast<int>(std::bit_cast<std::uint32_t>(shows) >> kUrgencyShift) - kFirstUrgency;
    return static_cast<std::uint8_t>(std::clamp(step, 1, static_cast<int>(kUrgencies) - 2));
}

void PointChoice::measureUrgency(const LiveImage& image, int threads) {
    urgency_.resize(image.points.size());
    histograms_.assign(static_cast<std::size_t>(tileRows(image)), {});
    forEachRowOfTiles(image, threads, [&](std::size_t row, int first, int last) {
        for (int y = first; y < last; ++y) {
            for (int x = 0; x < image.plane.width; ++x) {
                const std::uint8_t urgency = urgencyAt(image, x, y);
                urgency_[image.index(x, y)] = urgency;
                ++histograms_[row][urgency];
            }
        }
    });
}

void PointChoice::choose(const LiveImage& image, double share, std::uint32_t number, int threads) {
    measureLuminance(image, threads);
    measureUrgency(image, threads);
    // All above the bound, and of those on it as many as fit, by turns.
    double room = share * static_cast<double>(image.points.size()), part = 0;
    std::size_t bound = kUrgencies - 1;
    for (; bound > 0; --bound) {
        double count = 0;
        for (const Histogram& histogram : histograms_) count += static_cast<double>(histogram[bound]);
        if (count > room) {
            part = room / count;
            break;
        }
        room -= count;
    }
    const auto turns = static_cast<std::uint32_t>(std::lround(part * kTurns));
    ofTiles_.resize(histograms_.size());
    forEachRowOfTiles(image, threads, [&](std::size_t row, int first, int last) {
        std::vector<SampleId>& chosen = ofTiles_[row];
        chosen.clear();
        for (int left = 0; left < image.plane.width; left += kChoiceTile) {
            for (int y = first; y < last; ++y) {
                for (int x = left; x < std::min(left + kChoiceTile, image.plane.width); ++x) {
                    const std::size_t urgency = urgency_[image.index(x, y)];
                    if (urgency == 0 || urgency < bound) continue;
                    if (urgency == bound && (turnOf(x, y) + number * 37U) % kTurns >= turns) continue;
                    chosen.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0});
                }
            }
        }
    });
    chosen_.clear();
    for (const std::vector<SampleId>& tiles : ofTiles_)
        chosen_.insert(chosen_.end(), tiles.begin(), tiles.end());
}

} // namespace rtcore

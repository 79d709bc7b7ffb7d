#include "rtcore/pathtracing/visibility_cache.h"

#include "rtcore/lights/interval_starts.h"
#include "rtcore/math/box.h"
#include "rtcore/sampling/sample_id.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr int kSide = VisibilityRows::kSide;
constexpr std::size_t kBins = std::size_t{kSide} * kSide;

constexpr std::size_t kSamplesOfCell = 48; ///< with more of them a cell is split
constexpr int kMaxDepth = 24;
/// So many tries of each bin and light count what is known of a larger cell.
constexpr double kTriesOfParent = 10;
/// Of the mean of a cell's bins, what each of them counts more: what samples missed must not be missing.
constexpr double kUnseen = 0.3;
/// The same of each of the bins beside it.
constexpr double kUnseenBeside = 0.1;
/// The least that surroundings and lights count, of what they throw unhindered.
constexpr double kMinSurroundings = 0.005, kMinLight = 0.05;

/// The tree of normals that are nearest to an axis; visibility_cache-inl.h has the same for vectors.
int rootOf(Vec3 normal) {
    const float x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
    const int axis = x >= y && x >= z ? 0 : (y >= z ? 1 : 2);
    return 2 * axis + (normal[axis] < 0 ? 1 : 0);
}

/// The sum of the four bins beside one.
double besides(const std::array<double, kBins>& sky, std::size_t row, std::size_t column) {
    const auto at = [&](std::size_t y, std::size_t x) { return sky[y * kSide + x]; };
    const std::size_t last = kSide - 1;
    return at(row, (column + last) % kSide) + at(row, (column + 1) % kSide) +
           at(row > 0 ? row - 1 : row, column) + at(row < last ? row + 1 : row, column);
}

/// For each bin of the surroundings and each light.
struct Numbers {
    std::array<double, kBins> sky{};
    std::vector<double> light;

    explicit Numbers(std::size_t lights, double all = 0) : light(lights, all) { sky.fill(all); }
};

/// The sums of what samples saw, in whole numbers, so that their order does not matter, and of how many
/// tries.
struct Sums {
    Numbers seen, tries;

    explicit Sums(std::size_t lights) : seen(lights), tries(lights) {}
    void add(const VisibilitySample& sample, std::size_t some) {
        for (const VisibilitySample::Try& each : std::span(sample.sky).first(some)) {
            seen.sky[each.bin] += each.seen;
            tries.sky[each.bin] += 1;
        }
        for (std::uint32_t k = 0; k < VisibilitySample::kLights; ++k) {
            const std::uint8_t arriving = sample.light[k];
            if (arriving == VisibilitySample::kUntried) continue;
            const std::size_t light = sample.lightOf(k, seen.light.size());
            seen.light[light] += arriving;
            tries.light[light] += 1;
        }
    }
};

/// How much is seen by these sums, where `known` is what is known else.
Numbers estimateOf(const Sums& sums, const Numbers& known) {
    Numbers result = known;
    const auto mix = [](double& estimate, double seen, double tries) {
        estimate = (seen / VisibilitySample::kAll + kTriesOfParent * estimate) / (tries + kTriesOfParent);
    };
    for (std::size_t i = 0; i < kBins; ++i) mix(result.sky[i], sums.seen.sky[i], sums.tries.sky[i]);
    for (std::size_t i = 0; i < result.light.size(); ++i)
        mix(result.light[i], sums.seen.light[i], sums.tries.light[i]);
    return result;
}

/// Grows the trees of cells.
class Builder {
  public:
    Builder(std::size_t tries, std::size_t lights, double scalarIrradiance, VisibilityCache::Tables& tables)
        : tries_(tries), lights_(lights), scalarIrradiance_(scalarIrradiance), tables_(tables) {}

    using Samples = std::span<const VisibilitySample*>;

    /// The node, and all below it.
    void grow(std::size_t node, Samples samples, const Numbers& known, int depth) {
        Sums sums(lights_);
        Box3 box;
        for (const VisibilitySample* const sample : samples) {
            sums.add(*sample, tries_);
            box.extend(sample->position);
        }
        const Numbers estimate = estimateOf(sums, known);
        if (samples.size() <= kSamplesOfCell || depth == kMaxDepth) return addCell(node, estimate);
        const Vec3 size = box.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
        const float split = box.centre()[axis];
        const auto middle =
            std::partition(samples.begin(), samples.end(),
                           [&](const VisibilitySample* sample) { return sample->position[axis] < split; });
        const auto below = static_cast<std::size_t>(middle - samples.begin());
        if (below == 0 || below == samples.size()) return addCell(node, estimate);
        const std::size_t first = addNodes(2);
        tables_.links[node] = static_cast<std::uint32_t>(first) << 2 | static_cast<std::uint32_t>(axis);
        tables_.splits[node] = split;
        grow(first, samples.first(below), estimate, depth + 1);
        grow(first + 1, samples.subspan(below), estimate, depth + 1);
    }
    std::size_t addNodes(std::size_t count) {
        const std::size_t first = tables_.links.size();
        tables_.links.resize(first + count);
        tables_.splits.resize(first + count);
        return first;
    }

  private:
    void addCell(std::size_t node, const Numbers& estimate) {
        tables_.links[node] = VisibilityRows::kLeaf | static_cast<std::uint32_t>(tables_.surroundings.size());
        double mean = 0;
        for (const double bin : estimate.sky) mean += bin / kBins;
        std::array<double, kSide> ofRows{};
        for (std::size_t row = 0; row < kSide; ++row) {
            std::array<double, kSide> bins{};
            for (std::size_t column = 0; column < kSide; ++column) {
                bins[column] = estimate.sky[row * kSide + column] + kUnseen * mean +
                               kUnseenBeside * besides(estimate.sky, row, column);
                ofRows[row] += bins[column];
            }
            addStarts(bins, tables_.columnStarts);
        }
        addStarts(ofRows, tables_.rowStarts);
        tables_.surroundings.push_back(
            static_cast<float>(scalarIrradiance_ * std::max(mean, kMinSurroundings)));
        for (const double arriving : estimate.light)
            tables_.lights.push_back(static_cast<float>(kMinLight + (1 - kMinLight) * arriving));
    }

    std::size_t tries_, lights_;
    double scalarIrradiance_;
    VisibilityCache::Tables& tables_;
};

} // namespace

void VisibilityCache::build(std::span<const VisibilitySample> samples, std::size_t tries, std::size_t lights,
                            double scalarIrradiance) {
    tables_ = {};
    lightCount_ = lights;
    if (samples.empty()) return;
    std::array<std::vector<const VisibilitySample*>, 6> ofRoots;
    Sums all(lights);
    for (const VisibilitySample& sample : samples) {
        ofRoots[static_cast<std::size_t>(rootOf(sample.normal))].push_back(&sample);
        all.add(sample, tries);
    }
    Builder builder(tries, lights, scalarIrradiance, tables_);
    builder.addNodes(ofRoots.size());
    const Numbers known = estimateOf(all, Numbers(lights, 0.5));
    for (std::size_t root = 0; root < ofRoots.size(); ++root) builder.grow(root, ofRoots[root], known, 0);
}

VisibilityRows VisibilityCache::rows() const {
    VisibilityRows rows;
    if (empty()) return rows;
    rows.links = tables_.links.data();
    rows.splits = tables_.splits.data();
    rows.rowStarts = tables_.rowStarts.data();
    rows.columnStarts = tables_.columnStarts.data();
    rows.surroundings = tables_.surroundings.data();
    rows.lights = tables_.lights.data();
    rows.cells = static_cast<std::int32_t>(tables_.surroundings.size());
    rows.lightCount = static_cast<std::int32_t>(lightCount_);
    return rows;
}

} // namespace rtcore

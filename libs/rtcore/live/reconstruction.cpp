#include "rtcore/live/reconstruction.h"

#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <atomic>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/live/reconstruction.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/live/live_samples-inl.h"

#ifndef RTCORE_LIVE_RECONSTRUCTION_TYPES
#define RTCORE_LIVE_RECONSTRUCTION_TYPES
namespace rtcore {

/// A part of a row of a layer's samples with their weights. Each array can be read one before its first
/// pixel, and a vector behind its last.
struct WeighedLayer {
    float* light[3];
    float* across[3]; ///< weight in the pixel to the left, in its own, in that to the right
    float* down[3];   ///< in the pixel above, in its own, in that below
};
struct WeighedRow {
    static constexpr std::size_t kPixels = 256; ///< few, so that all stays in the first cache
    static constexpr std::size_t kRoom = 64;    ///< no vector has more lanes
    static constexpr std::size_t kGroup = 8;
    static_assert((kPixels + kRoom) / kGroup < 63);
    static constexpr std::size_t kArray = kPixels + 2 * kRoom, kArrays = 9 + 9 + 3;

    WeighedLayer surface, specular;
    float* tint[3]; ///< of own's samples; 0 where they do not mirror
    /// One bit for each kGroup pixels, from the one before the first on: one of them mirrors. Where all bits
    /// are 0, `specular` and `tint` are undefined.
    std::uint64_t mirroring = 0;

    /// Bits of `mirroring` of pixels from `first` to `last`, counted from the one before the first.
    static std::uint64_t groupsOf(std::size_t first, std::size_t last) {
        return (std::uint64_t{2} << last / kGroup) - (std::uint64_t{1} << first / kGroup);
    }

    /// `values`: kArrays * kArray of them.
    explicit WeighedRow(float* values) {
        float* next = values + kRoom;
        for (auto* arrays : {&surface.light, &surface.across, &surface.down, &specular.light,
                             &specular.across, &specular.down, &tint}) {
            for (float*& array : *arrays) {
                array = next;
                next += kArray;
            }
        }
    }
};

/// Columns of an image.
struct Columns {
    std::size_t first, last;
};

/// Output of a part of a row of pixels.
struct ShownPixels {
    Colour* light;
    float* known; ///< 0..1: how well the light is known by the samples around
    /// Tints of pixels whose specular light is missing: the first pixel of each vector that has any, and the
    /// tints from there on; 0 where none is missing.
    std::uint32_t* lacking;
    float* tints[3];
};
struct Missing {
    bool light = false;
    std::size_t specular = 0; ///< vectors
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace {

/// Weight of a sample so many pixels away, across or down.
HWY_INLINE Float weightAt(Float distance) {
    constexpr float kMin = 1e-4F; // of what is further away than a pixel, where nothing else is
    const Float falling = max(1.0F - distance * distance, kMin);
    return falling * falling;
}

/// Stores the samples of row `y` from column `x` on with their weights, from `at` on in the arrays. The
/// weights of unknown ones are 0.
HWY_INLINE void weigh(const LivePoints& points, Float3 light, Mask known, const ImagePlane& plane,
                      std::size_t x, int y, const WeighedLayer& to, std::ptrdiff_t at) {
    const SeenAt seen = seenAt(points, plane);
    const Float dx = seen.x - (toFloat(toInt(iota(x))) + 0.5F), dy = seen.y - (static_cast<float>(y) + 0.5F);
    store(light.x, to.light[0] + at);
    store(light.y, to.light[1] + at);
    store(light.z, to.light[2] + at);
    for (int side = -1; side <= 1; ++side) {
        const auto shift = static_cast<float>(side);
        store(selectOrZero(known, weightAt(dx - shift)), to.across[side + 1] + at);
        store(selectOrZero(known, weightAt(dy - shift)), to.down[side + 1] + at);
    }
}

/// Calls `use` with the columns and their neighbours, a vector at a time, and with its index in the arrays.
template <typename Use>
HWY_INLINE void forEachColumn(const Columns& columns, std::size_t width, Use&& use) {
    const std::size_t first = columns.first - (columns.first > 0 ? 1 : 0),
                      last = std::min(columns.last + 1, width);
    for (std::size_t x = first; x < last; x += lanes())
        use(x, static_cast<std::ptrdiff_t>(x) - static_cast<std::ptrdiff_t>(columns.first));
}

/// WeighedRow::groupsOf() a vector.
HWY_INLINE std::uint64_t groupsAt(std::ptrdiff_t at) {
    const auto first = static_cast<std::size_t>(at + 1);
    return WeighedRow::groupsOf(first, first + lanes() - 1);
}

/// Returns WeighedRow::mirroring.
std::uint64_t weighSurface(const LiveSamples& surface, int y, const Columns& columns, const WeighedRow& to) {
    const ImagePlane& plane = surface.plane();
    const std::size_t row = surface.index(0, y);
    std::uint64_t mirroring = 0;
    forEachColumn(columns, static_cast<std::size_t>(plane.width),
                  [&](std::size_t x, std::ptrdiff_t at) HWY_ATTR {
                      const LivePoints points(surface.points[row + x]);
                      weigh(points, radianceOf(surface.lights[row + x]), points.state != 0U, plane, x, y,
                            to.surface, at);
                      if (any(points.has(LiveSamples::kMirrors))) mirroring |= groupsAt(at);
                  });
    return mirroring;
}

/// After weighSurface() of the same columns.
void weighSpecular(const LiveLayers& samples, int y, const Columns& columns, const WeighedRow& to) {
    const ImagePlane& plane = samples.surface.plane();
    const std::size_t row = samples.surface.index(0, y);
    const auto weighVector = [&](std::size_t x, std::ptrdiff_t at) HWY_ATTR {
        if ((to.mirroring & groupsAt(at)) == 0) {
            for (float* const array : to.specular.across) store(Float(0.0F), array + at);
            for (float* const array : to.tint) store(Float(0.0F), array + at);
            return;
        }
        const std::size_t i = row + x;
        const Uint surface = statesOf(samples.surface.points[i]);
        const Mask mirrors = (surface & LiveSamples::kMirrors) != 0U;
        const LivePoints points(samples.specular.points[i]);
        weigh(points, radianceOf(samples.specular.lights[i]),
              (mirrors | (surface == 0U)) & (points.state != 0U), plane, x, y, to.specular, at);
        const Float3 tint = selectOrZero(mirrors, tintOf(samples.tints[i]));
        store(tint.x, to.tint[0] + at);
        store(tint.y, to.tint[1] + at);
        store(tint.z, to.tint[2] + at);
    };
    forEachColumn(columns, static_cast<std::size_t>(plane.width), weighVector);
}

HWY_INLINE Float3 load3(float* const from[3], std::size_t at) {
    return {load(from[0] + at), load(from[1] + at), load(from[2] + at)};
}

/// Calls `use` with the weight of each of the 3 x 3 samples around the pixels from column `x` on, its row and
/// its column.
template <typename Layer, typename Use>
HWY_INLINE void forEachAround(const WeighedRow* const rows[3], std::size_t x, Layer&& layerOf, Use&& use) {
    for (std::size_t v = 0; v < 3; ++v) {
        const WeighedLayer& layer = layerOf(*rows[v]);
        for (std::size_t u = 0; u < 3; ++u) {
            const std::size_t at = x + u - 1;
            use(load(layer.across[2 - u] + at) * load(layer.down[2 - v] + at), *rows[v], at);
        }
    }
}

/// `count` <= lanes() pixels.
HWY_INLINE void storePixels(Float3 light, std::size_t count, Colour* to) {
    if (count == lanes()) {
        hn::StoreInterleaved3(light.x.raw, light.y.raw, light.z.raw, FloatTag(), &to->r);
        return;
    }
    float last[3][kLanes];
    store(light.x, last[0]);
    store(light.y, last[1]);
    store(light.z, last[2]);
    for (std::size_t k = 0; k < count; ++k) to[k] = {last[0][k], last[1][k], last[2][k]};
}

/// Means over the samples around a vector of pixels, in their row and in those above and below.
struct Means {
    Float3 light;
    Mask seen; ///< where there are samples
    Float weights, samples;
};
HWY_INLINE Means surfaceMeans(const WeighedRow* const rows[3], std::size_t x) {
    Float3 sum{};
    Float weights = 0.0F, samples = 0.0F;
    forEachAround(
        rows, x, [](const WeighedRow& row) -> const WeighedLayer& { return row.surface; },
        [&](Float weight, const WeighedRow& row, std::size_t at) HWY_ATTR {
            sum += load3(row.surface.light, at) * weight;
            weights += weight;
            samples += selectOrZero(weight > 0.0F, Float(1.0F));
        });
    return {sum / weights, weights > 0.0F, weights, samples};
}

/// How well a pixel is known, 0..1. Where samples are few, each would be visible by itself, as a stone of a
/// mosaic; and so would samples far from the middle, unless they are many.
HWY_INLINE Float knownOf(const Means& means) {
    constexpr float kFew = 4, kMany = 7, kNear = 0.25F; // samples; weights
    const Float many = (means.samples - kFew) * (1 / (kMany - kFew));
    return min(means.samples * (1 / kFew), 1.0F) * min(max(means.weights * (1 / kNear), many), 1.0F);
}

/// Specular light at these pixels, tinted by the samples there. `lacking`: the tint where that light is not
/// known.
HWY_INLINE Float3 specularMeans(const WeighedRow* const rows[3], std::size_t x, const Means& surface,
                                Float3& lacking) {
    Float3 tint{}, specular{};
    Float known = 0.0F;
    forEachAround(
        rows, x, [](const WeighedRow& row) -> const WeighedLayer& { return row.surface; },
        [&](Float weight, const WeighedRow& row, std::size_t at) HWY_ATTR {
            if (row.mirroring != 0) tint += load3(row.tint, at) * weight;
        });
    forEachAround(
        rows, x, [](const WeighedRow& row) -> const WeighedLayer& { return row.specular; },
        [&](Float weight, const WeighedRow& row, std::size_t at) HWY_ATTR {
            if (row.mirroring == 0) return;
            specular += load3(row.specular.light, at) * weight;
            known += weight;
        });
    const Mask tinted = surface.seen & (max(tint.x, max(tint.y, tint.z)) > 0.0F),
               there = tinted & (known > 0.0F);
    tint = tint / surface.weights;
    lacking = selectOrZero(tinted & !there, tint);
    return selectOrZero(there, specular / known * tint);
}

/// The light of `count` pixels.
Missing weighedMeans(const WeighedRow* const rows[3], std::size_t count, const ShownPixels& to) {
    Missing missing;
    const std::uint64_t mirroring = rows[0]->mirroring | rows[1]->mirroring | rows[2]->mirroring;
    for (std::size_t x = 0; x < count; x += lanes()) {
        const Mask inside = toFloat(toInt(iota(x))) < static_cast<float>(count);
        Means surface = surfaceMeans(rows, x);
        const Float known = knownOf(surface);
        missing.light = missing.light || any(inside & (known < 1.0F));
        store(known, to.known + x);
        if ((mirroring & WeighedRow::groupsOf(x, x + lanes() + 1)) != 0) {
            Float3 lacking;
            surface.light += specularMeans(rows, x, surface, lacking);
            if (any(inside & (max(lacking.x, max(lacking.y, lacking.z)) > 0.0F))) {
                store(lacking.x, to.tints[0] + x);
                store(lacking.y, to.tints[1] + x);
                store(lacking.z, to.tints[2] + x);
                to.lacking[missing.specular++] = static_cast<std::uint32_t>(x);
            }
        }
        storePixels(selectOrZero(surface.seen, surface.light), std::min(lanes(), count - x), to.light + x);
    }
    return missing;
}

std::size_t lanesOfMeans() { return lanes(); }

} // namespace

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(weighSurface);
HWY_EXPORT(weighSpecular);
HWY_EXPORT(weighedMeans);
HWY_EXPORT(lanesOfMeans);

/// Reconstructs the rows of a part between columns. Returns whether light is missing.
bool Reconstruction::showColumns(const LiveLayers& samples, int first, int last, const Columns& columns,
                                 Rows& rows, Frame& frame) {
    constexpr std::size_t kKept = 4; // the row, that above, that below, and one of no weight beyond the image
    constexpr std::size_t kRow = WeighedRow::kArrays * WeighedRow::kArray;
    rows.values.resize(kKept * kRow + 3 * WeighedRow::kArray);
    rows.lacking.resize(WeighedRow::kArray);
    rows.known.resize(WeighedRow::kArray);
    float* const values = rows.values.data();
    WeighedRow weighed[kKept] = {WeighedRow(values), WeighedRow(values + kRow), WeighedRow(values + 2 * kRow),
                                 WeighedRow(values + 3 * kRow)};
    const ImagePlane& plane = samples.surface.plane();
    const auto width = static_cast<std::size_t>(plane.width);
    const auto rowAt = [&](int y) {
        return &weighed[y < 0 || y >= plane.height ? kKept - 1 : static_cast<std::size_t>(y) % (kKept - 1)];
    };
    const auto weighNoneBeside = [&](const WeighedLayer& layer) {
        for (float* const array : layer.across) {
            if (columns.first == 0) array[-1] = 0;
            if (columns.last == width) std::fill_n(array + (width - columns.first), WeighedRow::kRoom, 0.0F);
        }
    };
    const auto weigh = [&](int y) {
        if (y < 0 || y >= plane.height) return;
        WeighedRow& row = *rowAt(y);
        row.mirroring = HWY_DYNAMIC_DISPATCH(weighSurface)(samples.surface, y, columns, row);
        weighNoneBeside(row.surface);
        if (row.mirroring == 0) return;
        HWY_DYNAMIC_DISPATCH(weighSpecular)(samples, y, columns, row);
        weighNoneBeside(row.specular);
    };
    float* const tints = values + kKept * kRow;
    weigh(first - 1);
    weigh(first);
    bool missing = false;
    for (int y = first; y < last; ++y) {
        weigh(y + 1);
        const WeighedRow* const around[] = {rowAt(y - 1), rowAt(y), rowAt(y + 1)};
        const std::size_t row = samples.surface.index(0, y) + columns.first;
        const ShownPixels shown{&frame.radiance.pixels[row],
                                rows.known.data(),
                                rows.lacking.data(),
                                {tints, tints + WeighedRow::kArray, tints + 2 * WeighedRow::kArray}};
        const std::size_t count = columns.last - columns.first;
        const Missing here = HWY_DYNAMIC_DISPATCH(weighedMeans)(around, count, shown);
        missing = missing || here.light;
        std::copy_n(rows.known.data(), count, &known_[row]);
        const std::size_t lanes = HWY_DYNAMIC_DISPATCH(lanesOfMeans)();
        for (std::size_t k = 0; k < here.specular; ++k) {
            for (std::size_t x = rows.lacking[k]; x < std::min(rows.lacking[k] + lanes, count); ++x) {
                const Colour tint{shown.tints[0][x], shown.tints[1][x], shown.tints[2][x]};
                if (!isBlack(tint)) rows.missing.push_back({row + x, tint});
            }
        }
    }
    return missing;
}

void Reconstruction::show(const LiveLayers& samples, int threads, Frame& frame) {
    const ImagePlane& plane = samples.surface.plane();
    rows_.resize(std::max(rows_.size(), static_cast<std::size_t>(threads)));
    for (Rows& rows : rows_) rows.missing.clear();
    std::atomic<bool> missing = false;
    known_.resize(samples.surface.size());
    const auto width = static_cast<std::size_t>(plane.width);
    forEachRows(plane.height, SampleMeans::kSide, threads, [&](int first, int last) {
        Rows& rows = rows_[static_cast<std::size_t>(threadNumber())];
        for (std::size_t left = 0; left < width; left += WeighedRow::kPixels) {
            const Columns columns{left, std::min(left + WeighedRow::kPixels, width)};
            if (showColumns(samples, first, last, columns, rows, frame))
                missing.store(true, std::memory_order_relaxed);
        }
    });
    if (std::ranges::any_of(rows_, [](const Rows& rows) { return !rows.missing.empty(); }))
        addMissing(samples, threads, frame);
    if (missing) fill(threads, frame);
}

/// Fills in missing specular light by means over the mirrors around.
void Reconstruction::addMissing(const LiveLayers& samples, int threads, Frame& frame) {
    const ImagePlane& plane = samples.surface.plane();
    const auto specularAt = [&](int x, int y) -> SampleMeans::Weighed {
        const std::size_t i = samples.surface.index(x, y);
        const bool mayMirror = samples.surface.mirrors(i) || !samples.surface.known(i);
        if (!mayMirror || !samples.specular.known(i)) return {};
        return {samples.specular.light(i), 1};
    };
    means_.begin(plane.width, plane.height);
    forEachRows(plane.height, SampleMeans::kSide, threads,
                [&](int first, int last) { means_.take(specularAt, first, last); });
    const auto width = static_cast<std::size_t>(plane.width);
    for (const Rows& rows : rows_) {
        for (const MissingLight& missing : rows.missing) {
            const auto x = static_cast<int>(missing.pixel % width),
                       y = static_cast<int>(missing.pixel / width);
            frame.radiance.pixels[missing.pixel] += missing.tint * means_.around(x, y);
        }
    }
}

/// Blends pixels of which little is known with means over the image around.
void Reconstruction::fill(int threads, Frame& frame) {
    HdrImage& image = frame.radiance;
    const auto knownAt = [&](int x, int y) {
        return known_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                      static_cast<std::size_t>(x)];
    };
    const auto lightAt = [&](int x, int y) {
        const float known = knownAt(x, y);
        return SampleMeans::Weighed{image.at(x, y) * known, known};
    };
    means_.begin(image.width, image.height);
    forEachRows(image.height, SampleMeans::kSide, threads,
                [&](int first, int last) { means_.take(lightAt, first, last); });
    constexpr int kRows = 8;
    forEachRows(image.height, kRows, threads, [&](int first, int last) {
        for (int y = first; y < last; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const float known = knownAt(x, y);
                if (known < 1) image.at(x, y) = image.at(x, y) * known + means_.around(x, y) * (1 - known);
            }
        }
    });
}

} // namespace rtcore
#endif

#include "rtcore/upsample/upsample.h"

#include "rtcore/math/colour.h"
#include "rtcore/platform/parts.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/upsample/upsample.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/simd/wide-inl.h"

#ifndef RTCORE_UPSAMPLE_TYPES
#define RTCORE_UPSAMPLE_TYPES
namespace rtcore {

constexpr int kPlanes = 3;                ///< channels of a pixel, and parts of a tensor
constexpr int kTaps = 4;                  ///< pixels that are weighed, across and down
constexpr int kBorder = 2;                ///< pixels read beyond a row
constexpr std::size_t kRoomOfVector = 64; ///< no vector has more lanes

/// A part of a row of the large image. Arrays have room for whole vectors.
struct UpsampledRow {
    static constexpr std::size_t kPixels = 256; ///< few, so that all stays near the processor
    const float* taps[kTaps][kTaps][kPlanes];   ///< by row and column of the small image
    const float* edges[2][kPlanes];             ///< above and below
    const float* across; ///< how far a pixel is to the right of the middle of the second column, 0..1
    float even;          ///< fall-off to all sides, where there is no edge
    float down;          ///< how far below that of the second row
    std::size_t pixels;
    float* to[kPlanes];
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace {

/// Products of the slopes of a row, of which the brightness above, of itself and below can be read a pixel
/// beyond its ends.
void slopesOf(const float* const brightness[3], std::size_t count, float* const to[kPlanes]) {
    for (std::size_t x = 0; x < count; x += lanes()) {
        const Float across = load(brightness[1] + x + 1) - load(brightness[1] + x - 1);
        const Float down = load(brightness[2] + x) - load(brightness[0] + x);
        store(across * across, to[0] + x);
        store(down * down, to[1] + x);
        store(across * down, to[2] + x);
    }
}

/// Binomial weights of five.
HWY_INLINE Float smoothOf(Float a, Float b, Float c, Float d, Float e) {
    return ((a + e) + (b + d) * 4.0F + c * 6.0F) * (1.0F / 16);
}
void smoothDown(const float* const rows[5], std::size_t count, float* to) {
    for (std::size_t x = 0; x < count; x += lanes()) {
        store(smoothOf(load(rows[0] + x), load(rows[1] + x), load(rows[2] + x), load(rows[3] + x),
                       load(rows[4] + x)),
              to + x);
    }
}
/// `row` can be read two pixels beyond its ends.
void smoothAcross(const float* row, std::size_t count, float* to) {
    for (std::size_t x = 0; x < count; x += lanes()) {
        const float* const at = row + x;
        store(smoothOf(load(at - 2), load(at - 1), load(at), load(at + 1), load(at + 2)), to + x);
    }
}

/// Falls from 1 to 0 at two pixels.
template <typename F>
HWY_INLINE F windowOf(F distance) {
    const F falling = F(1.0F) - distance * distance * 0.25F;
    return falling * falling;
}

constexpr float kSharp = 2.5F;  ///< across an edge
constexpr float kFaint = 60.0F; ///< slopes, squared, that count as half an edge (codes of 255)

void upsampleRow(const UpsampledRow& row) {
    for (std::size_t x = 0; x < row.pixels; x += lanes()) {
        const auto edge = [&](int which) HWY_ATTR {
            const Float above = load(row.edges[0][which] + x), below = load(row.edges[1][which] + x);
            return above + (below - above) * row.down;
        };
        const Float xx = edge(0), yy = edge(1), xy = edge(2);
        const Float whole = Float(1.0F) / (xx + yy + kFaint);
        // The slope's direction, twice its angle, as long as there is an edge.
        const Float cosine = (xx - yy) * whole, sine = xy * whole * 2.0F;
        const Float sure = sqrt(cosine * cosine + sine * sine);
        const Float mean = Float(row.even) + sure * (0.5F * kSharp - row.even);
        const Float a = mean + cosine * (0.5F * kSharp), b = sine * kSharp,
                    c = mean - cosine * (0.5F * kSharp);
        const Float across = load(row.across + x);
        Float red = 0.0F, green = 0.0F, blue = 0.0F, weights = 0.0F;
        for (int i = 0; i < kTaps; ++i) {
            const Float u = Float(static_cast<float>(i - 1)) - across, window = windowOf(u);
            const Float au = a * u * u, bu = b * u;
            for (int j = 0; j < kTaps; ++j) {
                const float v = static_cast<float>(j - 1) - row.down;
                // About exp(-q).
                const Float q = au + bu * v + c * (v * v), falling = max(Float(1.0F) - q * 0.25F, 0.0F),
                            square = falling * falling;
                const Float weight = square * square * window * windowOf(v);
                const auto& tap = row.taps[j][i];
                red += load(tap[0] + x) * weight;
                green += load(tap[1] + x) * weight;
                blue += load(tap[2] + x) * weight;
                weights += weight;
            }
        }
        const Float scale = Float(1.0F) / weights;
        store(red * scale, row.to[0] + x);
        store(green * scale, row.to[1] + x);
        store(blue * scale, row.to[2] + x);
    }
}

/// values[columns[i]], and some with room for a vector more.
void spreadRow(const float* values, const std::int32_t* columns, std::size_t count, float* to) {
    for (std::size_t i = 0; i < count; i += lanes()) store(gather(values, load(columns + i)), to + i);
}

/// Between values[columns[i]] and the next one, by `across`.
void mixRow(const float* values, const std::int32_t* columns, const float* across, std::size_t count,
            float* to) {
    for (std::size_t i = 0; i < count; i += lanes()) {
        const Int column = load(columns + i);
        const Float left = gather(values, column), right = gather(values + 1, column);
        store(left + (right - left) * load(across + i), to + i);
    }
}

/// Four bytes a pixel, of codes from 0 to 255.
void packRow(const float* const codes[kPlanes], std::size_t count, std::uint32_t* to) {
    for (std::size_t x = 0; x < count; x += lanes()) {
        const auto code = [&](int plane) HWY_ATTR { return toUint(truncate(load(codes[plane] + x) + 0.5F)); };
        store(code(0) | shiftLeft<8>(code(1)) | shiftLeft<16>(code(2)) | Uint(0xFF000000U), to + x);
    }
}

} // namespace

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(slopesOf);
HWY_EXPORT(smoothDown);
HWY_EXPORT(smoothAcross);
HWY_EXPORT(upsampleRow);
HWY_EXPORT(packRow);
HWY_EXPORT(spreadRow);
HWY_EXPORT(mixRow);

namespace {

constexpr int kRowsOfPart = 32;

using Pixel = std::array<float, kPlanes>;

/// The columns or rows of the small image around a pixel of the large one: the second of four, and how far
/// the pixel is beyond its middle.
struct Around {
    int second;
    float beyond;
    Around(int pixel, float scale) {
        const float at = (static_cast<float>(pixel) + 0.5F) / scale - 0.5F, whole = std::floor(at);
        second = static_cast<int>(whole);
        beyond = at - whole;
    }
};

/// Rows of the small image that follow each other, with what is known of their edges. Beyond its borders all
/// is as at these.
class SmallRows {
  public:
    using Row = std::array<const float*, kPlanes>;

    /// Those that the rows `first` to `last` of the large image are made of.
    template <typename PixelAt>
    void take(int width, int height, int first, int last, PixelAt&& pixelAt) {
        width_ = width;
        top_ = first - kSlopeRows - kSmoothRows - 1;
        rows_ = last + kSlopeRows + kSmoothRows + 2 - top_ + 1;
        for (std::vector<float>* planes : {&channels_, &slopes_, &edges_})
            planes->resize(static_cast<std::size_t>(rows_) * kPlanes * stride());
        for (int y = top_; y < top_ + rows_; ++y) {
            const int row = std::clamp(y, 0, height - 1);
            float* const to[] = {at(channels_, 0, y), at(channels_, 1, y), at(channels_, 2, y)};
            for (int x = 0; x < width; ++x) {
                const Pixel pixel = pixelAt(x, row);
                for (std::size_t plane = 0; plane < kPlanes; ++plane) to[plane][x] = pixel[plane];
            }
            for (float* const plane : to) widen(plane);
        }
        findEdges();
    }

    Row channels(int y) { return rowOf(channels_, y); }
    Row edges(int y) { return rowOf(edges_, y); }

  private:
    static constexpr int kSlopeRows = 1, kSmoothRows = 2; ///< that are read above and below

    std::size_t stride() const { return static_cast<std::size_t>(width_) + 2 * kBorder + kRoomOfVector; }
    float* at(std::vector<float>& planes, int plane, int y) const {
        const int row = (y - top_) * kPlanes + plane;
        return &planes[static_cast<std::size_t>(row) * stride() + kBorder];
    }
    Row rowOf(std::vector<float>& planes, int y) const {
        return {at(planes, 0, y), at(planes, 1, y), at(planes, 2, y)};
    }
    /// Continues a row to the left and to the right by its ends.
    void widen(float* row) const {
        for (int i = 1; i <= kBorder; ++i) {
            row[-i] = row[0];
            row[width_ - 1 + i] = row[width_ - 1];
        }
    }

    /// Green is about as bright as an image, in whatever order red and blue are.
    void findEdges() {
        constexpr int kGreen = 1, kSmoothed = 2 * kSmoothRows + 1;
        const auto count = static_cast<std::size_t>(width_);
        for (int y = top_ + kSlopeRows; y < top_ + rows_ - kSlopeRows; ++y) {
            const float* const brightness[] = {at(channels_, kGreen, y - 1), at(channels_, kGreen, y),
                                               at(channels_, kGreen, y + 1)};
            float* const to[] = {at(slopes_, 0, y), at(slopes_, 1, y), at(slopes_, 2, y)};
            HWY_DYNAMIC_DISPATCH(slopesOf)(brightness, count, to);
        }
        between_.resize(stride());
        float* const between = between_.data() + kBorder;
        constexpr int kRead = kSlopeRows + kSmoothRows;
        for (int y = top_ + kRead; y < top_ + rows_ - kRead; ++y) {
            for (int plane = 0; plane < kPlanes; ++plane) {
                const float* rows[kSmoothed];
                for (int i = 0; i < kSmoothed; ++i) rows[i] = at(slopes_, plane, y + i - kSmoothRows);
                HWY_DYNAMIC_DISPATCH(smoothDown)(rows, count, between);
                widen(between);
                HWY_DYNAMIC_DISPATCH(smoothAcross)(between, count, at(edges_, plane, y));
                widen(at(edges_, plane, y));
            }
        }
    }

    int width_ = 0, top_ = 0, rows_ = 0;
    // By row, of each row by plane.
    std::vector<float> channels_;
    std::vector<float> slopes_; ///< products of the slopes of brightness: xx, yy, xy
    std::vector<float> edges_;  ///< those, smoothed: the structure tensor
    std::vector<float> between_;
};

/// Pixels that become large are mixed more, or each would be seen for itself; others would be blurred by it.
float evenFor(float scale) {
    constexpr float kSoft = 0.7F, kCrisp = 2.5F, kLarge = 2;
    return kSoft + (kCrisp - kSoft) * std::clamp(kLarge - scale, 0.0F, 1.0F);
}

/// One thread's copies of rows of the small image: each of their pixels where the large image needs it.
class SpreadRows {
  public:
    static constexpr std::size_t kLength = UpsampledRow::kPixels + kRoomOfVector;

    SpreadRows()
        : taps_(kTaps * kTaps * kPlanes * kLength), edges_(2 * kPlanes * kLength), to_(kPlanes * kLength),
          across_(kLength), columns_(kLength) {}

    void beginColumns(int first, int last, UpsamplingScale scale) {
        even_ = evenFor(std::min(scale.across, scale.down));
        pixels_ = static_cast<std::size_t>(last - first);
        for (std::size_t i = 0; i < pixels_; ++i) {
            const Around around(first + static_cast<int>(i), scale.across);
            across_[i] = around.beyond;
            columns_[i] = around.second;
        }
        std::fill(columns_.begin() + static_cast<std::ptrdiff_t>(pixels_), columns_.end(),
                  0); // read by whole vectors
        heldTaps_.fill(kNone);
        heldEdges_.fill(kNone);
    }

    void show(const Around& rows, SmallRows& small) {
        UpsampledRow row{};
        for (int j = 0; j < kTaps; ++j) {
            const int y = rows.second + j - 1;
            holdTaps(y, small.channels(y));
            for (int i = 0; i < kTaps; ++i) {
                for (int plane = 0; plane < kPlanes; ++plane) row.taps[j][i][plane] = tapsAt(y, i, plane);
            }
        }
        for (int j = 0; j < 2; ++j) {
            const int y = rows.second + j;
            holdEdges(y, small.edges(y));
            for (int plane = 0; plane < kPlanes; ++plane) row.edges[j][plane] = edgesAt(y, plane);
        }
        row.across = across_.data();
        row.even = even_;
        row.down = rows.beyond;
        row.pixels = pixels_;
        std::ranges::copy(shown(), row.to);
        HWY_DYNAMIC_DISPATCH(upsampleRow)(row);
    }

    using Shown = std::array<float*, kPlanes>; ///< with room for whole vectors
    Shown shown() { return {&to_[0], &to_[kLength], &to_[2 * kLength]}; }

  private:
    using Planes = SmallRows::Row;
    static constexpr int kNone = -1000;

    static std::size_t slot(int y, int of) {
        return static_cast<std::size_t>(y + kTaps) % static_cast<std::size_t>(of);
    }
    float* tapsAt(int y, int column, int plane) {
        const std::size_t i = (slot(y, kTaps) * kTaps + static_cast<std::size_t>(column)) * kPlanes;
        return &taps_[(i + static_cast<std::size_t>(plane)) * kLength];
    }
    float* edgesAt(int y, int plane) {
        return &edges_[(slot(y, 2) * kPlanes + static_cast<std::size_t>(plane)) * kLength];
    }

    void holdTaps(int y, const Planes& from) {
        int& held = heldTaps_[slot(y, kTaps)];
        if (held == y) return;
        held = y;
        for (int column = 0; column < kTaps; ++column) {
            for (int plane = 0; plane < kPlanes; ++plane) {
                const float* const values = from[static_cast<std::size_t>(plane)] + column - 1;
                HWY_DYNAMIC_DISPATCH(spreadRow)
                (values, columns_.data(), pixels_, tapsAt(y, column, plane));
            }
        }
    }
    void holdEdges(int y, const Planes& from) {
        int& held = heldEdges_[slot(y, 2)];
        if (held == y) return;
        held = y;
        for (int plane = 0; plane < kPlanes; ++plane) {
            HWY_DYNAMIC_DISPATCH(mixRow)
            (from[static_cast<std::size_t>(plane)], columns_.data(), across_.data(), pixels_,
             edgesAt(y, plane));
        }
    }

    std::vector<float> taps_, edges_, to_, across_;
    std::vector<std::int32_t> columns_; ///< Around::second of each pixel
    std::size_t pixels_ = 0;
    float even_ = 0;
    std::array<int, kTaps> heldTaps_{};
    std::array<int, 2> heldEdges_{};
};

/// Pixels of the small image by pixelAt(x, y), of the large one by put(x, y, count, planes), in rows.
template <typename PixelAt, typename Put>
void upsamplePixels(int smallWidth, int smallHeight, PixelAt&& pixelAt, int width, int height,
                    UpsamplingScale scale, int threads, Put&& put) {
    constexpr auto kColumns = static_cast<int>(UpsampledRow::kPixels);
    struct Rows {
        SmallRows small;
        SpreadRows spread;
    };
    std::vector<Rows> ofThreads(static_cast<std::size_t>(threads));
    forEachRows(height, kRowsOfPart, threads, [&](int top, int bottom) {
        auto& [small, spread] = ofThreads[static_cast<std::size_t>(threadNumber())];
        small.take(smallWidth, smallHeight, Around(top, scale.down).second,
                   Around(bottom - 1, scale.down).second, pixelAt);
        for (int left = 0; left < width; left += kColumns) {
            const int right = std::min(left + kColumns, width);
            spread.beginColumns(left, right, scale);
            for (int y = top; y < bottom; ++y) {
                spread.show(Around(y, scale.down), small);
                put(left, y, right - left, spread.shown());
            }
        }
    });
}

UpsamplingScale scaleOf(int smallWidth, int smallHeight, int width, int height) {
    return {static_cast<float>(width) / static_cast<float>(smallWidth),
            static_cast<float>(height) / static_cast<float>(smallHeight)};
}

BytePixels<const std::uint8_t> bytesOf(const LdrImage& image) {
    return {&image.pixels.front().r, image.width, image.height,
            static_cast<std::ptrdiff_t>(sizeof(Rgba8)) * image.width};
}
BytePixels<std::uint8_t> bytesOf(LdrImage& image) {
    return {&image.pixels.front().r, image.width, image.height,
            static_cast<std::ptrdiff_t>(sizeof(Rgba8)) * image.width};
}

void upsampleBytes(BytePixels<const std::uint8_t> small, UpsamplingScale scale, int threads,
                   BytePixels<std::uint8_t> image) {
    constexpr std::ptrdiff_t kBytes = 4;
    const auto pixelAt = [&](int x, int y) {
        const std::uint8_t* const from = small.first + y * small.stride + x * kBytes;
        return Pixel{static_cast<float>(from[0]), static_cast<float>(from[1]), static_cast<float>(from[2])};
    };
    const auto put = [&](int x, int y, int count, const SpreadRows::Shown& codes) {
        std::array<std::uint32_t, SpreadRows::kLength> pixels;
        const auto length = static_cast<std::size_t>(count);
        HWY_DYNAMIC_DISPATCH(packRow)(codes.data(), length, pixels.data());
        std::memcpy(image.first + y * image.stride + x * kBytes, pixels.data(), length * sizeof(pixels[0]));
    };
    upsamplePixels(small.width, small.height, pixelAt, image.width, image.height, scale, threadsFor(threads),
                   put);
}

} // namespace

void upsample(BytePixels<const std::uint8_t> small, int threads, BytePixels<std::uint8_t> image) {
    upsampleBytes(small, scaleOf(small.width, small.height, image.width, image.height), threads, image);
}

void upsample(const LdrImage& small, int threads, LdrImage& image) {
    upsample(bytesOf(small), threads, bytesOf(image));
}

void upsample(const LdrImage& small, UpsamplingScale scale, int threads, LdrImage& image) {
    upsampleBytes(bytesOf(small), scale, threads, bytesOf(image));
}

void upsample(const HdrImage& small, int threads, HdrImage& image) {
    constexpr float kMaxCode = 254.99F;          // of 255, which would be endlessly bright
    constexpr float kMin = 1e-20F, kMax = 1e20F; // one pixel decides nothing about the others
    const auto within = [](float light) { return std::fmin(std::fmax(light, 0.0F), kMax); }; // not of NaN
    double logs = 0;
    for (const Colour& pixel : small.pixels)
        logs += std::log2(static_cast<double>(within(luminance(pixel)) + kMin));
    const auto middle = static_cast<float>(std::exp2(logs / static_cast<double>(small.pixels.size())));
    const auto coded = [&](float light) {
        const float finite = within(light);
        return std::min(255 * (finite / (finite + middle)), kMaxCode);
    };
    const auto decoded = [&](float code) { return middle * code / (255 - code); };
    const auto pixelAt = [&](int x, int y) {
        const Colour& pixel = small.at(x, y);
        return Pixel{coded(pixel.r), coded(pixel.g), coded(pixel.b)};
    };
    const auto put = [&](int x, int y, int count, const SpreadRows::Shown& codes) {
        for (int i = 0; i < count; ++i)
            image.at(x + i, y) = {decoded(codes[0][i]), decoded(codes[1][i]), decoded(codes[2][i])};
    };
    upsamplePixels(small.width, small.height, pixelAt, image.width, image.height,
                   scaleOf(small.width, small.height, image.width, image.height), threadsFor(threads), put);
}

} // namespace rtcore
#endif

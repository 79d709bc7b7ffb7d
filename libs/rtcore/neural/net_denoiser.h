/// Radiance without the noise of few samples, by a trained net.
#pragma once

#include "rtcore/neural/transfer.h"
#include "rtcore/neural/u_net.h"

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

namespace rtcore {

/// An image with noise, and what is known of its surfaces.
struct NoisyImage {
    int width = 0, height = 0;
    PixelPlane radiance; ///< linear, as bright as it may be
    PixelPlane albedo;   ///< 0 to 1; for nets with 6 or 9 inputs
    PixelPlane normal;   ///< -1 to 1, shorter than 1 at edges, 0 of the background; for nets with 9 inputs
};

/// The part of a longer work that a run is, and where it is told how far that is; null: nowhere.
struct NetProgress {
    std::atomic<float>* fraction = nullptr;
    float begin = 0, end = 1;
};

/// Runs a net over images: whole ones, or tiles of larger ones, with the same bits. Keeps its memory. Not for
/// several threads at once: it uses `threads` itself, and gives the same bits for any number of them. What is
/// no number in the image counts as 0 there.
class NetDenoiser {
  public:
    /// `maxPixels`: of a tile, with what it overlaps; 0: as many as take less than kMaxBytes.
    explicit NetDenoiser(std::shared_ptr<const UNet> net, std::size_t maxPixels = 0);

    const UNet& net() const { return run_.net(); }
    /// Three floats a pixel into `result`, which may be the image's own radiance only where the image is one
    /// tile. False: `stop` was set, and the result is undefined.
    bool run(const NoisyImage& image, float* result, int threads = 0, const std::atomic<bool>* stop = nullptr,
             const NetProgress& progress = {});
    /// Bytes that it keeps now: by trained nets at most kMaxBytes, whatever the size of images.
    std::size_t bytes() const;

    static constexpr std::size_t kMaxBytes = 600'000'000;

  private:
    struct Tile;
    void readPixels(const NoisyImage& image, const Tile& tile, int y, int left, int count,
                    float* pixels) const;
    void writePixels(const NoisyImage& image, const Tile& tile, int y, int left, int count,
                     const float* pixels, float* result) const;

    UNetRun run_;
    std::size_t maxPixels_;
    float scale_ = 1;
};

} // namespace rtcore

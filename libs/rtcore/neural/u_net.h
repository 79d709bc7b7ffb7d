/// The U-Net of Intel Open Image Denoise (OIDN) with its trained weights (Afra; after Ronneberger, Fischer
/// and Brox 2015): 3 x 3 convolutions on five sizes, each half of the one before.
#pragma once

#include "rtcore/neural/bands.h"
#include "rtcore/neural/convolution.h"
#include "rtcore/neural/tensor_archive.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rtcore {

/// A net as it was read; any number of runs may share it.
class UNet {
  public:
    static constexpr int kSizes = 5;
    static constexpr int kSideStep = 16; ///< sides of images are multiples of it

    /// `file` is for messages. Throws FileError (BadData) where layers are missing or do not fit together.
    UNet(const TensorArchive& archive, const std::string& file);

    int inputs() const { return inputs_; } ///< channels of a pixel: 3, 6 or 9
    bool large() const { return large_; }  ///< two convolutions on each size on the way down, too
    /// Pixels beyond which nothing changes an output, as whole images have it: what tiles must overlap, and a
    /// multiple of kSideStep.
    int reach() const { return large_ ? 192 : 160; }

  private:
    friend class UNetRun;

    /// Layers of one size, one behind the other.
    struct Pass {
        int size = 0; ///< index: 0 is the image's
        bool up =
            false; ///< the first layer has the pass before, upsampled, and the same size of the way down
        std::vector<ConvolutionWeights> layers;
    };
    std::vector<Pass> passes_;
    int inputs_ = 0;
    bool large_ = false;
};

/// Runs a net; keeps its memory. Not for several threads at once: it uses `threads` itself, and gives the
/// same bits for any number of them.
class UNetRun {
  public:
    /// Parts of rows of the input and the output: `count` pixels from column `left` on, each in kStride
    /// floats. Called by many threads, in any order; they do not throw.
    struct Rows {
        /// Writes all kStride floats, net().inputs() of which count. Called twice for each pixel.
        std::function<void(int y, int left, int count, float* pixels)> read;
        /// The first 3 floats are the result, not below 0.
        std::function<void(int y, int left, int count, const float* pixels)> write;
    };
    static constexpr int kStride = kChannelStep;

    explicit UNetRun(std::shared_ptr<const UNet> net);

    const UNet& net() const { return *net_; }
    /// `width` and `height` are multiples of UNet::kSideStep. False: `stop` was set, and rows may be missing.
    bool run(int width, int height, const Rows& rows, int threads = 0,
             const std::atomic<bool>* stop = nullptr);
    /// Bytes that it keeps now.
    std::size_t bytes() const;

  private:
    FeaturePlane planeOf(std::vector<float>& values, int size, int channels, int rows) const;
    FeaturePlane ringOf(std::size_t index, int size, int channels);
    BandStage readStage(const FeaturePlane& into, const Rows& rows) const;
    BandStage writeStage(const FeaturePlane& from, const Rows& rows) const;
    bool runPass(const UNet::Pass& pass, const Rows& rows, const std::atomic<bool>* stop);

    std::shared_ptr<const UNet> net_;
    int width_ = 0, height_ = 0, threads_ = 0;
    FeaturePlane before_;             ///< the result of the last pass
    FeaturePlane kept_[UNet::kSizes]; ///< results of the way down, by their size; not [0]
    std::vector<float> keptValues_[UNet::kSizes], passedValues_[2];
    std::vector<std::vector<float>> rings_; ///< between the layers of a pass
    BandScratch scratch_;
};

} // namespace rtcore

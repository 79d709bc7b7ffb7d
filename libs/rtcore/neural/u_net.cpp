#include "rtcore/neural/u_net.h"

#include "rtcore/platform/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

/// On small images all layers are direct: squares of Winograd's algorithm round by all of their 36 inputs, so
/// that with them on all sizes the reach of an output would be twice as large, and so would be what tiles
/// overlap.
constexpr int kFirstDirectSize = 3;

/// Takes layers out of an archive, and sees that each fits the one before.
class LayerReader {
  public:
    LayerReader(const TensorArchive& archive, const std::string& file) : archive_(archive), file_(file) {}

    [[noreturn]] void fail(const Sentence& why) const { throw FileError(FailureKind::BadData, file_, why); }
    bool has(const std::string& layer) const { return archive_.contains(layer + ".weight"); }
    int inputsOf(const std::string& layer) const { return static_cast<int>(weights(layer).sides[1]); }

    /// A layer whose inputs are `first` channels of one source and `second` of another.
    ConvolutionWeights read(const std::string& layer, int size, int first, int second, bool upsampled) const {
        const Tensor& oihw = weights(layer);
        const auto bias = archive_.find(layer + ".bias");
        if (bias == archive_.end() || bias->second.sides != std::vector{oihw.sides[0]})
            fail(say("the layer {0} has no bias for each output", layer));
        if (inputsOf(layer) != first + second)
            fail(say("the layer {0} has {1} inputs, not {2}", layer, inputsOf(layer), first + second));
        ConvolutionWeights made;
        made.inputs = first + second;
        made.outputs = static_cast<int>(oihw.sides[0]);
        made.firstInputs = first;
        made.upsampled = upsampled;
        made.direct = size >= kFirstDirectSize;
        arrangeWeights(made, oihw.values, bias->second.values);
        return made;
    }

  private:
    const Tensor& weights(const std::string& layer) const {
        const auto found = archive_.find(layer + ".weight");
        if (found == archive_.end()) fail(say("the layer {0} is missing", layer));
        const std::vector<std::uint32_t>& sides = found->second.sides;
        if (sides.size() != 4 || sides[2] != 3 || sides[3] != 3)
            fail(say("the layer {0} is no convolution of 3 x 3", layer));
        return found->second;
    }

    const TensorArchive& archive_;
    const std::string& file_;
};

/// The names of the layers of a size, on the way down (and at the lowest one) or up.
std::vector<std::string> namesDown(int size, bool large) {
    if (size == UNet::kSizes - 1) return {"enc_conv5a", "enc_conv5b"};
    if (large) return {fmt::format("enc_conv{}a", size + 1), fmt::format("enc_conv{}b", size + 1)};
    if (size == 0) return {"enc_conv0", "enc_conv1"};
    return {fmt::format("enc_conv{}", size + 1)};
}
std::vector<std::string> namesUp(int size, bool large) {
    std::vector<std::string> names{fmt::format("dec_conv{}a", size + 1),
                                   fmt::format("dec_conv{}b", size + 1)};
    if (size == 0) names.emplace_back(large ? "dec_conv1c" : "dec_conv0");
    return names;
}

std::size_t floatsOf(const FeaturePlane& plane) {
    return static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.rows) *
           static_cast<std::size_t>(plane.stride);
}

} // namespace

UNet::UNet(const TensorArchive& archive, const std::string& file) {
    const LayerReader reader(archive, file);
    large_ = reader.has("enc_conv1b");
    inputs_ = reader.inputsOf(large_ ? "enc_conv1a" : "enc_conv0");
    if (inputs_ != 3 && inputs_ != 6 && inputs_ != 9)
        reader.fail(say("a net with {0} inputs; known are 3 (radiance), 6 (with albedo) and 9 (with normals)",
                        inputs_));
    int channels = inputs_;
    int kept[kSizes] = {inputs_};
    const auto add = [&](int size, const std::vector<std::string>& names, bool up) {
        Pass pass;
        pass.size = size;
        pass.up = up;
        for (const std::string& name : names) {
            const bool joined = up && pass.layers.empty();
            pass.layers.push_back(reader.read(name, size, channels, joined ? kept[size] : 0, joined));
            channels = pass.layers.back().outputs;
        }
        passes_.push_back(std::move(pass));
    };
    for (int size = 0; size < kSizes; ++size) {
        add(size, namesDown(size, large_), false);
        if (size + 1 < kSizes) kept[size + 1] = channels;
    }
    for (int size = kSizes - 1; size-- > 0;) add(size, namesUp(size, large_), true);
    if (channels != 3) reader.fail(say("the net has {0} outputs, not 3", channels));
}

UNetRun::UNetRun(std::shared_ptr<const UNet> net) : net_(std::move(net)) {}

FeaturePlane UNetRun::planeOf(std::vector<float>& values, int size, int channels, int rows) const {
    FeaturePlane plane;
    plane.width = width_ >> size;
    plane.height = height_ >> size;
    plane.stride = paddedChannels(channels);
    plane.rows = std::min(rows, plane.height);
    if (values.size() < floatsOf(plane)) values.resize(floatsOf(plane));
    plane.values = values.data();
    return plane;
}

FeaturePlane UNetRun::ringOf(std::size_t index, int size, int channels) {
    if (rings_.size() <= index) rings_.resize(index + 1);
    return planeOf(rings_[index], size, channels, keptRows(rowsOfBand(threads_)));
}

BandStage UNetRun::readStage(const FeaturePlane& into, const Rows& rows) const {
    return {(height_ + 3) / 4, (width_ + 3) / 4, [into, &rows](int row, int column, int squares, float*) {
                const int left = 4 * column, count = std::min(4 * squares, into.width - left);
                for (int y = 4 * row; y < std::min(4 * row + 4, into.height); ++y)
                    rows.read(y, left, count, into.row(y) + static_cast<std::size_t>(left) * kStride);
            }};
}

BandStage UNetRun::writeStage(const FeaturePlane& from, const Rows& rows) const {
    return {(height_ + 3) / 4, (width_ + 3) / 4, [from, &rows](int row, int column, int squares, float*) {
                const int left = 4 * column, count = std::min(4 * squares, from.width - left);
                for (int y = 4 * row; y < std::min(4 * row + 4, from.height); ++y)
                    rows.write(y, left, count, from.row(y) + static_cast<std::size_t>(left) * kStride);
            }};
}

bool UNetRun::runPass(const UNet::Pass& pass, const Rows& rows, const std::atomic<bool>* stop) {
    const int size = pass.size;
    const bool whole = size == 0;                            // the input is read, the output written
    const bool pooled = !pass.up && size + 1 < UNet::kSizes; // and kept
    std::vector<BandStage> stages;
    std::size_t ring = 0, scratch = 0;
    FeaturePlane from = before_, beside = pass.up && !whole ? kept_[size] : FeaturePlane();
    if (whole) {
        FeaturePlane& input = pass.up ? beside : from;
        input = ringOf(ring++, 0, net_->inputs());
        stages.push_back(readStage(input, rows));
    }
    for (const ConvolutionWeights& weights : pass.layers) {
        const bool last = &weights == &pass.layers.back();
        Convolution layer;
        layer.weights = &weights;
        layer.sources[0] = from;
        layer.sources[1] = beside;
        layer.width = width_ >> size;
        layer.height = height_ >> size;
        layer.pool = last && pooled;
        if (!last || (whole && pass.up)) {
            layer.result = ringOf(ring++, size, weights.outputs);
        } else if (pooled) {
            layer.result = kept_[size + 1] =
                planeOf(keptValues_[size + 1], size + 1, weights.outputs, height_ >> (size + 1));
        } else {
            layer.result = planeOf(passedValues_[size % 2], size, weights.outputs, height_ >> size);
        }
        scratch = std::max(scratch, convolutionScratch(weights));
        stages.push_back({layer.squareRows(), layer.squareColumns(),
                          [layer](int row, int column, int squares, float* mine) {
                              convolve(layer, row, column, squares, mine);
                          }});
        from = layer.result;
    }
    if (whole && pass.up) stages.push_back(writeStage(from, rows));
    before_ = from;
    return runBands(stages, scratch, scratch_, threads_, stop);
}

bool UNetRun::run(int width, int height, const Rows& rows, int threads, const std::atomic<bool>* stop) {
    width_ = width;
    height_ = height;
    threads_ = threads;
    for (const UNet::Pass& pass : net_->passes_)
        if (!runPass(pass, rows, stop)) return false;
    return true;
}

std::size_t UNetRun::bytes() const {
    std::size_t floats = 0;
    for (const std::vector<float>& values : keptValues_) floats += values.size();
    for (const std::vector<float>& values : passedValues_) floats += values.size();
    for (const std::vector<float>& values : rings_) floats += values.size();
    for (const std::vector<float>& values : scratch_) floats += values.size();
    return floats * sizeof(float);
}

} // namespace rtcore

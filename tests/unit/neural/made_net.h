/// Nets with made-up weights, and what they give by their definition.
#pragma once

#include "rtcore/neural/tensor_archive.h"
#include "rtcore/neural/u_net.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace test {

/// The layers of a net with two convolutions on each size (`large`) or as few as there are, of some channels,
/// few and no round number, at most so many. Random weights, which leave values about as large as they were.
rtcore::TensorArchive madeNet(int inputs, bool large, int maxChannels = 33);

/// The bytes of such a file: numbers as halves where they all are, else in single precision.
std::vector<std::byte> archiveBytes(const rtcore::TensorArchive& archive, bool halves);

/// Rows of pixels of so many channels.
struct Features {
    int width = 0, height = 0, channels = 0;
    std::vector<double> values;

    Features(int w, int h, int c);
    double& at(int x, int y, int c);
    double at(int x, int y, int c) const;
};

/// By the definition of the net, layer by layer, in double.
Features evaluate(const rtcore::TensorArchive& archive, const Features& input);

/// Numbers from 0 to 1.
Features randomInput(int width, int height, int channels);

/// The output of a run, three numbers a pixel, or nothing where it was stopped.
std::vector<float> outputOf(const std::shared_ptr<const rtcore::UNet>& net, const Features& input,
                            int threads, const std::atomic<bool>* stop = nullptr);

} // namespace test

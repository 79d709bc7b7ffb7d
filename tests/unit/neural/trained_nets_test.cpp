// The nets whose weights scripts/fetch-nets.sh has brought; without these all is skipped.
#include "rtcore/neural/net_denoiser.h"
#include "rtcore/neural/nets.h"
#include "rtcore/neural/tensor_archive.h"
#include "rtcore/platform/files.h"

#include "made_net.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

namespace {

using rtcore::Net;
using rtcore::NetDenoiser;

constexpr int kWidth = 80, kHeight = 48;

class TrainedNets : public testing::Test {
  protected:
    void SetUp() override {
        for (const Net net : {Net::Small, Net::Base, Net::Large}) {
            const rtcore::FoundNet found = rtcore::findNet(rtcore::fileOf(net));
            if (found.file.empty()) GTEST_SKIP() << "skipped: " << found.missing.english();
        }
    }

    /// A wall that shows the same everywhere.
    std::vector<float> wall(Net net, float light) {
        const std::vector<float> radiance(kNumbers, light), albedo(kNumbers, 0.5F);
        std::vector<float> normal(kNumbers, 0), result(kNumbers, -1);
        for (std::size_t i = 2; i < kNumbers; i += 3) normal[i] = 1;
        NetDenoiser denoiser(nets.of(net));
        EXPECT_TRUE(denoiser.run({kWidth, kHeight, {radiance.data()}, {albedo.data()}, {normal.data()}},
                                 result.data(), 1));
        return result;
    }

    static constexpr std::size_t kNumbers = std::size_t{3} * kWidth * kHeight;
    rtcore::Nets nets;
};

/// Shades with noise on surfaces whose albedo and normals have none, as the net gets them.
test::Features noisyShades() {
    test::Features input = test::randomInput(32, 32, 9);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            for (int c = 0; c < 9; ++c) {
                const double shade = 0.5 + 0.3 * std::sin((x + 2 * y + c) / 8.0);
                const double noise = c < 3 ? 0.3 * (input.at(x, y, c) - 0.5) : 0;
                input.at(x, y, c) = shade + noise;
            }
        }
    }
    return input;
}

TEST_F(TrainedNets, AreWhatTheirDefinitionSaysInDouble) {
    const test::Features input = noisyShades();
    for (const Net net : {Net::Small, Net::Base}) {
        const std::filesystem::path file = rtcore::findNet(rtcore::fileOf(net)).file;
        const test::Features expected = test::evaluate(rtcore::readTensorArchive(file), input);
        const std::vector<float> output = test::outputOf(nets.of(net), input, 1);
        ASSERT_EQ(output.size(), expected.values.size());
        double largest = 0, squares = 0;
        for (std::size_t i = 0; i < output.size(); ++i) {
            const double error = std::fabs(static_cast<double>(output[i]) - expected.values[i]);
            largest = std::max(largest, error);
            squares += error * error;
        }
        EXPECT_LT(largest, 1e-5) << rtcore::fileOf(net).name;
        EXPECT_LT(std::sqrt(squares / static_cast<double>(output.size())), 3e-7) << rtcore::fileOf(net).name;
    }
}

TEST_F(TrainedNets, KeepAnEvenImageAtAnyLevelUpToItsBorder) {
    for (const Net net : {Net::Small, Net::Base, Net::Large}) {
        for (const float light : {1e-4F, 0.01F, 1.0F, 100.0F, 1e4F}) {
            const std::vector<float> result = wall(net, light);
            const auto [darkest, brightest] = std::ranges::minmax_element(result);
            EXPECT_GT(*darkest, 0.994F * light) << rtcore::fileOf(net).name;
            EXPECT_LT(*brightest, 1.006F * light) << rtcore::fileOf(net).name;
        }
    }
}

TEST_F(TrainedNets, LeaveBlackBlack) {
    for (const float value : wall(Net::Base, 0)) ASSERT_EQ(value, 0);
}

} // namespace

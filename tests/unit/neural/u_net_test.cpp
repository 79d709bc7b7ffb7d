#include "rtcore/neural/u_net.h"

#include "made_net.h"

#include "rtcore/platform/error.h"
#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

using rtcore::TensorArchive;
using rtcore::UNet;
using rtcore::UNetRun;
using test::Features;
using test::madeNet;

Features randomInput(int width, int height, int channels) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> number(0, 1);
    Features input(width, height, channels);
    for (double& value : input.values) value = static_cast<double>(number(random));
    return input;
}

/// The output of a run, or nothing where it was stopped.
std::vector<float> outputOf(const std::shared_ptr<const UNet>& net, const Features& input, int threads,
                            const std::atomic<bool>* stop = nullptr) {
    std::vector<float> output(static_cast<std::size_t>(input.width * input.height * 3), -1);
    const UNetRun::Rows rows{
        [&](int y, int left, int count, float* pixels) {
            for (int i = 0; i < count; ++i)
                for (int c = 0; c < UNetRun::kStride; ++c)
                    pixels[i * UNetRun::kStride + c] =
                        c < input.channels ? static_cast<float>(input.at(left + i, y, c)) : 0;
        },
        [&](int y, int left, int count, const float* pixels) {
            for (int i = 0; i < count; ++i)
                for (int c = 0; c < 3; ++c)
                    output[static_cast<std::size_t>((y * input.width + left + i) * 3 + c)] =
                        pixels[i * UNetRun::kStride + c];
        }};
    const bool done = UNetRun(net).run(input.width, input.height, rows, threads, stop);
    return done ? output : std::vector<float>();
}

std::shared_ptr<const UNet> netOf(const TensorArchive& archive) {
    return std::make_shared<const UNet>(archive, "made.tza");
}

TEST(UNet, IsWhatItsDefinitionSays) {
    for (const bool large : {false, true}) {
        for (const int inputs : {3, 6, 9}) {
            const TensorArchive archive = madeNet(inputs, large);
            for (const auto& [width, height] : {std::pair{112, 16}, {16, 48}}) { // a block is 96 wide
                const Features input = randomInput(width, height, inputs);
                const Features expected = test::evaluate(archive, input);
                const std::vector<float> output = outputOf(netOf(archive), input, 1);
                double largest = 0;
                for (std::size_t i = 0; i < output.size(); ++i)
                    largest =
                        std::max(largest, std::fabs(static_cast<double>(output[i]) - expected.values[i]));
                EXPECT_LT(largest, 1e-5) << inputs << " inputs, " << width << " x " << height;
            }
        }
    }
}

class UNetBits : public testing::Test {
  protected:
    ~UNetBits() override { rtcore::useInstructionSet("auto"); }
};

TEST_F(UNetBits, AreTheSameForThreadsAndInstructionSets) {
    for (const bool large : {false, true}) {
        const std::shared_ptr<const UNet> net = netOf(madeNet(9, large));
        const Features input = randomInput(112, 96, 9);
        rtcore::useInstructionSet("auto");
        const std::vector<float> expected = outputOf(net, input, 1);
        for (const int threads : {2, 3, 8}) EXPECT_EQ(outputOf(net, input, threads), expected) << threads;
        for (const std::string& name : rtcore::instructionSets()) {
            ASSERT_TRUE(rtcore::useInstructionSet(name));
            EXPECT_EQ(outputOf(net, input, 1), expected) << name;
        }
    }
}

TEST(UNet, KeepsItsMemory) {
    const std::shared_ptr<const UNet> net = netOf(madeNet(3, false));
    UNetRun run(net);
    const UNetRun::Rows rows{[](int, int, int count, float* pixels) {
                                 std::fill(pixels, pixels + count * UNetRun::kStride, 0.0F);
                             },
                             [](int, int, int, const float*) {}};
    run.run(320, 160, rows, 1);
    const std::size_t bytes = run.bytes();
    run.run(160, 160, rows, 1);
    run.run(320, 160, rows, 1);
    EXPECT_EQ(run.bytes(), bytes);
}

TEST(UNet, StopsSoon) {
    const std::atomic<bool> stop = true;
    EXPECT_TRUE(outputOf(netOf(madeNet(3, false)), randomInput(160, 160, 3), 2, &stop).empty());
}

TEST(UNet, OfLayersThatDoNotFitIsRefused) {
    const TensorArchive good = madeNet(9, false);
    const auto refused = [](const TensorArchive& archive) {
        try {
            const UNet net(archive, "made.tza");
        } catch (const rtcore::FileError& error) {
            EXPECT_EQ(std::string(error.what()).find("made.tza: "), 0U) << error.what();
            return error.kind == rtcore::FailureKind::BadData;
        }
        return false;
    };
    EXPECT_FALSE(refused(good));
    for (const auto& [name, tensor] : good) {
        TensorArchive without = good;
        without.erase(name);
        EXPECT_TRUE(refused(without)) << name << " is missing";
        TensorArchive other = good;
        ++other[name].sides[0];
        other[name].values.resize(other[name].values.size() + tensor.values.size() / tensor.sides[0]);
        EXPECT_TRUE(refused(other)) << name << " has one output more";
    }
    EXPECT_TRUE(refused({}));
}

} // namespace

#include "rtcore/neural/u_net.h"

#include "made_net.h"

#include "rtcore/platform/error.h"
#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
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
using test::outputOf;
using test::randomInput;

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

/// RT_MUTATIONS: how many archives. Damage is done where all but numbers is, and to numbers.
TEST(UNet, OfMutatedArchivesRunsOrIsRefused) {
    const char* const asked = std::getenv("RT_MUTATIONS");
    const int count = asked != nullptr ? std::atoi(asked) : 200;
    const std::vector<std::byte> good = test::archiveBytes(madeNet(9, false, 4), true);
    std::uint64_t table = 0;
    std::memcpy(&table, &good[4], sizeof table);
    const Features input = randomInput(16, 16, 9);
    std::mt19937 random(8);
    for (int i = 0; i < count; ++i) {
        std::vector<std::byte> bytes = good;
        for (auto changes = random() % 3 + 1; changes-- > 0;) {
            const std::size_t from = random() % 4 == 0 ? 0 : table;
            bytes[from + random() % (bytes.size() - from)] = static_cast<std::byte>(random());
        }
        try {
            const auto net =
                std::make_shared<const UNet>(rtcore::parseTensorArchive(bytes, "x.tza"), "x.tza");
            EXPECT_EQ(outputOf(net, input, 1).size(), std::size_t{16} * 16 * 3);
        } catch (const rtcore::FileError& error) {
            EXPECT_EQ(error.kind, rtcore::FailureKind::BadData);
        }
    }
}

} // namespace

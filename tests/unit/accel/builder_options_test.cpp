#include "rtcore/accel/builder.h"
#include "rtcore/accel/fast_builder.h"
#include "rtcore/accel/statistics.h"
#include "rtcore/accel/validation.h"
#include "rtcore/simd/instruction_set.h"
#include "support/sample_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

using rtcore::BuildMethod;
using rtcore::BuildOptions;
using rtcore::KdNode;
using rtcore::KdTree;
using rtcore::Mesh;

namespace {

bool sameBits(const KdTree& a, const KdTree& b) {
    const auto sameNode = [](const KdNode& x, const KdNode& y) {
        return x.firstReference == y.firstReference && x.bits == y.bits;
    };
    return a.bounds == b.bounds && std::ranges::equal(a.nodes, b.nodes, sameNode) &&
           std::ranges::equal(a.references, b.references);
}

void expectSameTreeForAllThreads(const Mesh& mesh, BuildOptions options, std::initializer_list<int> threads) {
    options.threads = 1;
    const KdTree expected = buildKdTree(mesh, options);
    for (const int count : threads) {
        options.threads = count;
        EXPECT_TRUE(sameBits(buildKdTree(mesh, options), expected)) << count << " threads";
    }
}

/// Large enough that the work is spread over threads.
const test::SampleMesh& largeMesh() {
    static const test::SampleMesh mesh = [] {
        test::SampleMesh m = test::icosphere(5).rotate(1);
        m.append(test::soup(3000, 0.1F, 2));
        m.append(test::sheet(30, 0, 0.25F));
        return m;
    }();
    return mesh;
}

} // namespace

TEST(BuilderThreads, ExactTreesAreTheSameForAnyNumber) {
    for (int lookAhead = 0; lookAhead <= 3; ++lookAhead) {
        BuildOptions options;
        options.lookAhead = lookAhead;
        expectSameTreeForAllThreads(largeMesh().view(), options, {1, 2, 3, 7});
    }
}

TEST(BuilderThreads, FastTreesAreTheSameForAnyNumber) {
    for (int quality = 1; quality <= 10; ++quality) {
        BuildOptions options;
        options.method = BuildMethod::Fast;
        options.fastQuality = quality;
        options.lookAhead = quality % 4;
        expectSameTreeForAllThreads(largeMesh().view(), options, {2, 7});
    }
    BuildOptions options;
    options.method = BuildMethod::Fast;
    expectSameTreeForAllThreads(largeMesh().view(), options, {1, 2, 3, 7});
}

TEST(BuilderInstructionSets, AllMakeTheSameTree) {
    for (const BuildOptions& options :
         {BuildOptions{}, BuildOptions{.method = BuildMethod::Fast},
          BuildOptions{.method = BuildMethod::Fast, .fastQuality = rtcore::kQuickQuality}}) {
        const KdTree expected = buildKdTree(largeMesh().view(), options);
        for (const std::string& name : rtcore::instructionSets()) {
            ASSERT_TRUE(rtcore::useInstructionSet(name));
            EXPECT_TRUE(sameBits(buildKdTree(largeMesh().view(), options), expected)) << name;
        }
        ASSERT_TRUE(rtcore::useInstructionSet("auto"));
    }
}

TEST(BuilderThreads, AllCoresIsTheDefault) {
    BuildOptions options;
    expectSameTreeForAllThreads(largeMesh().view(), options, {0});
}

TEST(LookAhead, THOROUGH_OnlyLowersTheExpectedCost) {
    for (const BuildMethod method : {BuildMethod::Exact, BuildMethod::Fast}) {
        for (std::uint64_t seed = 0; seed < 6; ++seed) {
            const test::SampleMesh sample = test::soup(1500, 0.05F * static_cast<float>(1 + seed), seed);
            std::vector<double> costs;
            for (int lookAhead = 0; lookAhead <= 3; ++lookAhead) {
                BuildOptions options;
                options.method = method;
                options.lookAhead = lookAhead;
                options.intersectionCost = 1.5F;
                const KdTree tree = buildKdTree(sample.view(), options);
                EXPECT_FALSE(validateCoverage(tree, sample.view()).has_value());
                costs.push_back(computeStatistics(tree, 1, 1.5F).expectedCost);
            }
            for (std::size_t i = 1; i < costs.size(); ++i) EXPECT_LE(costs[i], costs[i - 1] * (1 + 1e-5));
            EXPECT_LT(costs[3], costs[0]);
        }
    }
}

TEST(BuilderCosts, DearerTrianglesMakeSmallerLeaves) {
    const test::SampleMesh sample = test::soup(2000, 0.1F, 4);
    double last = 1e9;
    for (const float intersectionCost : {0.1F, 0.5F, 2.0F}) {
        BuildOptions options;
        options.intersectionCost = intersectionCost;
        const KdTree tree = buildKdTree(sample.view(), options);
        const double filled = computeStatistics(tree, 1, intersectionCost).averageFilledLeaf;
        EXPECT_LT(filled, last);
        last = filled;
    }
}

TEST(FastQuality, IsClampedAndGrows) {
    constexpr int kMin = rtcore::kQuickQuality + 1;
    EXPECT_EQ(rtcore::fastOptions(-5).bins, rtcore::fastOptions(kMin).bins);
    EXPECT_EQ(rtcore::fastOptions(99).bins, rtcore::fastOptions(10).bins);
    for (int quality = kMin + 1; quality <= 10; ++quality) {
        EXPECT_GT(rtcore::fastOptions(quality).bins, rtcore::fastOptions(quality - 1).bins);
        EXPECT_GE(rtcore::fastOptions(quality).exactBelow, rtcore::fastOptions(quality - 1).exactBelow);
        EXPECT_LE(rtcore::fastOptions(quality).bins, 64U);
    }
}

TEST(BuilderCancel, StopsBeforeTheStart) {
    for (const BuildMethod method : {BuildMethod::Exact, BuildMethod::Fast}) {
        for (const int threads : {1, 2, 7}) {
            BuildOptions options;
            options.method = method;
            options.threads = threads;
            rtcore::BuildProgress progress;
            progress.cancel = true;
            EXPECT_THROW(buildKdTree(largeMesh().view(), options, nullptr, &progress),
                         rtcore::BuildCancelled);
        }
    }
}

TEST(BuilderCancel, StopsInTheMiddleAndTheNextBuildIsWhole) {
    const test::SampleMesh sample = test::icosphere(6).rotate(5);
    for (const BuildMethod method : {BuildMethod::Exact, BuildMethod::Fast}) {
        BuildOptions options;
        options.method = method;
        options.threads = 2;
        // Who cancels may come too late on a busy machine: then the build ends, and the next one is
        // cancelled.
        bool cancelled = false;
        for (int attempt = 0; attempt < 50 && !cancelled; ++attempt) {
            rtcore::BuildProgress progress;
            std::jthread user([&](const std::stop_token& over) {
                while (progress.finished == 0 && !over.stop_requested()) std::this_thread::yield();
                progress.cancel = true;
            });
            try {
                buildKdTree(sample.view(), options, nullptr, &progress);
            } catch (const rtcore::BuildCancelled&) {
                cancelled = true;
            }
            user.request_stop();
            user.join();
            if (cancelled) {
                EXPECT_LT(progress.finished, sample.triangles.size());
            }
        }
        EXPECT_TRUE(cancelled);

        rtcore::BuildProgress again;
        const KdTree tree = buildKdTree(sample.view(), options, nullptr, &again);
        EXPECT_FALSE(validateKdTree(tree, sample.triangles.size()).has_value());
        EXPECT_EQ(again.triangles, sample.triangles.size());
        EXPECT_GE(again.finished, sample.triangles.size());
    }
}

TEST(BuildTimes, AreFilled) {
    for (const BuildMethod method : {BuildMethod::Exact, BuildMethod::Fast}) {
        BuildOptions options;
        options.method = method;
        rtcore::BuildTimes times;
        buildKdTree(largeMesh().view(), options, &times);
        EXPECT_GT(times.prepare, 0);
        EXPECT_GT(times.split, 0);
        EXPECT_GT(times.emit, 0);
        EXPECT_DOUBLE_EQ(times.total(), times.prepare + times.split + times.emit);
    }
}

// The cost of rays where parts of a model are hidden, and how soon rays can be traced after hiding.
//   bench_hiding [--views FILE] [--size N] [--hidden A,B,...] MODEL...     shares of the parts: 0.1,0.5,0.9
// For each share and each kind of rays: the times by a tree whose leaves lack the hidden triangles and by the
// whole tree with a mask at the candidate, over that by a tree built anew of the rest; geometric means of the
// views, one thread, processor time. Before that, wall clock, all threads: until each of the three can trace.
#include "bench/rtbench/bench_view.h"
#include "bench/rtbench/contenders.h"
#include "bench/rtbench/race.h"
#include "bench/rtbench/ray_sets.h"
#include "rtcore/accel/visible_tree.h"
#include "support/random_numbers.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace {

using rtcore::KdRayTracer;
using rtcore::KdTree;

struct Options {
    std::vector<std::string> models;
    rtbench::ViewFile views;
    std::vector<double> fractions{0.1, 0.5, 0.9};
    int size = 512; ///< pixels of a side of the image
};

/// Wall clock.
template <typename Work>
double millisecondsOf(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The first parts of a random order, by number.
rtcore::HiddenParts hideSome(const rtcore::Model& model, double fraction) {
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(model);
    std::vector<std::size_t> order(parts.size());
    std::iota(order.begin(), order.end(), 0);
    test::Random random(7);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.index(i)]);
    std::vector<std::uint8_t> chosen(parts.size());
    const auto count = static_cast<std::size_t>(fraction * static_cast<double>(parts.size()) + 0.5);
    for (std::size_t i = 0; i < count; ++i) chosen[order[i]] = 1;
    return withParts(model, parts, chosen, true, nullptr);
}

std::vector<std::uint32_t> bitsOf(const std::vector<std::uint8_t>& hidden) {
    std::vector<std::uint32_t> bits(hidden.size() / 32 + 1);
    for (std::size_t i = 0; i < hidden.size(); ++i) bits[i / 32] |= std::uint32_t{hidden[i]} << i % 32;
    return bits;
}

/// A model without its hidden parts, by each of the three trees.
class Hiding {
  public:
    Hiding(const rtcore::LoadedScene& loaded, double fraction) : loaded_(loaded) {
        const rtcore::Mesh& mesh = loaded.scene.mesh();
        std::vector<std::uint8_t> hidden;
        const double mask = millisecondsOf(
            [&] { hidden = partTriangles(loaded.scene.model, hideSome(loaded.scene.model, fraction)); });
        const auto left = std::count(hidden.begin(), hidden.end(), 0);
        auto whole = std::make_unique<KdRayTracer>(loaded.tree, mesh, chooseLeafRecords(loaded.tree, 0));
        const double prune = millisecondsOf([&] { pruned_ = visibleTree(loaded.tree, hidden); });
        const double prunedTracer =
            addContender("pruned", [&] { return std::make_unique<KdRayTracer>(pruned_, *whole); });
        const double build =
            millisecondsOf([&] { anew_ = buildVisibleTree(mesh, hidden, loaded.tree.bounds); });
        const double anewTracer = addContender(
            "anew", [&] { return std::make_unique<KdRayTracer>(anew_, mesh, chooseLeafRecords(anew_, 0)); });
        const double bits = millisecondsOf([&] { bits_ = bitsOf(hidden); });
        whole->setFilter({bits_.data(), nullptr});
        contenders_.push_back({.name = "masked", .tracer = std::move(whole)});
        std::printf(
            "  %.0f %% of the parts hidden, %td triangles left; ready after: mask %.1f ms, pruned %.1f "
            "(tree %.1f, tracer %.1f), anew %.1f (tree %.1f, tracer %.1f)\n",
            fraction * 100, left, mask + bits, mask + prune + prunedTracer, prune, prunedTracer,
            mask + build + anewTracer, build, anewTracer);
    }

    void race(const std::vector<rtbench::BenchView>& views, int size) const {
        std::printf("    over anew, pruned / masked:");
        for (const rtbench::RayTest& test : rtbench::kRayTests) {
            double pruned = 0, masked = 0;
            int count = 0;
            for (const rtbench::BenchView& view : views) {
                const rtbench::RaySource source(loaded_.scene.mesh(), *contenders_.front().tracer, view,
                                                size);
                const rtbench::RaySet rays = source.make(test);
                if (rays.rays == 0) continue;
                const rtbench::RayFigures figures = rtbench::race(rays, contenders_, {});
                const double anew = figures.modes[0].ratio; // its time over that of the pruned one
                pruned += std::log(1 / anew);
                masked += std::log(figures.modes[1].ratio / anew);
                ++count;
            }
            if (count > 0)
                std::printf(" %s %.3f / %.3f", test.name.data(), std::exp(pruned / count),
                            std::exp(masked / count));
        }
        std::printf("\n");
        std::fflush(stdout);
    }

  private:
    template <typename Make>
    double addContender(const char* name, Make&& make) {
        rtbench::Contender contender{.name = name, .tracer = nullptr};
        const double time = millisecondsOf([&] { contender.tracer = make(); });
        contenders_.push_back(std::move(contender));
        return time;
    }

    const rtcore::LoadedScene& loaded_;
    KdTree pruned_, anew_;
    std::vector<std::uint32_t> bits_;
    std::vector<rtbench::Contender> contenders_;
};

std::vector<double> numbersOf(const std::string& list) {
    std::vector<double> numbers;
    for (std::size_t at = 0; at < list.size(); at = std::min(list.find(',', at), list.size() - 1) + 1)
        numbers.push_back(std::atof(list.c_str() + at));
    return numbers;
}

Options parse(int argc, char** argv) {
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--views" && i + 1 < argc) {
            options.views = rtbench::ViewFile(argv[++i]);
        } else if (word == "--size" && i + 1 < argc) {
            options.size = std::max(1, std::atoi(argv[++i]) / 4) * 4;
        } else if (word == "--hidden" && i + 1 < argc) {
            options.fractions = numbersOf(argv[++i]);
        } else {
            options.models.push_back(word);
        }
    }
    return options;
}

void measure(const std::string& model, const Options& options) {
    const rtcore::LoadedScene loaded = rtcore::loadScene(model);
    std::printf("%s: %zu triangles in %zu parts\n", model.c_str(), loaded.scene.mesh().triangles.size(),
                rtcore::namedParts(loaded.scene.model).size());
    std::vector<rtbench::BenchView> views = options.views.viewsOf(model);
    if (views.empty()) views.push_back(rtbench::makeView(loaded));
    for (const double fraction : options.fractions) Hiding(loaded, fraction).race(views, options.size);
}

} // namespace

int main(int argc, char** argv) {
    try {
        const Options options = parse(argc, argv);
        if (options.models.empty()) {
            std::fprintf(stderr, "bench_hiding [--views FILE] [--size N] [--hidden A,B,...] MODEL...\n");
            return 2;
        }
        for (const std::string& model : options.models) measure(model, options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_hiding: %s\n", error.what());
        return 1;
    }
    return 0;
}

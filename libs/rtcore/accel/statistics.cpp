#include "rtcore/accel/statistics.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

struct Visit {
    std::uint32_t node;
    int depth;
    Box3 cell;
};

void countAt(std::vector<std::uint64_t>& counts, std::size_t index) {
    if (index >= counts.size()) counts.resize(index + 1);
    ++counts[index];
}

} // namespace

KdStatistics computeStatistics(const KdTree& tree, float traversalCost, float intersectionCost) {
    KdStatistics s;
    s.nodes = tree.nodes.size();
    s.references = tree.references.size();
    s.bytes = tree.nodes.size_bytes() + tree.references.size_bytes();
    const double rootArea = tree.bounds.empty() ? 0 : tree.bounds.halfArea();
    double depths = 0;
    std::vector<Visit> stack{{0, 0, tree.bounds}};
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        const KdNode node = tree.nodes[visit.node];
        const double chance = rootArea > 0 ? visit.cell.halfArea() / rootArea : 1;
        if (!node.isLeaf()) {
            s.expectedCost += chance * static_cast<double>(traversalCost);
            Visit lower{node.lowerChild(), visit.depth + 1, visit.cell};
            Visit upper{node.lowerChild() + 1, visit.depth + 1, visit.cell};
            lower.cell.hi[node.axis()] = upper.cell.lo[node.axis()] = node.split;
            stack.push_back(upper);
            stack.push_back(lower);
            continue;
        }
        ++s.leaves;
        s.emptyLeaves += node.count() == 0 ? 1 : 0;
        s.largestLeaf = std::max<std::uint64_t>(s.largestLeaf, node.count());
        s.depth = std::max(s.depth, visit.depth);
        depths += visit.depth;
        s.expectedCost += chance * static_cast<double>(intersectionCost) * node.count();
        countAt(s.leavesBySize, node.count());
        countAt(s.leavesByDepth, static_cast<std::size_t>(visit.depth));
    }
    const std::uint64_t filled = s.leaves - s.emptyLeaves;
    s.averageLeafDepth = depths / static_cast<double>(s.leaves);
    s.averageFilledLeaf = filled > 0 ? static_cast<double>(s.references) / static_cast<double>(filled) : 0;
    return s;
}

std::string drawHistogram(const std::string& title, const std::vector<std::uint64_t>& counts, int bands) {
    constexpr int kBarLength = 50;
    const std::size_t values = std::max<std::size_t>(counts.size(), 1);
    const std::size_t width = (values + static_cast<std::size_t>(std::max(bands, 1)) - 1) /
                              static_cast<std::size_t>(std::max(bands, 1));
    std::vector<std::uint64_t> sums((values + width - 1) / width);
    for (std::size_t i = 0; i < counts.size(); ++i) sums[i / width] += counts[i];
    const std::uint64_t largest = std::max<std::uint64_t>(1, *std::max_element(sums.begin(), sums.end()));
    std::string text = title + "\n";
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const std::size_t from = i * width;
        const std::size_t to = std::min(values, from + width) - 1;
        const std::string range = from == to ? fmt::format("{}", from) : fmt::format("{}-{}", from, to);
        const double fraction = static_cast<double>(sums[i]) / static_cast<double>(largest);
        const auto bar = static_cast<std::size_t>(std::lround(fraction * kBarLength));
        text += fmt::format("{:>12} {:>10} {}\n", range, sums[i], std::string(bar, '#'));
    }
    return text;
}

} // namespace rtcore

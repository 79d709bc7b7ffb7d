#include "rtcore/accel/validation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

using Finding = std::optional<Sentence>;

bool contains(const Box3& cell, int axis, float split) {
    return split >= cell.lo[axis] && split <= cell.hi[axis]; // false for NaN
}

/// The walk over all nodes; each step knows which index must come next.
class StructureCheck {
  public:
    StructureCheck(const KdTree& tree, std::size_t triangleCount)
        : tree_(tree), triangleCount_(triangleCount) {}

    Finding run() {
        if (Finding problem = checkBounds()) return problem;
        Cell cell{tree_.bounds, 0, 0};
        while (true) {
            const KdNode node = tree_.nodes[cell.node];
            if (node.isLeaf()) {
                if (Finding problem = checkLeaf(cell.node, node)) return problem;
                if (pendingCount_ == 0) break;
                cell = pending_[--pendingCount_];
            } else {
                if (Finding problem = checkInner(cell, node)) return problem;
                descend(cell, node);
            }
        }
        if (nextPair_ != tree_.nodes.size()) return say("node {0} is part of no tree", nextPair_);
        if (nextReference_ != tree_.references.size()) {
            return say("reference {0} is part of no leaf", nextReference_);
        }
        return {};
    }

  private:
    struct Cell {
        Box3 box;
        std::size_t node;
        int depth;
    };

    Finding checkBounds() const {
        if (tree_.nodes.empty()) return form("it has no nodes");
        if (tree_.nodes.size() > kMaxKdNodes) return form("it has more than 2^30 nodes");
        const Box3& box = tree_.bounds;
        if (tree_.references.empty() && tree_.nodes.size() == 1 && box == Box3{}) return {};
        if (!isFinite(box.lo) || !isFinite(box.hi) || box.empty()) return form("its bounds are no box");
        return {};
    }

    Finding checkInner(const Cell& cell, KdNode node) {
        if (node.lowerChild() != nextPair_) return say("node {0} has children out of order", cell.node);
        if (tree_.nodes.size() - nextPair_ < 2)
            return say("node {0} has children behind the last node", cell.node);
        if (cell.depth >= kMaxKdDepth) return say("node {0} is too deep", cell.node);
        if (!contains(cell.box, node.axis(), node.split))
            return say("node {0} splits outside of its cell", cell.node);
        return {};
    }

    void descend(Cell& cell, KdNode node) {
        const auto [lower, upper] = Halves(cell.box, node.axis(), node.split);
        pending_[pendingCount_++] = {upper, nextPair_ + 1, cell.depth + 1};
        cell = {lower, nextPair_, cell.depth + 1};
        nextPair_ += 2;
    }

    Finding checkLeaf(std::size_t index, KdNode node) {
        if (node.firstReference != nextReference_) return say("node {0} has references out of order", index);
        if (node.count() > tree_.references.size() - nextReference_) {
            return say("node {0} has references behind the last one", index);
        }
        const auto own = tree_.references.subspan(nextReference_, node.count());
        for (std::size_t i = 1; i < own.size(); ++i) {
            if (own[i - 1] >= own[i]) return say("node {0} has references that do not ascend", index);
        }
        // They ascend: the last one is the largest.
        if (!own.empty() && own.back() >= triangleCount_) {
            return say("node {0} refers to a triangle that does not exist", index);
        }
        nextReference_ += own.size();
        return {};
    }

    const KdTree& tree_;
    std::size_t triangleCount_;
    std::size_t nextPair_ = 1;
    std::size_t nextReference_ = 0;
    std::array<Cell, kMaxKdDepth> pending_; ///< upper children; one for each level at most
    std::size_t pendingCount_ = 0;
};

using Point = std::array<double, 3>;
using Corners = std::vector<Point>;

Point pointOf(Vec3 v) { return {v.x, v.y, v.z}; }

/// Keeps the part of `polygon` where sign * p[axis] <= sign * plane (Sutherland and Hodgman 1974).
void clip(Corners& polygon, std::size_t axis, double plane, double sign, Corners& scratch) {
    scratch.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& a = polygon[i];
        const Point& b = polygon[(i + 1) % polygon.size()];
        const double da = sign * (a[axis] - plane);
        const double db = sign * (b[axis] - plane);
        if (da <= 0) scratch.push_back(a);
        if ((da < 0 && db > 0) || (da > 0 && db < 0)) {
            Point cut;
            for (std::size_t k = 0; k < 3; ++k) cut[k] = a[k] + (b[k] - a[k]) * (da / (da - db));
            cut[axis] = plane;
            scratch.push_back(cut);
        }
    }
    polygon.swap(scratch);
}

/// The walk that carries along which triangles reach into the cell.
class CoverageCheck {
  public:
    CoverageCheck(const KdTree& tree, const Mesh& mesh) : tree_(tree), mesh_(mesh) {
        double largest = 0;
        for (int a = 0; a < 3; ++a) {
            largest =
                std::fmax(largest, std::fmax(std::fabs(tree.bounds.lo[a]), std::fabs(tree.bounds.hi[a])));
        }
        tolerance_ = 1e-6 * largest;
        for (int a = 0; a < 3; ++a) {
            // A flat scene has no inside to reach into.
            const double thickness = double{tree.bounds.hi[a]} - tree.bounds.lo[a];
            inset_[static_cast<std::size_t>(a)] = thickness > 4 * tolerance_ ? tolerance_ : -tolerance_;
        }
    }

    Finding run() {
        const std::size_t triangleCount = mesh_.triangles.size();
        if (triangleCount == 0) return {};
        std::vector<std::uint32_t> all(triangleCount);
        for (std::size_t i = 0; i < triangleCount; ++i) all[i] = static_cast<std::uint32_t>(i);
        referenced_.assign(triangleCount, false);

        std::vector<Cell> pending;
        pending.push_back({0, tree_.bounds, std::move(all)});
        while (!pending.empty()) {
            const Cell cell = std::move(pending.back());
            pending.pop_back();
            const KdNode node = tree_.nodes[cell.node];
            if (node.isLeaf()) {
                if (Finding problem = checkLeaf(cell, node)) return problem;
                continue;
            }
            const auto [lower, upper] = Halves(cell.box, node.axis(), node.split);
            pending.push_back({node.lowerChild(), lower, reaching(lower, cell.triangles)});
            pending.push_back({node.lowerChild() + 1, upper, reaching(upper, cell.triangles)});
        }
        for (std::size_t i = 0; i < triangleCount; ++i) {
            if (!referenced_[i]) return say("triangle {0} is in no leaf", i);
        }
        return {};
    }

  private:
    struct Cell {
        std::uint32_t node;
        Box3 box;
        std::vector<std::uint32_t> triangles; ///< that reach into the box; ascending
    };

    std::vector<std::uint32_t> reaching(const Box3& box, const std::vector<std::uint32_t>& candidates) {
        std::vector<std::uint32_t> kept;
        for (const std::uint32_t t : candidates) {
            if (reachesInto(box, t)) kept.push_back(t);
        }
        return kept;
    }

    bool reachesInto(const Box3& box, std::uint32_t triangle) {
        polygon_.clear();
        for (int corner = 0; corner < 3; ++corner)
            polygon_.push_back(pointOf(mesh_.position(triangle, corner)));
        for (std::size_t a = 0; a < 3 && !polygon_.empty(); ++a) {
            const double lo = box.lo[static_cast<int>(a)] + inset_[a];
            const double hi = box.hi[static_cast<int>(a)] - inset_[a];
            if (lo > hi) return false; // too thin to say
            clip(polygon_, a, lo, -1, scratch_);
            clip(polygon_, a, hi, 1, scratch_);
        }
        return !polygon_.empty();
    }

    bool clearlyOutside(const Box3& box, std::uint32_t triangle) const {
        Box3 own;
        for (int corner = 0; corner < 3; ++corner) own.extend(mesh_.position(triangle, corner));
        for (int a = 0; a < 3; ++a) {
            if (own.lo[a] > box.hi[a] + tolerance_ || own.hi[a] < box.lo[a] - tolerance_) return true;
        }
        return false;
    }

    Finding checkLeaf(const Cell& cell, KdNode node) {
        const auto own = tree_.references.subspan(node.firstReference, node.count());
        for (const std::uint32_t t : own) {
            if (clearlyOutside(cell.box, t)) {
                return say("node {0} refers to triangle {1}, which lies outside of it", cell.node, t);
            }
            referenced_[t] = true;
        }
        for (const std::uint32_t t : cell.triangles) {
            if (!std::binary_search(own.begin(), own.end(), t)) {
                return say("node {0} lacks triangle {1}, which reaches into it", cell.node, t);
            }
        }
        return {};
    }

    const KdTree& tree_;
    const Mesh& mesh_;
    double tolerance_ = 0;
    std::array<double, 3> inset_{};
    std::vector<bool> referenced_;
    Corners polygon_, scratch_;
};

} // namespace

std::optional<Sentence> validateKdTree(const KdTree& tree, std::size_t triangleCount) {
    return StructureCheck(tree, triangleCount).run();
}

std::optional<Sentence> validateCoverage(const KdTree& tree, const Mesh& mesh) {
    return CoverageCheck(tree, mesh).run();
}

} // namespace rtcore

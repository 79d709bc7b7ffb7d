#include "rtcore/io/import/mesh/first_use.h"

#include "rtcore/platform/large_vector.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace rtcore {

namespace {

/// Triangles: fewer are numbered sooner than threads wake up several times on a busy machine.
constexpr std::size_t kWorthThreads = 1'000'000;
/// Together they read the triangles four times, one thread alone does once.
constexpr std::size_t kEnoughThreads = 6;
constexpr std::uint32_t kNowhere = 0xFFFFFFFFU;

std::vector<std::uint32_t> renumberedByOne(std::span<Triangle> triangles, std::size_t vertices) {
    std::vector<std::uint32_t> order, number;
    reserveLarge(number, vertices);
    number.assign(vertices, kNowhere);
    reserveLarge(order, std::min(vertices, 3 * triangles.size()));
    for (Triangle& t : triangles) {
        for (std::uint32_t& v : t.v) {
            std::uint32_t& known = number[v];
            if (known == kNowhere) {
                known = static_cast<std::uint32_t>(order.size());
                order.push_back(v);
            }
            v = known;
        }
    }
    return order;
}

class FirstUses {
  public:
    FirstUses(std::span<Triangle> triangles, std::size_t vertices)
        : triangles_(triangles), parts_(static_cast<std::size_t>(threadsFor(0))) {
        reserveLarge(first_, vertices);
        first_.assign(vertices, kNowhere);
    }

    std::vector<std::uint32_t> run() {
        forEachPart([this](std::size_t part) {
            forEachCorner(part, [this](std::uint32_t corner, std::uint32_t v) { lower(first_[v], corner); });
        });
        const std::vector<std::size_t> begins = countFirsts();
        std::vector<std::uint32_t> order, number;
        resizeLarge(order, begins.back());
        resizeLarge(number, first_.size());
        forEachPart([&](std::size_t part) {
            std::size_t next = begins[part];
            forEachCorner(part, [&](std::uint32_t corner, std::uint32_t v) {
                if (first_[v] != corner) return;
                number[v] = static_cast<std::uint32_t>(next);
                order[next++] = v;
            });
        });
        forEachPart([&](std::size_t part) {
            for (std::size_t t = begin(part); t < begin(part + 1); ++t) {
                for (std::uint32_t& v : triangles_[t].v) v = number[v];
            }
        });
        return order;
    }

  private:
    std::size_t begin(std::size_t part) const { return triangles_.size() * part / parts_; }

    template <typename Work>
    void forEachPart(const Work& work) const {
#pragma omp parallel for schedule(static, 1)
        for (std::size_t part = 0; part < parts_; ++part) work(part);
    }

    /// Calls `use` with the number and the vertex of each corner; they ascend.
    template <typename Use>
    void forEachCorner(std::size_t part, const Use& use) const {
        for (std::size_t t = begin(part); t < begin(part + 1); ++t) {
            for (std::uint32_t i = 0; i < 3; ++i)
                use(static_cast<std::uint32_t>(3 * t) + i, triangles_[t].v[i]);
        }
    }

    static void lower(std::uint32_t& value, std::uint32_t to) {
        const std::atomic_ref<std::uint32_t> shared(value);
        std::uint32_t now = shared.load(std::memory_order_relaxed);
        while (to < now && !shared.compare_exchange_weak(now, to, std::memory_order_relaxed)) {
        }
    }

    /// How many vertices the parts before each one come to first, and all.
    std::vector<std::size_t> countFirsts() const {
        std::vector<std::size_t> begins(parts_ + 1);
        forEachPart([&](std::size_t part) {
            std::size_t count = 0;
            forEachCorner(
                part, [&](std::uint32_t corner, std::uint32_t v) { count += first_[v] == corner ? 1 : 0; });
            begins[part + 1] = count;
        });
        std::partial_sum(begins.begin(), begins.end(), begins.begin());
        return begins;
    }

    std::span<Triangle> triangles_;
    std::size_t parts_;
    std::vector<std::uint32_t> first_; ///< by vertex: the first corner
};

} // namespace

std::vector<std::uint32_t> renumberByFirstUse(std::span<Triangle> triangles, std::size_t vertices) {
    const bool many =
        triangles.size() > kWorthThreads && static_cast<std::size_t>(threadsFor(0)) >= kEnoughThreads;
    return many ? FirstUses(triangles, vertices).run() : renumberedByOne(triangles, vertices);
}

} // namespace rtcore

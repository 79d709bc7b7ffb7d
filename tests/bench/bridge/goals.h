/// Figures of the bridge beside their goals.
#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <limits>
#include <optional>
#include <string>

namespace bridgebench {

/// The range in which a figure should lie.
struct Bounds {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};
constexpr Bounds atMost(double high) { return {.high = high}; }
constexpr Bounds between(double low, double high) { return {low, high}; }

/// `atLeast`: what must be reached, where the goal is more than that.
struct Goal {
    Bounds goal;
    std::optional<Bounds> atLeast = {};
};

inline std::string verdict(const char* kind, const Bounds& bounds, double measured) {
    const bool met = measured >= bounds.low && measured <= bounds.high;
    const std::string range = bounds.low > -1e300 ? fmt::format("{:.4g} to {:.4g}", bounds.low, bounds.high)
                                                  : fmt::format("{:.4g}", bounds.high);
    return fmt::format("  {} {} {}", kind, range, met ? "met" : "NOT MET");
}

inline void tell(const std::string& what, double measured, const char* unit,
                 const std::optional<Goal>& goal = {}) {
    std::string line = fmt::format("{:58} {:9.2f} {:6}", what, measured, unit);
    if (goal) line += verdict("goal", goal->goal, measured);
    if (goal && goal->atLeast) line += verdict("at least", *goal->atLeast, measured);
    fmt::print("{}\n", line);
    std::fflush(stdout);
}

inline void tellMissing(const std::string& what, const std::string& why) {
    fmt::print("{:58} {:>9}         {}\n", what, "-", why);
    std::fflush(stdout);
}

} // namespace bridgebench

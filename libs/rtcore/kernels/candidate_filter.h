/// Which triangles that a ray meets are hits: parts of a mesh can be hidden, and surfaces can have holes.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rtcore {

/// Where the triangles of a mesh have holes.
class Holes {
  public:
    virtual ~Holes() = default;
    /// Whether nothing of the triangle is at (u, v), as Hit has them. Called for each candidate, from many
    /// threads at once; the same answer for the same arguments.
    virtual bool isHole(std::uint32_t triangle, float u, float v) const = 0;
};

inline bool isBitSet(const std::uint32_t* bits, std::size_t i) { return bits[i / 32] >> i % 32 & 1U; }

/// Asked of each candidate: a triangle that a ray meets inside its interval, no further than what it has
/// found. Empty ones keep all and cost nothing.
struct CandidateFilter {
    const std::uint32_t* hidden = nullptr; ///< one bit for each triangle, 32 to a word: no ray hits it
    const Holes* holes = nullptr;

    bool empty() const { return hidden == nullptr && holes == nullptr; }
    bool hides(std::uint32_t triangle) const { return hidden != nullptr && isBitSet(hidden, triangle); }
    bool keeps(std::uint32_t triangle, float u, float v) const {
        return !hides(triangle) && (holes == nullptr || !holes->isHole(triangle, u, v));
    }
};

} // namespace rtcore

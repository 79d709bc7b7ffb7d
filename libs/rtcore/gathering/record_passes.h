/// The knowledge of irradiance records, gathered pass by pass, and the radii that follow from it.
#pragma once

#include "rtcore/gathering/emitter_rays.h"
#include "rtcore/gathering/gather_rays.h"
#include "rtcore/irradiance/irradiance_cache.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace rtcore {

/// The nearest surface that rays of a record met, and the nearest that faces elsewhere.
class NearestWalls {
  public:
    void meet(const RecordWall& wall, float distance) {
        constexpr float kElsewhere = 0.7F; // cosine
        if (distance < distances_[0]) {
            if (dot(wall.normal, walls_[0].normal) < kElsewhere) set(1, walls_[0], distances_[0]);
            set(0, wall, distance);
        } else if (distance < distances_[1] && dot(wall.normal, walls_[0].normal) < kElsewhere) {
            set(1, wall, distance);
        }
    }
    void meet(const NearestWalls& other) {
        for (std::size_t i = 0; i < 2; ++i)
            if (other.distances_[i] < kNone) meet(other.walls_[i], other.distances_[i]);
    }
    const std::array<RecordWall, 2>& walls() const { return walls_; }
    const std::array<float, 2>& distances() const { return distances_; } ///< kNone: there is none
    static NearestWalls from(const std::array<RecordWall, 2>& walls, const std::array<float, 2>& distances) {
        NearestWalls nearest;
        nearest.walls_ = walls;
        nearest.distances_ = distances;
        return nearest;
    }
    static constexpr float kNone = std::numeric_limits<float>::max();
    friend bool operator==(const NearestWalls&, const NearestWalls&) = default;

  private:
    void set(std::size_t i, const RecordWall& wall, float distance) {
        walls_[i] = wall;
        distances_[i] = distance;
    }
    std::array<RecordWall, 2> walls_;
    std::array<float, 2> distances_{kNone, kNone};
};

/// The results of a pass.
struct PassResult {
    PassLight light;
    float deviation = 0;      ///< standard deviation of what its rays tell, as a part of the irradiance
    float inverseLengths = 0; ///< sum over its rays
    NearestWalls walls;
};

/// What a record learned from its passes.
struct RecordHistory {
    Colour irradiance; ///< running means
    Vec3 vector;
    float pixel = 0; ///< size of one where it was made
    float shrink = 1;
    std::uint32_t passes = 0; ///< since light was forgotten
    std::uint32_t allPasses = 0;
    float inverseLengths = 0; ///< sum over all rays
    NearestWalls walls;
    std::uint8_t density = 0;
    std::uint32_t name = 0; ///< of its random numbers

    friend bool operator==(const RecordHistory&, const RecordHistory&) = default;
};

/// All that RecordPasses remember.
struct PassesState {
    std::vector<RecordHistory> histories; ///< by record
    std::uint32_t names = 0;              ///< of records so far

    friend bool operator==(const PassesState&, const PassesState&) = default;
};

/// One history for each record of a cache, by number.
class RecordPasses {
  public:
    void clear() {
        histories_.clear();
        names_ = 0;
    }
    PassesState state() const { return {histories_, names_}; }
    void restore(const PassesState& kept) {
        histories_ = kept.histories;
        names_ = kept.names;
    }
    std::size_t size() const { return histories_.size(); }
    std::size_t memory() const { return histories_.capacity() * sizeof(History); }

    /// Adds a record of this density to the cache, at a receiver of which that says `around`.
    std::uint32_t add(IrradianceCache& cache, const Receiver& receiver, const ArrivingLight& around,
                      int density);
    /// The next pass of a record.
    GatherPass next(const IrradianceCache& cache, std::uint32_t number) const;
    std::uint32_t passes(std::uint32_t number) const { return histories_[number].passes; }
    /// Whether it had passes before it forgot what they told of light.
    bool hasForgotten(std::uint32_t number) const {
        return histories_[number].passes < histories_[number].allPasses;
    }
    int density(std::uint32_t number) const { return histories_[number].density; }
    /// Enters the results of a pass, those of several records in a fixed order.
    void enter(IrradianceCache& cache, std::uint32_t number, const PassResult& result);
    /// Forgets the last records, which had no pass, as if they had not been added.
    void undo(std::size_t count) {
        histories_.resize(histories_.size() - count);
        names_ -= static_cast<std::uint32_t>(count);
    }
    /// As IrradianceCache::keep().
    void keep(std::span<const std::uint8_t> kept);
    /// Forgets what records know of light; they keep their positions and radii, and tell nothing until
    /// their next pass.
    void forgetLight();
    void forgetLight(std::uint32_t number) { histories_[number].passes = 0; }
    /// What it knows of light is so much more or less now, by channel, and counts as that of so many passes
    /// at most.
    void fade(IrradianceCache& cache, std::uint32_t number, std::uint32_t passes, Colour ratio);

  private:
    using History = RecordHistory;

    void learnDistance(IrradianceCache& cache, std::uint32_t number);
    void adapt(IrradianceCache& cache, std::uint32_t number, float deviation);
    void setRadius(IrradianceCache& cache, std::uint32_t number) const;

    std::vector<History> histories_;
    std::uint32_t names_ = 0;           ///< of records so far
    std::vector<std::uint32_t> around_; ///< scratch
};

} // namespace rtcore

/// A walk step by step, and its distances from obstacles: nothing may ever be inside the player.
#pragma once

#include "rtcore/motion/walker.h"
#include "support/obstacles.h"
#include "support/random_keys.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace test {

/// The state after one step.
struct WalkMoment {
    rtcore::MotionTrail trail; ///< the ends of the step's parts
    rtcore::Vec3d feet, eye;
    double height = 0;
    bool putBack = false; ///< he had fallen out of the world
};

struct WalkRecord {
    std::vector<WalkMoment> moments; ///< the first is the start
    int putBack = 0;
    int refused = 0;   ///< steps that did not happen, since no free place was found
    bool lost = false; ///< he fell out of the world for good
};

/// Ends early when the player is lost.
template <typename NextInput>
WalkRecord recordWalk(rtcore::Walker& walker, int ticks, NextInput&& nextInput) {
    WalkRecord record;
    const auto add = [&](rtcore::MotionTrail trail, bool putBack) {
        const rtcore::WalkState& now = walker.state();
        record.moments.push_back({std::move(trail), now.feet, walker.eye(), now.height, putBack});
    };
    add({}, false);
    for (int tick = 0; tick < ticks; ++tick) {
        const rtcore::Vec3d before = walker.state().feet;
        rtcore::MotionTrail trail;
        record.lost = !walker.tick(nextInput(), &trail);
        if (record.lost) break;
        const rtcore::Vec3d feet = walker.state().feet;
        constexpr double kLeap = 1; // no step is as long
        const bool putBack = length(feet - before) > kLeap;
        constexpr double kHere = 1e-9;
        if (!putBack && !trail.empty() && length(trail.back() - feet) > kHere) {
            ++record.refused;
            trail.clear();
        }
        record.putBack += putBack ? 1 : 0;
        add(std::move(trail), putBack);
    }
    return record;
}

/// The least distances from anything, and after which step they were found.
struct WalkClearance {
    double atEnds = std::numeric_limits<double>::max();   ///< of the core at the ends of all parts
    double onTheWay = std::numeric_limits<double>::max(); ///< of the core anywhere, to within 5 mm
    double ofEye = std::numeric_limits<double>::max();    ///< of what is drawn, at and between the steps
    std::size_t endsTick = 0, wayTick = 0, eyeTick = 0;
};

class WalkJudge {
  public:
    WalkJudge(const Obstacles& all, const rtcore::WalkShape& shape)
        : all_(all), reach_(shape.radius + shape.skin) {}

    /// `random` chooses the drawn frames between two steps.
    WalkClearance judge(const WalkRecord& record, Random& random) const {
        WalkClearance result;
        const Obstacles near = all_.within(boxOf(record.moments, 0, record.moments.size()));
        for (std::size_t from = 1; from < record.moments.size(); from += kTogether) {
            const std::size_t to = std::min(from + kTogether, record.moments.size());
            const Obstacles nearer = near.within(boxOf(record.moments, from - 1, to));
            for (std::size_t i = from; i < to; ++i) {
                look(nearer, record.moments[i - 1], record.moments[i], i, random, result);
            }
        }
        return result;
    }

  private:
    static constexpr std::size_t kTogether = 20;
    static constexpr double kMaxOfEye = 0.2, kError = 0.005;

    rtcore::UprightLine core(rtcore::Vec3d feet, double height) const {
        return {feet + rtcore::Vec3d{0, 0, reach_}, std::max(0.0, height - 2 * reach_)};
    }

    rtcore::Box3d boxOf(const std::vector<WalkMoment>& moments, std::size_t from, std::size_t to) const {
        rtcore::Box3d box{moments[from].feet, moments[from].feet};
        const auto extend = [&](rtcore::Vec3d p) {
            box.lo = {std::min(box.lo.x, p.x), std::min(box.lo.y, p.y), std::min(box.lo.z, p.z)};
            box.hi = {std::max(box.hi.x, p.x), std::max(box.hi.y, p.y), std::max(box.hi.z, p.z)};
        };
        for (std::size_t i = from; i < to; ++i) {
            extend(moments[i].feet);
            extend(moments[i].eye);
            for (const rtcore::Vec3d p : moments[i].trail) extend(p);
            extend(moments[i].feet + rtcore::Vec3d{0, 0, moments[i].height});
        }
        return box.grown(reach_ + kMaxOfEye);
    }

    void look(const Obstacles& near, const WalkMoment& before, const WalkMoment& now, std::size_t tick,
              Random& random, WalkClearance& result) const {
        const auto note = [tick](double clearance, double& min, std::size_t& when) {
            if (clearance >= min) return;
            min = clearance;
            when = tick;
        };
        note(near.clearance(core(now.feet, now.height), reach_), result.atEnds, result.endsTick);
        note(near.clearance({now.eye, 0}, kMaxOfEye), result.ofEye, result.eyeTick);
        if (now.putBack) return;
        // Which of the two heights a part of the step had is not known.
        const double height = std::min(before.height, now.height);
        rtcore::Vec3d from = before.feet;
        std::vector<rtcore::Vec3d> ends = now.trail;
        ends.push_back(now.feet);
        for (const rtcore::Vec3d to : ends) {
            note(near.clearance(core(to, height), reach_), result.atEnds, result.endsTick);
            note(near.clearanceOnTheWay(core(from, height), core(to, height).foot, reach_, kError),
                 result.onTheWay, result.wayTick);
            from = to;
        }
        const rtcore::Vec3d drawn = before.eye + (now.eye - before.eye) * fraction(random);
        note(near.clearance({drawn, 0}, kMaxOfEye), result.ofEye, result.eyeTick);
    }

    const Obstacles& all_;
    double reach_;
};

} // namespace test

/// The figures that rtbench measures.
#pragma once

#include "bench/rtbench/ray_test.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rtbench {

/// The best of Embree's modes, or of its robust ones.
struct Rival {
    std::string mode;
    double speed = 0; ///< Mrays/s
    double ratio = 0; ///< our speed over this
    /// Rays for which it found something else than ours.
    std::size_t differences = 0;
};

struct RayFigures {
    const RayTest* test = nullptr;
    std::size_t rays = 0;
    double speed = 0;                  ///< ours, Mrays/s
    std::optional<Rival> best, robust; ///< absent without Embree
    std::vector<Rival> modes;          ///< all of Embree's; those that dropped out by their first round
    double spread = 0; ///< second best time over best time, less 1; the largest of ours and the rivals'
};

struct FrameTimes {
    double best = 0, median = 0; ///< seconds
};

struct FrameFigures {
    std::string kind; ///< "phong" or "mirrors"
    int threads = 1;
    FrameTimes ours;
    std::optional<FrameTimes> embree;
    std::size_t pixels = 0, differentPixels = 0; ///< by more than 1 % between ours and Embree's

    double ratio() const { return embree ? embree->best / ours.best : 0; }
};

/// The memory of a tree.
struct TreeFigures {
    std::string name; ///< "ours", "Embree default"
    double bytes = 0; ///< per triangle, the mesh not counted
};

/// One view of a scene.
struct SceneFigures {
    std::string scene; ///< the stem of its file
    std::string view;  ///< may be empty
    std::size_t triangles = 0;
    std::vector<RayFigures> rays;
    std::vector<FrameFigures> frames;
    std::vector<TreeFigures> trees = {}; ///< of the races of rays

    std::string name() const { return view.empty() ? scene : scene + " " + view; }
};

} // namespace rtbench

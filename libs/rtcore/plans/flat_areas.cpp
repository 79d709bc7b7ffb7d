#include "rtcore/plans/flat_areas.h"

#include "rtcore/plans/flat_region.h"

#include <clipper.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

namespace rtcore {

namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

/// Positions as the whole numbers that Clipper reckons with.
class Grid {
  public:
    explicit Grid(std::initializer_list<const std::vector<FlatLoop>*> all) {
        FlatPoint low{1e300, 1e300}, high{-1e300, -1e300};
        for (const std::vector<FlatLoop>* loops : all) {
            for (const FlatLoop& loop : *loops) {
                for (const FlatPoint& p : loop) {
                    for (int axis = 0; axis < 2; ++axis) {
                        low[axis] = std::min(low[axis], p[axis]);
                        high[axis] = std::max(high[axis], p[axis]);
                    }
                }
            }
        }
        const double size = std::max(high[0] - low[0], high[1] - low[1]);
        if (!(size > 0)) return;
        middle_ = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2};
        cell_ = size / kCells;
    }

    double cell() const { return cell_; }
    /// Nothing of that area is on it; much larger than the grid, lengths would go beyond its numbers.
    bool isBelow(double area) const { return area > kCells * cell_ * kCells * cell_; }
    Path in(const FlatLoop& loop) const {
        Path path;
        for (const FlatPoint& p : loop)
            path.emplace_back(std::llround((p[0] - middle_[0]) / cell_),
                              std::llround((p[1] - middle_[1]) / cell_));
        return path;
    }
    Paths in(const std::vector<FlatLoop>& loops) const {
        Paths paths;
        for (const FlatLoop& loop : loops) paths.push_back(in(loop));
        return paths;
    }
    FlatLoop out(const Path& path) const {
        FlatLoop loop;
        for (const ClipperLib::IntPoint& p : path)
            loop.push_back({middle_[0] + static_cast<double>(p.X) * cell_,
                            middle_[1] + static_cast<double>(p.Y) * cell_});
        return loop;
    }

  private:
    static constexpr double kCells = 0x1p40;

    FlatPoint middle_{};
    double cell_ = 1;
};

Paths combined(ClipperLib::ClipType how, const Paths& some, const Paths& others,
               ClipperLib::PolyFillType inside = ClipperLib::pftNonZero) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(some, ClipperLib::ptSubject, true);
    clipper.AddPaths(others, ClipperLib::ptClip, true);
    Paths result;
    clipper.Execute(how, result, inside, inside);
    return result;
}

/// Larger by `by` to all sides, corners stay corners; below 0: smaller.
Paths grown(const Paths& areas, const Paths& lines, double by) {
    constexpr double kMiter = 3;
    ClipperLib::ClipperOffset offset(kMiter);
    offset.AddPaths(areas, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
    for (const Path& line : lines) {
        const bool closes = line.front() == line.back();
        offset.AddPath(line, ClipperLib::jtMiter,
                       closes ? ClipperLib::etClosedLine : ClipperLib::etOpenSquare);
    }
    Paths result;
    offset.Execute(result, by);
    return result;
}

/// An area without holes, and its holes.
struct Piece {
    Path outer;
    Paths holes;

    Paths all() const {
        Paths paths{outer};
        paths.insert(paths.end(), holes.begin(), holes.end());
        return paths;
    }
    double area() const {
        double sum = 0;
        for (const Path& path : all()) sum += ClipperLib::Area(path);
        return sum;
    }
};

/// Where it is free between obstacles, each piece by itself, those that lead outside left out.
std::vector<Piece> freePieces(const Paths& obstacles) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(obstacles, ClipperLib::ptSubject, true);
    ClipperLib::PolyTree tree;
    clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    std::vector<Piece> pieces;
    const auto visit = [&](const auto& self, const ClipperLib::PolyNode& solid) -> void {
        for (const ClipperLib::PolyNode* hole : solid.Childs) {
            Piece piece{hole->Contour, {}};
            ClipperLib::ReversePath(piece.outer);
            for (const ClipperLib::PolyNode* island : hole->Childs) {
                piece.holes.push_back(island->Contour);
                ClipperLib::ReversePath(piece.holes.back());
                self(self, *island);
            }
            pieces.push_back(std::move(piece));
        }
    };
    for (const ClipperLib::PolyNode* solid : tree.Childs) visit(visit, *solid);
    return pieces;
}

FlatRegion regionOf(const Paths& areas) {
    std::vector<FlatLoop> loops(areas.size());
    for (std::size_t i = 0; i < areas.size(); ++i)
        for (const ClipperLib::IntPoint& p : areas[i])
            loops[i].push_back({static_cast<double>(p.X), static_cast<double>(p.Y)});
    return FlatRegion(loops);
}

/// Rooms by closing wider and wider openings.
class RoomFinder {
  public:
    RoomFinder(Paths solids, Paths lines, const Openings& openings, const RoomBounds& bounds)
        : solids_(std::move(solids)), lines_(std::move(lines)), bounds_(bounds) {
        constexpr int kSteps = 12;
        constexpr double kCrack = 0.02; // of a step: what is open by less is closed
        const double step = std::max(openings.door, openings.window / kSteps) / 2 / kSteps;
        radii_.push_back(kCrack * step);
        while (radii_.size() <= kSteps) radii_.push_back(step * static_cast<double>(radii_.size()));
        parting_ = radii_.size();
        while (2 * radii_.back() < openings.window)
            radii_.push_back(step * static_cast<double>(radii_.size()));
        for (const double radius : radii_) levels_.push_back(freePieces(grown(solids_, lines_, radius)));
        obstacles_ = regionOf(grown(solids_, lines_, radii_[0]));
    }

    /// Those that are closed anyway, and those that are once openings that lead outside are.
    std::vector<Piece> rooms() const {
        std::vector<Piece> rooms;
        for (std::size_t level = 0; level < levels_.size(); ++level) {
            for (const Piece& piece : levels_[level]) {
                const bool wasClosed =
                    level > 0 && std::ranges::any_of(levels_[level - 1],
                                                     [&](const Piece& wider) { return isIn(piece, wider); });
                if (wasClosed) continue;
                for (Piece& room : roomsIn(piece, level)) rooms.push_back(std::move(room));
            }
        }
        return rooms;
    }

  private:
    /// As wide as it is up to the walls.
    std::vector<Piece> widened(const Piece& piece, std::size_t level) const {
        const Paths wide = grown(piece.all(), {}, radii_[level]);
        return freePieces(combined(ClipperLib::ctDifference, frameAround(wide),
                                   combined(ClipperLib::ctDifference, wide, solids_)));
    }

    /// So that what is free in `areas` is a hole of what is around them.
    static Paths frameAround(const Paths& areas) {
        constexpr ClipperLib::cInt kMargin = 1000;
        ClipperLib::cInt low = std::numeric_limits<ClipperLib::cInt>::max(), high = -low;
        for (const Path& path : areas) {
            for (const ClipperLib::IntPoint& p : path) {
                low = std::min({low, p.X, p.Y});
                high = std::max({high, p.X, p.Y});
            }
        }
        low -= kMargin;
        high += kMargin;
        return {{{low, low}, {high, low}, {high, high}, {low, high}}};
    }

    /// One, or those into which it falls where openings are closed.
    std::vector<Piece> roomsIn(const Piece& piece, std::size_t level) const {
        std::vector<Piece> parts;
        if (level + 1 < parting_) {
            for (const Piece& narrower : levels_[level + 1]) {
                if (!isIn(narrower, piece)) continue;
                for (Piece& room : roomsIn(narrower, level + 1)) parts.push_back(std::move(room));
            }
        }
        if (parts.size() > 1) return parts;
        std::vector<Piece> whole = widened(piece, level);
        std::erase_if(whole, [&](const Piece& room) {
            return room.area() < bounds_.area || isNarrow(room) || !isWalled(room.outer);
        });
        return whole;
    }

    bool isNarrow(const Piece& room) const { return grown(room.all(), {}, -bounds_.width / 2).empty(); }

    /// Most of its outline is at walls: what is free between posts is no room.
    bool isWalled(const Path& outline) const {
        constexpr double kWalled = 0.6;
        constexpr int kSteps = 64; // of each side
        const double beyond = radii_[0] / 2;
        double all = 0, walled = 0;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const ClipperLib::IntPoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
            const double x = static_cast<double>(b.X - a.X), y = static_cast<double>(b.Y - a.Y);
            const double length = std::hypot(x, y);
            all += length;
            for (int k = 0; k < kSteps && length > 0; ++k) {
                const double part = (k + 0.5) / kSteps;
                const FlatPoint out{static_cast<double>(a.X) + x * part + y / length * beyond,
                                    static_cast<double>(a.Y) + y * part - x / length * beyond};
                if (obstacles_.contains(out)) walled += length / kSteps;
            }
        }
        return walled >= kWalled * all;
    }

    static bool isIn(const Piece& inner, const Piece& outer) {
        const auto inside = [&](const Path& path) {
            return ClipperLib::PointInPolygon(inner.outer[0], path) != 0;
        };
        return inside(outer.outer) && std::ranges::none_of(outer.holes, [&](const Path& hole) {
                   return ClipperLib::PointInPolygon(inner.outer[0], hole) > 0;
               });
    }

    Paths solids_, lines_;
    FlatRegion obstacles_;
    RoomBounds bounds_;
    std::vector<double> radii_;
    std::size_t parting_ = 0; ///< the first of those that no longer part rooms
    std::vector<std::vector<Piece>> levels_;
};

/// The middle of the widest stretch among those of some rows.
FlatPoint labelOf(const std::vector<FlatLoop>& loops) {
    constexpr int kRows = 31;
    double low = 1e300, high = -1e300;
    for (const FlatPoint& p : loops[0]) {
        low = std::min(low, p[1]);
        high = std::max(high, p[1]);
    }
    FlatPoint best = loops[0][0];
    double widest = 0;
    for (int row = 0; row < kRows; ++row) {
        const double y = low + (high - low) * (row + 0.5) / kRows;
        std::vector<double> crossings;
        for (const FlatLoop& loop : loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const FlatPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
                if ((a[1] <= y) != (b[1] <= y))
                    crossings.push_back(a[0] + (b[0] - a[0]) * ((y - a[1]) / (b[1] - a[1])));
            }
        }
        std::ranges::sort(crossings);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            // Rows near the middle count more, so that a square has it there.
            const double off = std::fabs(2 * (row + 0.5) / kRows - 1);
            const double width = (crossings[i + 1] - crossings[i]) * (1 - 0.5 * off);
            if (width <= widest) continue;
            widest = width;
            best = {(crossings[i] + crossings[i + 1]) / 2, y};
        }
    }
    return best;
}

} // namespace

std::vector<FlatLoop> coveredBy(const std::vector<CutOutline>& outlines) {
    std::vector<FlatLoop> all;
    for (const CutOutline& outline : outlines)
        if (outline.closed) all.insert(all.end(), outline.loops.begin(), outline.loops.end());
    const Grid grid({&all});
    Paths covered;
    for (const CutOutline& outline : outlines) {
        if (!outline.closed) continue;
        const Paths one = combined(ClipperLib::ctUnion, grid.in(outline.loops), {});
        covered.insert(covered.end(), one.begin(), one.end());
    }
    std::vector<FlatLoop> loops;
    for (const Path& path : combined(ClipperLib::ctUnion, covered, {})) loops.push_back(grid.out(path));
    return loops;
}

std::vector<RoomArea> roomsBetween(const std::vector<FlatLoop>& solids, const std::vector<FlatLoop>& lines,
                                   Openings openings, RoomBounds bounds) {
    const Grid grid({&solids, &lines});
    if (grid.isBelow(bounds.area)) return {};
    const double cell = grid.cell();
    openings.door /= cell;
    openings.window /= cell;
    bounds = {bounds.area / (cell * cell), bounds.width / cell};
    std::vector<RoomArea> rooms;
    for (const Piece& piece : RoomFinder(grid.in(solids), grid.in(lines), openings, bounds).rooms()) {
        RoomArea room{grid.out(piece.outer), {}, piece.area() * cell * cell, {}};
        std::vector<FlatLoop> loops{room.outline};
        for (const Path& hole : piece.holes) loops.push_back(room.islands.emplace_back(grid.out(hole)));
        room.label = labelOf(loops);
        rooms.push_back(std::move(room));
    }
    std::ranges::stable_sort(rooms, std::greater(), &RoomArea::area);
    return rooms;
}

} // namespace rtcore

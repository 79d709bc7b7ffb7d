/// Plans, sections and elevations of a scene.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/plans/drawing.h"
#include "rtcore/scene/scene.h"
#include "rtcore/sections/closed_pieces.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rtcore {

/// From where one looks. Above: down on a horizontal cut. Front to Right: at the model from outside, not cut.
/// Section: at the scene's own section.
enum class PlanSide : std::uint8_t { Above, Front, Back, Left, Right, Section };
inline constexpr std::array<std::string_view, 6> kPlanSides{"above", "front", "back",
                                                            "left",  "right", "section"};

struct PlanChoice {
    PlanSide side = PlanSide::Above;
    /// Of Above: 1 is the lowest; nothing: the one that `eye` is in, else the lowest.
    std::optional<int> storey = {};
    double height = 1.2; ///< metres above its floor at which it is cut
    /// In place of a storey's: metres, in the coordinates of the model's file.
    std::optional<double> floor = {};
};

/// The plane of a drawing, and how it was found.
struct ChosenPlan {
    SectionPlane plane;
    std::optional<double> floor; ///< of Above: where it is, metres in the coordinates of the model's file
    std::size_t storey = 0;      ///< of so many, from 1; 0: none was found, or another floor was named
    std::size_t storeys = 0;
};

/// The front is the side that one sees looking along -z (where +z is up: along +y). Without any storey the
/// floor is the lowest point of the model. Throws Refusal for a storey that is not there, and for a section
/// of a scene that does not have just one.
ChosenPlan choosePlan(const PlanChoice& choice, const Scene& scene, const Box3& bounds,
                      std::optional<Vec3> eye);

struct PlanOptions {
    double step = 0.01;     ///< metres between points at which an edge is looked at
    double door = 1.2;      ///< metres: wider openings join rooms
    double window = 3;      ///< metres: what has wider openings to the outside is no room
    double smallest = 1;    ///< square metres of a room, at least
    double narrowest = 0.6; ///< metres: its width at its widest, at least
    bool rooms = true;
};

/// What `plane` cuts, and what is seen of the model beyond it. The scene's own sections do not count.
/// Positions are those of the model's file along the drawing's axes. The same for each number of threads.
/// `tracer` is of the scene's model without its hidden parts, `pieces` of its model. Empty once `cancel` is
/// set.
Drawing drawingOf(const Scene& scene, const RayTracer& tracer, ClosedPieces& pieces,
                  const SectionPlane& plane, const PlanOptions& options, const std::atomic<bool>& cancel);

/// The parallel camera that looks at the plane from the side that was taken away, and whose image shows just
/// what is between two positions of its drawing, the lower left one first.
Camera planCamera(const Scene& scene, const Box3& bounds, const SectionPlane& plane, const FlatPoint& low,
                  const FlatPoint& high);

} // namespace rtcore

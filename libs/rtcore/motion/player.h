/// From keys to a camera: the one class that a program needs of this room.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/motion/action.h"
#include "rtcore/motion/flying.h"
#include "rtcore/motion/walker.h"
#include "rtcore/motion/world_frame.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/scene.h"

#include <chrono>
#include <cstdint>

namespace rtcore {

enum class MotionMode {
    View, ///< flies freely
    Walk  ///< has a body; gravity
};

struct PlayerOptions {
    Vec3 up{0, 1, 0};
    double metresPerUnit = 1; ///< above 0, finite
    WalkParameters walk;
};

/// Moves in steps of its own clock: the same presses at the same moments give the same cameras, bit for bit,
/// however often advance() is called between them. One thread.
///
/// A program's turn: advance() by the time since its last turn, then hand in what was pressed meanwhile, then
/// take camera(). So what is pressed after a long sleep starts now and not in the past.
class Player {
  public:
    /// `tree` and `mesh` must outlive it. Starts in viewing mode at a default camera.
    Player(const KdTree& tree, const Mesh& mesh, const PlayerOptions& options);

    /// Another tree of the same mesh, or of a part of it; must outlive it. Nothing moves.
    void useTree(const KdTree& tree);
    /// The planes that cut the model: Walker::useSections(). Nothing moves.
    void useSections(std::span<const SectionPlane> planes, std::span<const std::uint8_t> uncut = {}) {
        walker_.useSections(planes, uncut);
    }

    /// Jumps there. In walk-through mode the body comes along; where there is no room for it the mode becomes
    /// View.
    void setCamera(const Camera& camera);
    /// The camera that setCamera() was given, bit for bit, until something moves or turns it; then only the
    /// part that moves changes. Turning sets it upright.
    Camera camera() const;

    MotionMode mode() const { return mode_; }
    /// False, and nothing changed, where there is no room for a body within a metre of the eye, or where the
    /// eye is below all that could carry. A walker that falls out of the world and never stood is put back to
    /// where it was before, and flies.
    bool setMode(MotionMode mode);
    /// Walks beside the model, where nothing is below: on a floor at its lowest point that is not seen.
    bool onUnseenFloor() const { return mode_ == MotionMode::Walk && walker_.onUnseenFloor(); }

    /// Sets the actions that go on (isHeld) until the next call.
    void hold(const ActionSet& actions) { held_ = actions; }
    /// Acts for one step at least, even if it is over before the step begins.
    void tap(Action action) { tapped_.set(action); }
    /// By the mouse, at once: radians to the right and upwards.
    void look(double right, double upwards);

    /// At most a quarter of a second counts: after a stall the player does not leap.
    void advance(std::chrono::nanoseconds time);

    /// Flies so many times as fast as usual; > 0. Walking stays as it is. Usual is a tenth of the scene's
    /// diagonal in a second; where things are around the eye, as far as they are away (clearance()), if that
    /// is less.
    void setSpeedFactor(double factor) { speedFactor_ = factor; }
    double speedFactor() const { return speedFactor_; }

    /// Nothing will move until something is pressed.
    bool atRest() const;

  private:
    /// A view; the camera's lies between those of the last two steps.
    struct View {
        Vec3d eye;
        Heading heading;
        double width = 0; ///< as in FlightState
        friend bool operator==(const View&, const View&) = default;
    };

    void step();
    void stepWalking(const ActionSet& held);
    void stepFlying(const ActionSet& held);

    const KdTree* tree_;
    Mesh mesh_;
    WorldFrame frame_;
    Walker walker_;
    double flyingSpeed_; ///< m/s
    double pace_ = 0;    ///< m/s: that of the place, followed smoothly; 0: not known yet
    double speedFactor_ = 1;
    MotionMode mode_ = MotionMode::View;
    Camera given_;
    bool moved_ = false, turned_ = false, narrowed_ = false; ///< since the camera was given
    Vec3d entered_;                                          ///< the eye, when it began to walk
    FlightState flight_;
    TurnState turn_;
    View now_, before_;
    ActionSet held_, tapped_;
    std::int64_t clock_ = 0; ///< nanoseconds times ticks per second, less than a second's
};

} // namespace rtcore

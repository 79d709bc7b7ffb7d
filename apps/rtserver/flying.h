/// Viewing mode: a camera that flies freely. (thesis 7.2.1)
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/scene/camera.h"

#include <bitset>

namespace rtserver {

enum class Action { Forward, Back, Left, Right, Up, Down, TurnLeft, TurnRight, TurnUp, TurnDown, Sprint };
inline constexpr int kActions = 11;

/// One thread. Moves at a rate that suits the size of the scene, by time and not by frames.
class Flyer {
  public:
    /// `up` is a unit vector: the axis of turns to the side, and the way up.
    Flyer(const rtcore::Camera& camera, const rtcore::Box3& bounds, rtcore::Vec3 up);

    void press(Action action) { pressed_.set(static_cast<std::size_t>(action)); }
    void release(Action action) { pressed_.reset(static_cast<std::size_t>(action)); }
    void releaseAll() { pressed_.reset(); }
    /// Turns to the right and upwards, degrees. Never looks straight up or down.
    void look(float right, float upwards);
    /// What is pressed acts for that time. True when the camera is another one now.
    bool advance(double seconds);

    const rtcore::Camera& camera() const { return camera_; }
    void setCamera(const rtcore::Camera& camera) { camera_ = camera; }

  private:
    /// 1, -1 or 0: which of the two is pressed.
    float axis(Action positive, Action negative) const;
    bool pressed(Action action) const { return pressed_.test(static_cast<std::size_t>(action)); }

    rtcore::Camera camera_;
    rtcore::Vec3 up_;
    float unitsPerSecond_;
    std::bitset<kActions> pressed_;
};

} // namespace rtserver

/// Viewing mode: the eye flies freely, and turns, with a little inertia.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/motion/action.h"

namespace rtcore {

/// Where one looks: radians. Heading grows to the left; 0 looks along y.
struct Heading {
    double yaw = 0, pitch = 0;
    friend bool operator==(const Heading&, const Heading&) = default;
};

/// Straight up and straight down are left out by a tenth of a degree.
inline constexpr double kMaxPitch = 1.5690;

/// Yaw in [-pi, pi], pitch within kMaxPitch; what is not finite becomes 0.
Heading normalize(Heading heading);
/// Unit vectors; the same bits on every processor.
Vec3d lookDirection(Heading heading);
Vec3d aheadOf(Heading heading);
Heading headingOf(Vec3d forward, Vec3d up);

struct FlightState {
    Vec3d eye, velocity;  ///< metres
    double width = 0;     ///< of an orthographic view, scene units; 0: a perspective one
    double narrowing = 0; ///< e-folds a second
    friend bool operator==(const FlightState&, const FlightState&) = default;
};

/// One step of kTickSeconds at `speed` (m/s): with Sprint four times as fast, with Crouch a quarter. An
/// orthographic view shows the same from near and far: it gets narrower in place of going forwards.
void fly(FlightState& state, Heading heading, const ActionSet& held, double speed);

/// Turning by keys, both modes: speed in radians per second, approached smoothly.
struct TurnState {
    double yawSpeed = 0, pitchSpeed = 0;
    friend bool operator==(const TurnState&, const TurnState&) = default;
};
void turn(TurnState& state, Heading& heading, const ActionSet& held);

} // namespace rtcore

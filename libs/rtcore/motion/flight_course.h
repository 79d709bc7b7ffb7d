/// Where the camera of a flight is at any time.
#pragma once

#include "rtcore/motion/monotone_track.h"
#include "rtcore/motion/smooth_curve.h"
#include "rtcore/motion/world_frame.h"
#include "rtcore/scene/flight.h"

#include <optional>
#include <vector>

namespace rtcore {

/// A view of a flight.
struct FlightView {
    Camera camera;
    std::optional<float> exposure; ///< as in FlightKey
};

/// The same bits on every processor; at the time of a key exactly its camera, but for the aspect, which is
/// that of the first all the way, and for a target, which is looked at. The eye goes along a SmoothCurve; yaw
/// (the shorter way), pitch, roll, angle or width, and exposure are MonotoneTracks over time. Where the eye
/// stays while the camera turns, and where it turns back, the flight comes to rest. Images are upright unless
/// a key is rolled.
///
/// Even: the eye has one speed, but for kEase of the time between two rests at either end; a turn on the spot
/// by a right angle takes as long as the mean way between two keys. Closed, without a rest: one speed.
/// Times: the way along the curve is a MonotoneTrack.
class FlightCourse {
  public:
    static constexpr double kEase = 0.15;

    /// `flight` has no problemOf(); `up` as in WorldFrame.
    FlightCourse(const Flight& flight, Vec3 up);

    double seconds() const { return seconds_; }
    /// When the key is reached.
    double timeOf(std::size_t key) const { return times_[key]; }
    /// Clamped to the beginning and the end.
    FlightView at(double time) const;

    /// Whether the end is the beginning again, at the same speed: a film of it is shown over and over.
    bool goesRound() const { return goesRound_; }
    /// Around one axis.
    bool isTurntable() const { return flight_.turns != 0; }
    /// Frames of a film, from the beginning to the end; of what goes round without the end. At least one.
    int frames(double perSecond) const;
    /// When the frame is, counted from 0: what goes round is divided among its frames.
    double timeOfFrame(int frame, double perSecond) const;

  private:
    /// A part of the way between two rests.
    struct Leg {
        double begins, lasts; ///< seconds
        double from, way;     ///< along the whole
        double ease;          ///< of its time, at either end
    };
    struct Stretch {
        SmoothCurve curve;
        double from; ///< along the whole
    };
    struct Angles {
        double yaw, pitch, roll; ///< radians
    };

    const Camera& cameraAt(std::size_t stop) const { return flight_.keys[stops_[stop]].camera; }
    Vec3d eyeOf(std::size_t stop) const { return frame_.toMetres(cameraAt(stop).eye); }
    Angles anglesOf(const Camera& camera) const;
    bool stays(std::size_t stop) const; ///< until the next one
    void findRests();
    void layOut();
    double weightOfTurn(std::size_t stop) const;
    void setTimesEvenly();
    void setTracks();
    double wayAt(double time) const;
    Vec3d eyeAt(double time) const;
    void aim(Camera& camera, Angles angles) const;
    void aimAtTarget(Camera& camera, double roll) const;
    Camera turned(double time) const;

    Flight flight_;
    WorldFrame frame_;
    std::vector<std::size_t> stops_; ///< keys in their order, with the first at the end of what is closed
    double digits_ = 0;              ///< shorter ways are rounding
    std::vector<std::size_t> rests_; ///< indices into stops_, the first and the last among them
    std::vector<Stretch> stretches_;
    std::vector<double> ways_;         ///< along the whole, at each stop
    std::vector<double> times_;        ///< seconds, at each stop
    std::vector<Leg> legs_;            ///< Even
    std::optional<MonotoneTrack> way_; ///< Times
    std::optional<MonotoneTrack> yaw_, pitch_, roll_, angle_, width_, exposure_;
    double seconds_ = 0;
    bool goesRound_ = false;
};

} // namespace rtcore

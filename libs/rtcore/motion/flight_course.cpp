#include "rtcore/motion/flight_course.h"

#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rtcore {

namespace {

constexpr double kHalfTurn = std::numbers::pi;

double sineOf(double radians) { return portableSinOfDegrees(radians * (180 / kHalfTurn)); }
double cosineOf(double radians) { return portableCosOfDegrees(radians * (180 / kHalfTurn)); }
double angleOf(double y, double x) {
    return double{portableAtan2(static_cast<float>(y), static_cast<float>(x))};
}

/// What is done after `t` of a time: both from 0 to 1, with one speed but for `ease` of the time at both
/// ends, in which it grows and falls smoothly.
double eased(double t, double ease) {
    if (ease <= 0) return t;
    if (t > 0.5) return 1 - eased(1 - t, ease);
    const double speed = 1 / (1 - ease), x = t / ease;
    return x < 1 ? speed * ease * (x * x * x * (1 - 0.5 * x)) : speed * (t - 0.5 * ease);
}

/// When that much is done.
double timeWhenDone(double done, double ease) {
    constexpr int kHalvings = 60;
    double low = 0, high = 1;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (eased(middle, ease) < done ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Two ways that lead so exactly back that a curve would have a cusp.
bool turnsBack(Vec3d before, Vec3d after) {
    constexpr double kCosine = -0.985; // 170 degrees
    return dot(before, after) < kCosine * length(before) * length(after);
}

Vec3 toFloats(Vec3d p) { return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}; }

double shorterWay(double radians) { return radians - 2 * kHalfTurn * std::round(radians / (2 * kHalfTurn)); }

} // namespace

FlightCourse::FlightCourse(const Flight& flight, Vec3 up) : flight_(flight), frame_(up, 1) {
    const std::size_t keys = flight_.keys.size();
    for (FlightKey& key : flight_.keys) key.camera.aspect = flight_.keys[0].camera.aspect;
    for (std::size_t i = 0; i < keys; ++i) stops_.push_back(i);
    if (flight_.closed && keys > 1) stops_.push_back(0);
    seconds_ = flight_.timing == FlightTiming::Even ? flight_.seconds : flight_.keys.back().time;
    if (flight_.turns != 0) {
        times_ = {0};
        goesRound_ = flight_.turns == std::round(flight_.turns);
        return;
    }
    findRests();
    layOut();
    if (flight_.timing == FlightTiming::Even) {
        setTimesEvenly();
    } else {
        for (const FlightKey& key : flight_.keys) times_.push_back(key.time);
        way_.emplace(times_, ways_);
    }
    setTracks();
}

bool FlightCourse::stays(std::size_t stop) const {
    return !(length(eyeOf(stop + 1) - eyeOf(stop)) > digits_);
}

void FlightCourse::findRests() {
    // What floats cannot tell apart is no way.
    constexpr double kDigits = 2e-7;
    double largest = 0;
    for (std::size_t i = 0; i < stops_.size(); ++i) {
        const Vec3d eye = eyeOf(i);
        largest = std::max({largest, std::fabs(eye.x), std::fabs(eye.y), std::fabs(eye.z)});
    }
    digits_ = kDigits * largest;
    const auto way = [&](std::size_t i) { return eyeOf(i + 1) - eyeOf(i); };
    const auto rests = [&](std::size_t before, std::size_t after) {
        return stays(before) || stays(after) || turnsBack(way(before), way(after));
    };
    const std::size_t last = stops_.size() - 1;
    rests_ = {0};
    for (std::size_t i = 1; i < last; ++i) {
        if (rests(i - 1, i)) rests_.push_back(i);
    }
    if (last > 0) rests_.push_back(last);
    goesRound_ = flight_.closed && last > 2 && rests_.size() == 2 && !rests(last - 1, 0);
}

void FlightCourse::layOut() {
    ways_.assign(stops_.size(), 0);
    for (std::size_t leg = 0; leg + 1 < rests_.size(); ++leg) {
        const std::size_t first = rests_[leg], last = rests_[leg + 1];
        std::vector<Vec3d> points;
        for (std::size_t i = first; i <= last; ++i) points.push_back(eyeOf(i));
        if (points.size() == 2 && stays(first)) points.pop_back();
        if (goesRound_) points.pop_back();
        const SmoothCurve curve(points, goesRound_);
        for (std::size_t i = first + 1; i <= last; ++i)
            ways_[i] = ways_[first] + (curve.segments() > 0 ? curve.lengthAt(i - first) : 0);
        stretches_.push_back({curve, ways_[first]});
    }
}

/// In right angles, of the camera that stands at a stop and the next one.
double FlightCourse::weightOfTurn(std::size_t stop) const {
    constexpr double kOfOtherChanges = 0.25;
    const Camera &from = cameraAt(stop), &to = cameraAt(stop + 1);
    if (from == to) return 0;
    const Angles a = anglesOf(from), b = anglesOf(to);
    const double turn = std::max({std::fabs(shorterWay(b.yaw - a.yaw)), std::fabs(b.pitch - a.pitch),
                                  std::fabs(shorterWay(b.roll - a.roll))});
    return std::max(kOfOtherChanges, turn / (kHalfTurn / 2));
}

void FlightCourse::setTimesEvenly() {
    std::size_t moves = 0;
    for (std::size_t i = 0; i + 1 < ways_.size(); ++i) moves += ways_[i + 1] > ways_[i] ? 1 : 0;
    const double mean = moves > 0 ? ways_.back() / static_cast<double>(moves) : 1;
    double whole = 0;
    for (std::size_t i = 0; i + 1 < rests_.size(); ++i) {
        const double from = ways_[rests_[i]], way = ways_[rests_[i + 1]] - from;
        const double weight = way > 0 ? way : weightOfTurn(rests_[i]) * mean;
        legs_.push_back(
            {.begins = whole, .lasts = weight, .from = from, .way = way, .ease = goesRound_ ? 0 : kEase});
        whole += weight;
    }
    const double unit = whole > 0 ? seconds_ / whole : 0;
    times_.assign(stops_.size(), 0);
    for (std::size_t i = 0; i < legs_.size(); ++i) {
        Leg& leg = legs_[i];
        leg.begins *= unit;
        leg.lasts *= unit;
        for (std::size_t stop = rests_[i] + 1; stop < rests_[i + 1]; ++stop)
            times_[stop] =
                leg.begins + leg.lasts * timeWhenDone((ways_[stop] - leg.from) / leg.way, leg.ease);
        times_[rests_[i + 1]] = i + 1 < legs_.size() ? leg.begins + leg.lasts : seconds_;
    }
}

void FlightCourse::setTracks() {
    std::vector<double> yaw, pitch, roll, angle, width, exposedAt, exposure;
    for (std::size_t i = 0; i < stops_.size(); ++i) {
        const Camera& camera = cameraAt(i);
        const Angles angles = anglesOf(camera);
        yaw.push_back(i == 0 ? angles.yaw : yaw.back() + shorterWay(angles.yaw - yaw.back()));
        pitch.push_back(angles.pitch);
        roll.push_back(i == 0 ? angles.roll : roll.back() + shorterWay(angles.roll - roll.back()));
        angle.push_back(double{camera.horizontalFov});
        width.push_back(double{camera.orthographicWidth});
        if (const auto& exposed = flight_.keys[stops_[i]].exposure) {
            exposedAt.push_back(times_[i]);
            exposure.push_back(double{*exposed});
        }
    }
    yaw_.emplace(times_, yaw, goesRound_);
    pitch_.emplace(times_, pitch, goesRound_);
    roll_.emplace(times_, roll, goesRound_);
    angle_.emplace(times_, angle, goesRound_);
    width_.emplace(times_, width, goesRound_);
    if (!exposure.empty()) exposure_.emplace(exposedAt, exposure);
}

FlightCourse::Angles FlightCourse::anglesOf(const Camera& camera) const {
    const Vec3d forward = normalize(frame_.turn(camera.forward)), up = frame_.turn(camera.up);
    constexpr double kUpright = 1e-4;
    const double across = length(horizontal(forward));
    // Looking straight up or down, the top of the image tells the heading, so that nothing is rolled.
    const Vec3d ahead = across > kUpright ? forward : forward.z < 0 ? up : -up;
    Angles angles{angleOf(-ahead.x, ahead.y), angleOf(forward.z, across), 0};
    const Vec3d right{cosineOf(angles.yaw), sineOf(angles.yaw), 0};
    const double roll = angleOf(dot(up, right), dot(up, cross(right, forward)));
    constexpr double kRolled = 1e-4; // radians; less is rounding
    if (std::fabs(roll) > kRolled) angles.roll = roll;
    return angles;
}

void FlightCourse::aim(Camera& camera, Angles angles) const {
    const Vec3d right{cosineOf(angles.yaw), sineOf(angles.yaw), 0}, ahead{-right.y, right.x, 0};
    const Vec3d forward = ahead * cosineOf(angles.pitch) + Vec3d{0, 0, 1} * sineOf(angles.pitch);
    const Vec3d up = cross(right, forward);
    camera.forward = frame_.turnBack(forward);
    camera.up = frame_.turnBack(up * cosineOf(angles.roll) + right * sineOf(angles.roll));
}

void FlightCourse::aimAtTarget(Camera& camera, double roll) const {
    Camera looking = camera;
    looking.forward = normalize(toFloats(*flight_.target) - camera.eye);
    if (looking.forward == Vec3{}) return; // it is at the target: as the keys have it
    Angles angles = anglesOf(looking);
    angles.roll = roll;
    aim(camera, angles);
}

double FlightCourse::wayAt(double time) const {
    if (way_) return way_->at(time);
    const auto next = std::upper_bound(legs_.begin(), legs_.end(), time,
                                       [](double wanted, const Leg& leg) { return wanted < leg.begins; });
    if (next == legs_.begin()) return 0;
    const Leg& leg = *(next - 1);
    if (!(leg.way > 0)) return leg.from;
    return leg.from + leg.way * eased(std::clamp((time - leg.begins) / leg.lasts, 0.0, 1.0), leg.ease);
}

Vec3d FlightCourse::eyeAt(double time) const {
    const double way = wayAt(time);
    const auto next = std::upper_bound(stretches_.begin(), stretches_.end(), way,
                                       [](double wanted, const Stretch& each) { return wanted < each.from; });
    if (next == stretches_.begin()) return eyeOf(0);
    const Stretch& stretch = *(next - 1);
    return stretch.curve.at(way - stretch.from);
}

Camera FlightCourse::turned(double time) const {
    Camera camera = cameraAt(0);
    const double done = eased(time / seconds_, goesRound_ ? 0 : kEase), degrees = 360 * flight_.turns * done;
    const double c = portableCosOfDegrees(degrees), s = portableSinOfDegrees(degrees);
    const auto turn = [&](Vec3d v) { return Vec3d{c * v.x - s * v.y, s * v.x + c * v.y, v.z}; };
    const Vec3d about = frame_.toMetres(toFloats(*flight_.target));
    camera.eye = frame_.toScene(about + turn(frame_.toMetres(camera.eye) - about));
    camera.forward = frame_.turnBack(turn(frame_.turn(camera.forward)));
    camera.up = frame_.turnBack(turn(frame_.turn(camera.up)));
    return camera;
}

FlightView FlightCourse::at(double time) const {
    time = std::clamp(time, 0.0, seconds_);
    FlightView view{cameraAt(0), flight_.keys[0].exposure};
    if (flight_.turns != 0) {
        if (time > 0) view.camera = turned(time);
        return view;
    }
    if (exposure_) view.exposure = static_cast<float>(exposure_->at(time));
    const auto key = std::ranges::lower_bound(times_, time);
    if (key != times_.end() && *key == time) {
        view.camera = cameraAt(static_cast<std::size_t>(key - times_.begin()));
        if (flight_.target) aimAtTarget(view.camera, anglesOf(view.camera).roll);
        return view;
    }
    view.camera.eye = frame_.toScene(eyeAt(time));
    view.camera.horizontalFov = static_cast<float>(angle_->at(time));
    view.camera.orthographicWidth = static_cast<float>(width_->at(time));
    const double roll = roll_->at(time);
    aim(view.camera, {yaw_->at(time), pitch_->at(time), roll});
    if (flight_.target) aimAtTarget(view.camera, roll);
    return view;
}

int FlightCourse::frames(double perSecond) const {
    constexpr double kRounding = 1e-6;
    const double whole = seconds_ * perSecond;
    return goesRound_ ? std::max(1, static_cast<int>(std::lround(whole)))
                      : static_cast<int>(std::floor(whole + kRounding)) + 1;
}

double FlightCourse::timeOfFrame(int frame, double perSecond) const {
    return goesRound_ ? seconds_ * frame / frames(perSecond) : frame / perSecond;
}

} // namespace rtcore

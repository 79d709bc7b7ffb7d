#include "rtcore/motion/flight_thinning.h"

#include "rtcore/motion/flight_course.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <numbers>

namespace rtcore {

namespace {

double degreesBetween(Vec3 a, Vec3 b) {
    constexpr double kDegrees = 180 / std::numbers::pi;
    return double{portableAtan2(length(cross(a, b)), dot(a, b))} * kDegrees;
}

Flight flightThrough(std::span<const TimedView> views, const std::vector<std::size_t>& chosen) {
    Flight flight{.name = "thinned", .timing = FlightTiming::Times};
    for (const std::size_t i : chosen)
        flight.keys.push_back({.camera = views[i].camera,
                               .time = views[i].time - views[0].time,
                               .exposure = views[i].exposure});
    return flight;
}

} // namespace

std::vector<FlightKey> thinned(std::span<const TimedView> all, double distance, double degrees, Vec3 up) {
    std::vector<TimedView> views;
    for (const TimedView& view : all) {
        if (views.empty() || view.time >= views.back().time + kMinFlightSeconds) views.push_back(view);
    }
    std::vector<std::size_t> chosen{0};
    if (views.size() > 1) chosen.push_back(views.size() - 1);
    while (true) {
        if (chosen.size() > kMaxFlightKeys)
            throw BadValue(
                say("the way needs more than {0} key frames; allow it to be farther off", kMaxFlightKeys));
        Flight flight = flightThrough(views, chosen);
        const FlightCourse course(flight, up);
        std::vector<std::size_t> more{0};
        for (std::size_t k = 0; k + 1 < chosen.size(); ++k) {
            double worst = 1;
            std::size_t farthest = 0;
            for (std::size_t i = chosen[k] + 1; i < chosen[k + 1]; ++i) {
                const Camera camera = course.at(views[i].time - views[0].time).camera;
                const double off =
                    std::max(double{length(camera.eye - views[i].camera.eye)} / distance,
                             degreesBetween(camera.forward, views[i].camera.forward) / degrees);
                if (off <= worst) continue;
                worst = off;
                farthest = i;
            }
            if (farthest > 0) more.push_back(farthest);
            more.push_back(chosen[k + 1]);
        }
        if (more.size() == chosen.size()) return std::move(flight.keys);
        chosen = std::move(more);
    }
}

} // namespace rtcore

#include "common/flights/flight_recording.h"

#include "common/process/stop.h"

#include "rtcore/io/recording/path_recorder.h"
#include "rtcore/platform/error.h"

#include <system_error>

namespace app {

rtcore::CameraFile flightCamera(const rtcore::FlightCourse& course, int frame, double perSecond,
                                const rtcore::LocalOrigin& zero) {
    const double time = course.timeOfFrame(frame, perSecond);
    const rtcore::FlightView view = course.at(time);
    rtcore::CameraFile file;
    file.camera = view.camera;
    file.origin = zero;
    file.exposure = view.exposure;
    file.time = time;
    return file;
}

void recordFlight(const std::filesystem::path& list, const rtcore::FlightCourse& course, double perSecond,
                  const rtcore::LocalOrigin& zero) {
    rtcore::PathRecorder recorder(list);
    try {
        for (int frame = 0; frame < course.frames(perSecond); ++frame) {
            throwIfStopped();
            recorder.add(flightCamera(course, frame, perSecond, zero));
        }
        recorder.finish();
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove(list, ignored);
        std::filesystem::remove_all(rtcore::recordedFolder(list), ignored);
        throw;
    }
}

} // namespace app

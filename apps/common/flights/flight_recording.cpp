#include "common/flights/flight_recording.h"

#include "common/process/stop.h"

#include "rtcore/io/recording/path_recorder.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"

#include <system_error>

namespace app {

int filmFrames(const rtcore::FlightCourse& course, double perSecond) {
    const int frames = course.frames(perSecond);
    if (frames <= kMaxFilmFrames) return frames;
    throw rtcore::BadValue(rtcore::say(
        "the flight has {0} frames at that rate, and {1} is the most; take fewer frames per second", frames,
        kMaxFilmFrames));
}

rtcore::CameraFile flightCamera(const FilmOfFlight& film, int frame) {
    const double time = film.course.timeOfFrame(frame, film.perSecond);
    const rtcore::FlightView view = film.course.at(time);
    rtcore::CameraFile file = film.common;
    file.camera = view.camera;
    if (view.exposure) file.exposure = view.exposure;
    if (!file.exposure && film.exposure) file.exposure = film.exposure->at(time);
    file.time = time;
    return file;
}

void recordFlight(const std::filesystem::path& list, const FilmOfFlight& film,
                  const std::atomic<bool>* stop) {
    const int frames = filmFrames(film.course, film.perSecond);
    rtcore::PathRecorder recorder(list);
    try {
        for (int frame = 0; frame < frames; ++frame) {
            throwIfStopped();
            if (stop != nullptr && *stop)
                throw rtcore::FileError(rtcore::FailureKind::Stopped, list.string(), "stopped");
            recorder.add(flightCamera(film, frame));
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

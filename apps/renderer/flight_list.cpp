#include "renderer/flight_list.h"

#include "renderer/film_rate.h"

#include "common/cli/command_line.h"
#include "common/flights/flight_recording.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/recording/path_recorder.h"
#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"
#include "rtcore/survey/subject.h"

#include <optional>
#include <string>

namespace renderer {

namespace {

double rateOf(const RendererOptions& options) { return options.framesPerSecond.value_or(kUsualFrameRate); }

std::string namesOf(const rtcore::Flights& flights) {
    std::string names;
    for (const rtcore::Flight& flight : flights)
        names += (names.empty() ? "" : ", ") + rtcore::inQuotes(flight.name);
    return names;
}

const rtcore::Flight& flightNamed(const std::string& name, const rtcore::SceneFile* scene,
                                  const std::filesystem::path& file) {
    const rtcore::Flights none;
    const rtcore::Flights& flights = scene != nullptr ? scene->flights : none;
    const auto found = rtcore::findFlight(flights, name);
    if (found != flights.end()) return *found;
    throw rtcore::FileError(
        rtcore::FailureKind::NoInput, file.string(),
        flights.empty()
            ? rtcore::say("it has no flight {0}, nor any other; a .scn has them, and "
                          "--turntable needs none",
                          rtcore::inQuotes(name))
            : rtcore::say("it has no flight {0}, but {1}", rtcore::inQuotes(name), namesOf(flights)));
}

/// As many as a list has room for: fewer frames per second are a matter of the options.
int framesOf(const rtcore::FlightCourse& course, const RendererOptions& options) {
    try {
        return app::filmFrames(course, rateOf(options));
    } catch (const rtcore::BadValue& tooMany) {
        throw app::UsageError(tooMany.sentence());
    }
}

rtcore::Flight turntableOf(const Turntable& turntable, const rtcore::Camera& camera, rtcore::Vec3 middle) {
    return {.name = "turntable",
            .seconds = turntable.seconds,
            .target = rtcore::Vec3d{double{middle.x}, double{middle.y}, double{middle.z}},
            .turns = turntable.turns,
            .keys = {{.camera = camera}}};
}

/// By the .cam that is asked for, or that of the scene, or its view, around the middle of what the model is
/// of.
app::FilmOfFlight turntableFilm(const RendererOptions& options, const rtcore::LoadedScene& loaded) {
    const auto ofScene = loaded.sceneFile ? loaded.sceneFile->cameraFile : std::nullopt;
    rtcore::CameraFile common;
    common.origin = loaded.scene.origin;
    common.camera = loaded.camera;
    if (const auto file = options.camera ? options.camera : ofScene)
        common = rtcore::readCameraFile(*file, loaded.scene.origin);
    common.camera.nameOffset = 0;
    const rtcore::Box3 bounds = subjectOf(loaded.scene.model.mesh, axesOf(loaded.scene)).bounds;
    const rtcore::Flight flight = turntableOf(*options.flight->turntable, common.camera,
                                              bounds.empty() ? rtcore::Vec3{} : bounds.centre());
    return {rtcore::FlightCourse(flight, loaded.scene.up), rateOf(options), common};
}

app::FilmOfFlight filmOf(const RendererOptions& options, const rtcore::LoadedScene& loaded) {
    if (options.flight->turntable) return turntableFilm(options, loaded);
    const rtcore::SceneFile* const file = loaded.sceneFile ? &*loaded.sceneFile : nullptr;
    rtcore::CameraFile common;
    common.origin = loaded.scene.origin;
    const rtcore::Flight& flight = flightNamed(options.flight->name, file, options.scene);
    return {rtcore::FlightCourse(flight, loaded.scene.up), rateOf(options), common};
}

/// Unless the film has one, or its images are to find theirs.
void measureExposure(int frames, PictureMaker& maker, app::FilmOfFlight& film) {
    if (film.common.exposure || film.course.at(0).exposure || !maker.findsExposures()) return;
    const rtcore::TemporaryFolder folder("rtsuite-exposure-");
    const std::filesystem::path list = folder.path() / "measured.lst";
    rtcore::PathRecorder recorder(list);
    std::vector<double> times;
    for (const int frame : app::framesToMeasure(film.course, frames)) {
        recorder.add(app::flightCamera(film, frame));
        times.push_back(film.course.timeOfFrame(frame, film.perSecond));
    }
    recorder.finish();
    const std::vector<float> found = maker.findExposures(rtcore::readCameraList(list));
    std::vector<app::MeasuredExposure> measured;
    for (std::size_t i = 0; i < found.size(); ++i) measured.push_back({times[i], found[i]});
    film.exposure.emplace(measured, film.course);
}

} // namespace

int framesOfFlight(const RendererOptions& options) {
    if (options.flight->turntable)
        return framesOf({turntableOf(*options.flight->turntable, {}, {}), {0, 1, 0}}, options);
    std::optional<rtcore::SceneFile> scene;
    if (options.scene.extension() == ".scn") scene = rtcore::readSceneFile(options.scene);
    const rtcore::Flight& flight =
        flightNamed(options.flight->name, scene ? &*scene : nullptr, options.scene);
    return framesOf({flight, scene->up}, options);
}

FlightList::FlightList(const RendererOptions& options, PictureMaker& maker) : folder_("rtsuite-flight-") {
    const std::filesystem::path list = folder_.path() / "flight.lst";
    app::FilmOfFlight film = filmOf(options, maker.loaded());
    measureExposure(framesOf(film.course, options), maker, film);
    app::recordFlight(list, film);
    cameras_ = rtcore::readCameraList(list);
}

void makeList(const RendererOptions& options, PictureMaker& maker, app::Progress& progress) {
    app::FilmOfFlight film = filmOf(options, maker.loaded());
    const int frames = framesOf(film.course, options);
    measureExposure(frames, maker, film);
    app::recordFlight(*options.makeList, film);
    progress.print("wrote " + options.makeList->string() + " with " + std::to_string(frames) + " cameras");
}

} // namespace renderer

// Commands that read and write files.
#include "rtserver/command_call.h"
#include "rtserver/exports.h"

#include "common/command_line.h"

#include "rtcore/io/images/image_file.h"

#include <array>
#include <optional>
#include <stdexcept>

namespace rtserver {

namespace {

// Whether the frame that is there can stand for what the session shows.
bool frameSuits(const Call& call) {
    const FrameMaker& frames = call.host.frames();
    const bool drawn = !frames.image().empty();
    if (call.session.paused && !drawn)
        throw std::runtime_error("there is no frame yet, and the server is paused");
    return drawn && (call.session.paused || (!call.session.stale() && !frames.reduced()));
}

Result loadCamera(const Call& call) {
    call.session.loadCamera(pathOf(call[0]));
    return {};
}

Result loadSet(const Call& call) {
    call.session.loadSettings(pathOf(call[0]));
    return {};
}

Result loadScene(const Call& call) {
    call.host.load(pathOf(call[0]), call.size() > 1 ? std::optional(pathOf(call[1])) : std::nullopt);
    return {.turn = Turn::WhenLoaded};
}

Result exportCamera(const Call& call) {
    if (!frameSuits(call)) return {.turn = Turn::Again};
    rtcore::CameraFile file = cameraFileOf(call.session, call.host.frames().exposure());
    const std::array<std::optional<int>*, 4> fields{&file.width, &file.height, &file.antialiasing,
                                                    &file.bloom};
    for (std::size_t i = 0; i + 1 < call.size(); ++i) *fields[i] = integer(call[i + 1]);
    rtcore::writeCameraFile(pathOf(call[0]), file);
    return {};
}

Result exportScene(const Call& call) {
    rtcore::writeSceneFile(pathOf(call[0]), sceneFileOf(call.session));
    return {};
}

Result startVideo(const Call& call) {
    const float rate = call.size() > 1 ? number(call[1]) : 30;
    if (!(rate >= 1 && rate <= 240)) throw app::UsageError("a recording takes 1 to 240 frames a second");
    call.session.startRecording(pathOf(call[0]), static_cast<double>(rate));
    return {};
}

// The thesis' spelling names the file here, too.
Result stopVideo(const Call& call) {
    const int frames = call.session.stopRecording(call.host.frames().exposure());
    return {.answer = std::to_string(frames) + (frames == 1 ? " frame" : " frames")};
}

Result play(const Call& call) {
    call.session.play(pathOf(call[0]));
    return {};
}

Result stopPlaying(const Call& call) {
    call.session.stopPlaying();
    return {};
}

Result screenshot(const Call& call) {
    const std::filesystem::path path = pathOf(call[0]);
    if (!frameSuits(call)) return {.turn = Turn::Again};
    if (rtcore::isHdrFormat(path)) {
        rtcore::writeHdrImage(path, call.host.frames().radiance());
    } else {
        rtcore::writeImage(path, call.host.frames().image());
    }
    return {};
}

constexpr std::array kCommands{
    Command{"load camera", 1, 1, "FILE", true, loadCamera},
    Command{"load scene", 1, 2, "FILE [BUILT-MODEL]", true, loadScene},
    Command{"load set", 1, 1, "FILE", true, loadSet},
    Command{"export camera", 1, 5, "FILE [WIDTH HEIGHT ANTIALIASING BLOOM]", true, exportCamera},
    Command{"export scene", 1, 1, "FILE", true, exportScene},
    Command{"export video start", 1, 2, "FILE [FRAMES-PER-SECOND]", true, startVideo},
    Command{"export video stop", 0, 1, "[FILE]", true, stopVideo},
    Command{"play", 1, 1, "FILE", true, play},
    Command{"play stop", 0, 0, "", true, stopPlaying},
    Command{"screenshot", 1, 1, "FILE", true, screenshot},
};

} // namespace

std::span<const Command> fileCommands() { return kCommands; }

} // namespace rtserver

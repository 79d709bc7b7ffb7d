// Commands that read and write files.
#include "rtserver/commands/command_call.h"
#include "rtserver/document/exports.h"

#include "common/settings/image_texts.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/io/text/set.h"
#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

// Whether the frame that is there can stand for what is shown.
bool frameSuits(const Call& call) {
    const FrameMaker& frames = call.host.frames();
    const bool drawn = !frames.image().empty();
    if (call.state.paused && !drawn) throw rtcore::Refusal("there is no frame yet, and the server is paused");
    return drawn && frames.complete() && (call.state.paused || !frames.stale(call.document()));
}

Result loadCamera(const Call& call) {
    return {.when = ReplyWhen::Beside,
            .work = [path = pathOf(call[0]), zero = call.document().scene()->origin,
                     &document = call.document()]() -> Finish {
                return [path, &document, file = rtcore::readCameraFile(path, zero)] {
                    return warningAnswer(document.applyCameraFile(file, path));
                };
            }};
}

Result loadSet(const Call& call) {
    return {.when = ReplyWhen::Beside,
            .work = [path = pathOf(call[0]), &document = call.document()]() -> Finish {
                return [&document, live = rtcore::readSettingsFile(path).live] {
                    document.assign(live);
                    return std::string();
                };
            }};
}

Result loadScene(const Call& call) {
    call.host.load(pathOf(call[0]), call.size() > 1 ? std::optional(pathOf(call[1])) : std::nullopt);
    return {.when = ReplyWhen::WhenLoaded};
}

// Writes what was true when the command was run.
Result writeBeside(const Call& call, std::string_view replaces, std::function<void()> write,
                   const std::string& answer = "") {
    return {.when = ReplyWhen::Beside,
            .work = [path = pathOf(call[0]), replaces, inputs = call.document().world().inputs,
                     write = std::move(write), answer]() -> Finish {
                refuseInput(inputs, path, replaces);
                write();
                return [answer] { return answer; };
            }};
}

Result exportCamera(const Call& call) {
    if (!frameSuits(call)) return {.when = ReplyWhen::Again};
    rtcore::CameraFile file = cameraFileOf(call.document(), call.host.frames().exposure());
    const std::array<std::optional<int>*, 4> fields{&file.width, &file.height, &file.antialiasing,
                                                    &file.bloom};
    for (std::size_t i = 0; i + 1 < call.size(); ++i) *fields[i] = integer(call[i + 1]);
    return writeBeside(call, ".cam", [path = pathOf(call[0]), file] { rtcore::writeCameraFile(path, file); });
}

Result exportScene(const Call& call) {
    return writeBeside(call, ".scn", [path = pathOf(call[0]), file = sceneFileOf(call.document())] {
        rtcore::writeSceneFile(path, file);
    });
}

Result startVideo(const Call& call) {
    const float rate = call.size() > 1 ? number(call[1]) : 30;
    call.walk().refuseSecondRecording();
    return {.when = ReplyWhen::Beside,
            .work = [path = pathOf(call[0]), rate, &walk = call.walk()]() -> Finish {
                auto recording = std::make_shared<std::unique_ptr<Recording>>(
                    std::make_unique<Recording>(path, static_cast<double>(rate)));
                return [recording, &walk] {
                    walk.startRecording(std::move(*recording));
                    return std::string();
                };
            }};
}

// The thesis' spelling names the file here, too.
Result stopVideo(const Call& call) {
    const int frames = call.walk().stopRecording(call.host.frames().exposure());
    return {.answer = fmt::format("{} frame{}", frames, frames == 1 ? "" : "s")};
}

// The list is remembered after the recording, for later requests.
Result video(const Call& call) {
    const std::string list = call.walk().recordedList().string();
    if (!call.walk().recording()) return {.answer = list.empty() ? "off" : "off " + list};
    const double seconds = std::chrono::duration<double>(call.walk().recordedTime()).count();
    return {.answer = fmt::format("on {:.1f} {}", seconds, list)};
}

Result play(const Call& call) {
    return {.when = ReplyWhen::Beside,
            .work = [path = pathOf(call[0]), zero = call.document().scene()->origin,
                     &walk = call.walk()]() -> Finish {
                auto playback =
                    std::make_shared<std::unique_ptr<Playback>>(std::make_unique<Playback>(path, zero));
                return [playback, &walk] {
                    walk.play(std::move(*playback));
                    return std::string();
                };
            }};
}

Result stopPlaying(const Call& call) {
    call.walk().stopPlaying();
    return {};
}

// A window may show a better image, which the server does not know.
std::string liveFrameText(const auto& frame) {
    return fmt::format("live frame, {} x {}", frame.width, frame.height);
}

Result screenshot(const Call& call) {
    const std::filesystem::path path = pathOf(call[0]);
    const FrameMaker& frames = call.host.frames();
    call.state.wantsExact = !call.state.paused;
    if (!frameSuits(call) || (call.state.wantsExact && !frames.exact())) return {.when = ReplyWhen::Again};
    call.state.wantsExact = false;
    const std::vector<rtcore::ImageText> texts = app::imageTexts(call.document().settings());
    if (rtcore::isHdrFormat(path)) {
        if (!frames.hasRadiance())
            throw rtcore::Refusal("the server was paused in the midst of a frame; resume it first");
        const auto picture = std::make_shared<const rtcore::HdrImage>(frames.radiance());
        return writeBeside(
            call, "", [path, picture, texts] { rtcore::writeHdrImage(path, *picture, texts); },
            liveFrameText(*picture));
    }
    const auto picture = std::make_shared<const rtcore::LdrImage>(frames.image());
    return writeBeside(
        call, "", [path, picture, texts] { rtcore::writeImage(path, *picture, {.texts = texts}); },
        liveFrameText(*picture));
}

constexpr std::array kFileFunctions{
    CommandFunction{app::CommandId::LoadCamera, loadCamera},
    CommandFunction{app::CommandId::LoadScene, loadScene},
    CommandFunction{app::CommandId::LoadSet, loadSet},
    CommandFunction{app::CommandId::ExportCamera, exportCamera},
    CommandFunction{app::CommandId::ExportScene, exportScene},
    CommandFunction{app::CommandId::ExportVideoStart, startVideo},
    CommandFunction{app::CommandId::ExportVideo, video},
    CommandFunction{app::CommandId::ExportVideoStop, stopVideo},
    CommandFunction{app::CommandId::Play, play},
    CommandFunction{app::CommandId::PlayStop, stopPlaying},
    CommandFunction{app::CommandId::Screenshot, screenshot},
};

} // namespace

std::span<const CommandFunction> fileFunctions() { return kFileFunctions; }

} // namespace rtserver

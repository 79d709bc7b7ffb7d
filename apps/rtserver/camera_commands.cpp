// Commands that place the camera.
#include "rtserver/command_call.h"

#include "common/cli/command_line.h"

#include "rtcore/render/lens.h"
#include "rtcore/settings/settings_table.h"

#include <array>
#include <cmath>
#include <stdexcept>

namespace rtserver {

namespace {

rtcore::Vec3 vectorAt(const Call& call, std::size_t i) {
    return {number(call[i]), number(call[i + 1]), number(call[i + 2])};
}

Result get(const Call& call) {
    rtcore::CameraFile file;
    file.camera = call.session.camera();
    std::string text = rtcore::formatCameraFile(file);
    if (text.ends_with('\n')) text.pop_back();
    return {.answer = text};
}

Result setCamera(const Call& call, rtcore::Vec3 forward) {
    rtcore::Camera camera = call.session.camera();
    camera.eye = vectorAt(call, 0);
    camera.forward = forward;
    camera.up = rtcore::upwardsOf(forward, call.session.world().loaded.scene.up);
    if (call.size() > 6) {
        camera.kind = rtcore::CameraKind::Perspective;
        camera.horizontalFov = number(call[6]);
        camera.aspect = 0;
    }
    call.session.setCamera(camera);
    return {};
}

Result set(const Call& call) { return setCamera(call, vectorAt(call, 3)); }
Result lookAt(const Call& call) { return setCamera(call, vectorAt(call, 3) - vectorAt(call, 0)); }

Result turn(const Call& call) {
    const float right = number(call[0]), upwards = number(call[1]);
    constexpr float kMost = 360;
    if (std::fabs(right) > kMost || std::fabs(upwards) > kMost)
        throw app::UsageError("camera turn takes angles from -360 to 360 degrees");
    call.session.turn(right, upwards);
    return {};
}

Result reset(const Call& call) {
    call.session.setCamera(call.session.world().loaded.camera);
    return {};
}

Result walk(const Call& call) {
    call.session.setWalking(true);
    return {.answer = call.session.onUnseenFloor() ? kUnseenFloor : ""};
}

Result fly(const Call& call) {
    call.session.setWalking(false);
    return {};
}

Result speed(const Call& call) {
    constexpr float kLeast = 0.001F, kMost = 1000;
    const float factor = number(call[0]);
    if (!(factor >= kLeast && factor <= kMost)) throw app::UsageError("speed takes 0.001 to 1000");
    call.session.setSpeed(static_cast<double>(factor));
    return {};
}

Result focus(const Call& call) {
    const float right = number(call[0]), down = number(call[1]);
    if (!(right >= 0 && right <= 1 && down >= 0 && down <= 1))
        throw app::UsageError(
            "focus takes a place in the picture: 0 to 1 from the left, 0 to 1 from the top");
    rtcore::RenderSettings settings = call.session.settings();
    const rtcore::CameraRays view(call.session.camera(), settings.width, settings.height);
    const float distance = rtcore::FocusFinder().distance(*call.session.world().tracer, view,
                                                          right * static_cast<float>(settings.width),
                                                          down * static_cast<float>(settings.height));
    if (!(distance < rtcore::kInfiniteFocus))
        throw std::runtime_error("there is nothing to focus on; the focus stays as it was");
    settings.depthOfField.on = true;
    settings.depthOfField.focus = distance;
    call.session.setSettings(settings);
    return {.answer = rtcore::settingText(settings.depthOfField.focus)};
}

constexpr std::array kCommands{
    Command{"camera get", 0, 0, "", true, get, Effect::Tells},
    Command{"camera set", 6, 7, "EX EY EZ FX FY FZ [FOV]", true, set},
    Command{"camera look-at", 6, 7, "EX EY EZ TX TY TZ [FOV]", true, lookAt},
    Command{"camera turn", 2, 2, "RIGHT UP", true, turn},
    Command{"camera reset", 0, 0, "", true, reset},
    Command{"focus", 2, 2, "X Y", true, focus},
    Command{"speed", 1, 1, "FACTOR", true, speed},
    Command{"walk", 0, 0, "", true, walk},
    Command{"fly", 0, 0, "", true, fly},
};

} // namespace

std::span<const Command> cameraCommands() { return kCommands; }

} // namespace rtserver

// Commands that place the camera.
#include "rtserver/commands/command_call.h"
#include "rtserver/commands/model_objects.h"
#include "rtserver/commands/seen_surface.h"

#include "common/commands/told_forms.h"

#include "rtcore/motion/orbit.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/lens.h"
#include "rtcore/scene/focal_length.h"
#include "rtcore/scene/part_list.h"
#include "rtcore/scene/up_axis.h"
#include "rtcore/settings/number_text.h"
#include "rtcore/settings/settings_table.h"
#include "rtcore/survey/default_view.h"
#include "rtcore/survey/framing.h"
#include "rtcore/survey/subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace rtserver {

namespace {

Result getCamera(const Call& call) {
    std::string text = rtcore::formatCameraInFile(call.document().camera(), call.document().scene()->origin);
    if (text.ends_with('\n')) text.pop_back();
    return {.answer = text};
}

// Where the arguments of the commands that place a camera stand.
constexpr std::size_t kEye = 0, kForward = 3, kWidth = 6, kUp = 7, kAspect = 10;

// `camera` with the eye, and with what is up and the aspect where these are given.
Result setCamera(const Call& call, rtcore::Camera camera, rtcore::Vec3 forward) {
    camera.eye = positionAt(call, kEye);
    camera.forward = forward;
    camera.up =
        call.size() > kUp ? vectorAt(call, kUp) : rtcore::upwardsOf(forward, call.document().scene()->up);
    if (call.size() > kWidth) camera.aspect = call.size() > kAspect ? number(call[kAspect]) : 0;
    call.document().setCamera(camera);
    return {};
}

rtcore::Camera perspective(const Call& call) {
    rtcore::Camera camera = call.document().camera();
    if (call.size() <= kWidth) return camera;
    camera.kind = rtcore::CameraKind::Perspective;
    camera.horizontalFov = number(call[kWidth]);
    camera.orthographicWidth = 0;
    return camera;
}

Result set(const Call& call) { return setCamera(call, perspective(call), vectorAt(call, kForward)); }

Result lookAt(const Call& call) {
    return setCamera(call, perspective(call), positionAt(call, kForward) - positionAt(call, kEye));
}

Result orthographic(const Call& call) {
    rtcore::Camera camera;
    camera.kind = rtcore::CameraKind::Orthographic;
    camera.orthographicWidth = number(call[kWidth]);
    return setCamera(call, camera, vectorAt(call, kForward));
}

Result turn(const Call& call) {
    call.walk().turn(number(call[0]), number(call[1]));
    return {};
}

Result pivot(const Call& call) {
    if (call.size() == 1) throw app::UsageError("camera pivot takes RIGHT and DOWN, or neither");
    const auto seen =
        call.size() < 2 ? std::nullopt : surfaceAt(call.document(), number(call[0]), number(call[1]));
    call.walk().setPivot(seen ? std::optional(seen->position) : std::nullopt);
    return {.answer = positionText(call, call.walk().pivot())};
}

// It is the eye that moves: without a body.
void place(const Call& call, const rtcore::Camera& camera) {
    call.walk().setWalking(false);
    call.document().setCamera(camera);
}

Result orbit(const Call& call) {
    constexpr double kDegree = std::numbers::pi / 180;
    const double right = static_cast<double>(number(call[0])), up = static_cast<double>(number(call[1]));
    place(call, rtcore::orbited(call.document().camera(), call.document().scene()->up, call.walk().pivot(),
                                right * kDegree, up * kDegree));
    return {};
}

// The image's width in scene units, at the distance of the pivot; never 0.
double widthAtPivot(const Call& call) {
    const Document& document = call.document();
    const rtcore::RenderSettings& settings = document.settings();
    const rtcore::CameraRays view(document.camera(), settings.width, settings.height);
    const float width = length(view.plane().right) * static_cast<float>(settings.width);
    if (view.parallel()) return static_cast<double>(width);
    const float away = dot(call.walk().pivot() - view.eye(), view.forward());
    const float min = 1e-3F * document.world().loaded.tree.bounds.diagonal();
    return static_cast<double>(width * std::max(std::fabs(away), min));
}

Result pan(const Call& call) {
    const double width = widthAtPivot(call);
    place(call, rtcore::shifted(call.document().camera(), -width * static_cast<double>(number(call[0])),
                                -width * static_cast<double>(number(call[1]))));
    return {};
}

Result approach(const Call& call) {
    place(call, rtcore::approached(call.document().camera(), call.walk().pivot(),
                                   static_cast<double>(number(call[0]))));
    return {};
}

// The bounds of the named parts; without names those of the model's subject.
rtcore::Box3 boxToFit(const Call& call) {
    const rtcore::Scene& scene = *call.document().scene();
    if (call.size() == 0) return subjectOf(scene.model.mesh, rtcore::axesOf(scene)).bounds;
    const std::vector<rtcore::NamedPart> parts = rtcore::namedParts(scene.model);
    const std::vector<std::uint8_t> chosen = partsNamed(parts, call.arguments);
    rtcore::Box3 box;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (chosen[i] == 0) continue;
        for (const std::uint32_t piece : parts[i].pieces) {
            const rtcore::ModelPart& part = scene.model.parts[piece];
            for (std::uint32_t t = 0; t < part.triangleCount; ++t)
                for (int corner = 0; corner < 3; ++corner)
                    box.extend(scene.model.mesh.position(part.firstTriangle + t, corner));
        }
    }
    return box;
}

void fitTo(const Call& call, rtcore::Camera camera, const rtcore::Box3& box) {
    if (box.empty()) throw rtcore::Refusal("there is nothing to show");
    const rtcore::RenderSettings& settings = call.document().settings();
    const float aspect = static_cast<float>(settings.width) / static_cast<float>(settings.height);
    camera.up = rtcore::upwardsOf(camera.forward, call.document().scene()->up);
    place(call, rtcore::framed(call.document().scene()->model.mesh, box, camera, aspect));
    call.walk().setPivot(box.centre());
}

Result fit(const Call& call) {
    fitTo(call, call.document().camera(), boxToFit(call));
    return {};
}

// Where the eye is, as seen from the middle of the model.
rtcore::Vec3 sideNamed(std::string_view side, const rtcore::Axes& axes) {
    if (side == "front") return axes.front;
    if (side == "back") return -axes.front;
    if (side == "left") return -axes.right;
    if (side == "right") return axes.right;
    if (side == "top") return axes.up;
    if (side == "bottom") return -axes.up;
    return rtcore::threeQuarters(axes);
}

Result view(const Call& call) {
    rtcore::Camera camera = call.document().camera();
    camera.forward = -sideNamed(call[0], rtcore::axesOf(*call.document().scene()));
    fitTo(call, camera,
          subjectOf(call.document().scene()->model.mesh, rtcore::axesOf(*call.document().scene())).bounds);
    return {};
}

Result reset(const Call& call) {
    call.walk().resetCamera();
    return {};
}

Result paste(const Call& call) {
    const std::filesystem::path pasted = "the pasted text"; // in messages
    const Answer answer = warningAnswer(call.document().applyCameraFile(
        rtcore::parseCameraFile(call[0], pasted, call.document().scene()->origin), pasted));
    return {.answer = answer.text, .detail = answer.detail};
}

// The angle of the image that is shown, whatever aspect its author framed.
Result setAngle(const Call& call, double degrees) {
    rtcore::Camera camera = call.document().camera();
    camera.kind = rtcore::CameraKind::Perspective;
    camera.horizontalFov = static_cast<float>(degrees);
    camera.orthographicWidth = camera.aspect = 0;
    call.document().setCamera(camera);
    return {};
}

Result angle(const Call& call) { return setAngle(call, static_cast<double>(number(call[0]))); }

Result lens(const Call& call) {
    return setAngle(call, rtcore::angleOfFocalLength(static_cast<double>(number(call[0]))));
}

float zoomedAngle(float degrees, double factor) {
    constexpr float kNarrowest = 0.5F, kWidest = 170;
    const double halfWidth = rtcore::halfWidthOfAngle(static_cast<double>(degrees)) / factor;
    return std::clamp(static_cast<float>(rtcore::angleOfHalfWidth(halfWidth)), std::min(degrees, kNarrowest),
                      std::max(degrees, kWidest));
}

// The angle of the image that is shown has limits, and is told; the camera's own may be that of another
// aspect.
double zoomAngle(const Call& call, rtcore::Camera& camera, double factor) {
    const rtcore::RenderSettings& settings = call.document().settings();
    const float shown = rtcore::fieldOfView(camera, settings.width, settings.height);
    const float wanted = zoomedAngle(shown, factor);
    const auto widthOf = [](float degrees) { return rtcore::halfWidthOfAngle(static_cast<double>(degrees)); };
    const double own = widthOf(camera.horizontalFov) * widthOf(wanted) / widthOf(shown);
    camera.horizontalFov =
        shown == camera.horizontalFov ? wanted : static_cast<float>(rtcore::angleOfHalfWidth(own));
    return static_cast<double>(wanted);
}

Result zoom(const Call& call) {
    const auto factor = static_cast<double>(number(call[0]));
    rtcore::Camera camera = call.document().camera();
    double extent = 0;
    if (camera.kind == rtcore::CameraKind::Orthographic) {
        float& width = camera.orthographicWidth;
        width = std::clamp(static_cast<float>(static_cast<double>(width) / factor), 1e-18F, 1e18F);
        extent = static_cast<double>(width);
    } else {
        extent = zoomAngle(call, camera, factor);
    }
    call.document().setCamera(camera);
    return {.answer = rtcore::settingText(static_cast<float>(extent))};
}

// Without an argument they only tell, and are no step of undo.
Result up(const Call& call) {
    if (call.size() > 0 && call[0] == "auto") {
        call.document().guessModelUnits(true, false);
    } else if (call.size() > 0) {
        call.document().setModelUnits(rtcore::axisNamed(call[0]), std::nullopt);
    }
    return {.answer = rtcore::describe(call.document().modelUnits()).english()};
}

Result units(const Call& call) {
    if (call.size() > 0 && call[0] == "auto") {
        call.document().guessModelUnits(false, true);
    } else if (call.size() > 0) {
        const auto named = rtcore::unitNamed(call[0]);
        call.document().setModelUnits(std::nullopt, named ? *named : double{number(call[0])});
    }
    return {.answer = rtcore::describe(call.document().modelUnits()).english()};
}

Result walk(const Call& call) {
    call.walk().setWalking(true);
    return {.answer = call.walk().onUnseenFloor() ? app::told::kUnseenFloor : ""};
}

Result fly(const Call& call) {
    call.walk().setWalking(false);
    return {};
}

Result speed(const Call& call) {
    call.walk().setSpeed(static_cast<double>(number(call[0])));
    return {};
}

Result focus(const Call& call) {
    const float right = number(call[0]), down = number(call[1]);
    rtcore::RenderSettings settings = call.document().settings();
    const rtcore::CameraRays view(call.document().camera(), settings.width, settings.height);
    const float distance = rtcore::FocusFinder().distance(*call.document().tracer(), view,
                                                          right * static_cast<float>(settings.width),
                                                          down * static_cast<float>(settings.height));
    if (!(distance < rtcore::kInfiniteFocus))
        throw rtcore::Refusal("there is nothing to focus on; the focus stays as it was");
    settings.depthOfField.on = true;
    settings.depthOfField.focus = distance;
    call.document().setSettings(settings);
    return {.answer = rtcore::settingText(settings.depthOfField.focus)};
}

constexpr std::array kCameraFunctions{
    CommandFunction{app::CommandId::CameraGet, getCamera},
    CommandFunction{app::CommandId::CameraSet, set},
    CommandFunction{app::CommandId::CameraOrthographic, orthographic},
    CommandFunction{app::CommandId::CameraLookAt, lookAt},
    CommandFunction{app::CommandId::CameraTurn, turn},
    CommandFunction{app::CommandId::CameraPivot, pivot},
    CommandFunction{app::CommandId::CameraOrbit, orbit},
    CommandFunction{app::CommandId::CameraPan, pan},
    CommandFunction{app::CommandId::CameraApproach, approach},
    CommandFunction{app::CommandId::CameraFit, fit},
    CommandFunction{app::CommandId::CameraView, view},
    CommandFunction{app::CommandId::CameraReset, reset},
    CommandFunction{app::CommandId::CameraPaste, paste},
    CommandFunction{app::CommandId::CameraAngle, angle},
    CommandFunction{app::CommandId::CameraLens, lens},
    CommandFunction{app::CommandId::CameraZoom, zoom},
    CommandFunction{app::CommandId::Up, up},
    CommandFunction{app::CommandId::Units, units},
    CommandFunction{app::CommandId::Focus, focus},
    CommandFunction{app::CommandId::Speed, speed},
    CommandFunction{app::CommandId::Walk, walk},
    CommandFunction{app::CommandId::Fly, fly},
};

} // namespace

std::span<const CommandFunction> cameraFunctions() { return kCameraFunctions; }

} // namespace rtserver

#include "rtserver/commands.h"

#include "rtserver/exports.h"

#include "common/command_line.h"
#include "common/run_program.h"
#include "common/words.h"

#include "ipc/platform/error.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/motion/key_codes.h"
#include "rtcore/platform/error.h"
#include "rtcore/settings/nearest_name.h"
#include "rtcore/settings/settings_table.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace rtserver {

namespace {

using Words = std::span<const std::string>;

struct Call {
    Session& session;
    Host& host;
    Words arguments;

    const std::string& operator[](std::size_t i) const { return arguments[i]; }
};

float number(const std::string& text) {
    constexpr double kMost = 1e30;
    const std::optional<double> value = app::parseNumber(text);
    if (!value || std::fabs(*value) > kMost) throw app::UsageError(rtcore::quoted(text) + " is no number");
    return static_cast<float>(*value);
}

int integer(const std::string& text) {
    const std::optional<std::int64_t> value = app::parseInteger(text);
    constexpr std::int64_t kMost = 1'000'000'000;
    if (!value || *value < -kMost || *value > kMost)
        throw app::UsageError(rtcore::quoted(text) + " is no whole number");
    return static_cast<int>(*value);
}

bool flag(const std::string& text) {
    if (text == "on") return true;
    if (text != "off") throw app::UsageError(rtcore::quoted(text) + " is neither on nor off");
    return false;
}

int keyOf(const std::string& name) {
    const std::optional<int> code = rtcore::keyNamed(name);
    if (!code) {
        throw app::UsageError(
            "unknown key " + rtcore::quoted(name) +
            "; there are letters, digits, Space, Left, Right, Up, Down, Shift, Control, CapsLock "
            "and others");
    }
    return *code;
}

// The server's own folder says nothing to a client.
std::filesystem::path pathOf(const std::string& text) {
    std::filesystem::path path(text);
    if (!path.is_absolute()) throw app::UsageError("the path " + rtcore::quoted(text) + " is not absolute");
    return path;
}

rtcore::Vec3 vectorAt(const Call& call, std::size_t i) {
    return {number(call[i]), number(call[i + 1]), number(call[i + 2])};
}

// Whether the frame that is there can stand for what the session shows.
bool frameSuits(const Call& call) {
    const bool drawn = !call.host.frames().image().empty();
    if (call.session.paused && !drawn)
        throw std::runtime_error("there is no frame yet, and the server is paused");
    return drawn && (call.session.paused || !call.session.stale());
}

Result ping(const Call&) { return {.answer = "pong"}; }

Result pause(const Call& call) {
    call.session.paused = true;
    return {};
}

Result resume(const Call& call) {
    call.session.paused = false;
    return {};
}

Result quit(const Call& call) {
    call.host.quit();
    return {};
}

void assign(const Call& call, std::span<const std::pair<std::string, std::string>> assignments) {
    rtcore::RenderSettings settings = call.session.settings();
    for (const auto& [name, value] : assignments) rtcore::setSettingFromText(settings, name, value);
    call.session.setSettings(settings);
}

Result set(const Call& call) {
    assign(call, std::array{std::pair{call[0], call[1]}});
    return {};
}

Result resolution(const Call& call) {
    assign(call,
           std::array{std::pair{std::string("width"), call[0]}, std::pair{std::string("height"), call[1]}});
    return {};
}

Result get(const Call& call) {
    return {.answer = rtcore::settingText(rtcore::getSetting(call.session.settings(), call[0]))};
}

Result settings(const Call& call) {
    std::string text;
    for (const auto& [name, value] : rtcore::settingAssignments(call.session.settings(), true))
        text += (text.empty() ? "" : "\n") + name + " = " + rtcore::settingText(value);
    return {.answer = text};
}

Result cameraGet(const Call& call) {
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
    camera.up = call.session.world().loaded.scene.up;
    if (call.arguments.size() > 6) camera.horizontalFov = number(call[6]);
    call.session.setCamera(camera);
    return {};
}

Result cameraSet(const Call& call) { return setCamera(call, vectorAt(call, 3)); }
Result cameraLookAt(const Call& call) { return setCamera(call, vectorAt(call, 3) - vectorAt(call, 0)); }

Result cameraTurn(const Call& call) {
    const float right = number(call[0]), upwards = number(call[1]);
    constexpr float kMost = 360;
    if (std::fabs(right) > kMost || std::fabs(upwards) > kMost)
        throw app::UsageError("camera turn takes angles from -360 to 360 degrees");
    call.session.turn(right, upwards);
    return {};
}

Result walk(const Call& call) {
    call.session.setWalking(true);
    return {};
}

Result fly(const Call& call) {
    call.session.setWalking(false);
    return {};
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
    call.host.load(pathOf(call[0]));
    return {.turn = Turn::WhenLoaded};
}

Result exportCamera(const Call& call) {
    if (!frameSuits(call)) return {.turn = Turn::Again};
    rtcore::CameraFile file = cameraFileOf(call.session, call.host.frames().exposure());
    const std::array<std::optional<int>*, 4> fields{&file.width, &file.height, &file.antialiasing,
                                                    &file.bloom};
    for (std::size_t i = 0; i + 1 < call.arguments.size(); ++i) *fields[i] = integer(call[i + 1]);
    rtcore::writeCameraFile(pathOf(call[0]), file);
    return {};
}

Result exportScene(const Call& call) {
    rtcore::writeSceneFile(pathOf(call[0]), sceneFileOf(call.session));
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

Result light(const Call& call) {
    call.session.switchLight(integer(call[0]), flag(call[1]));
    return {};
}

Result environment(const Call& call) {
    call.session.setEnvironment(integer(call[0]));
    return {};
}

Result keyPress(const Call& call) {
    call.session.keyboard().press(keyOf(call[0]));
    return {};
}

Result keyRelease(const Call& call) {
    if (call[0] == "all") {
        call.session.keyboard().releaseAll();
    } else {
        call.session.keyboard().release(keyOf(call[0]));
    }
    return {};
}

Result keyTap(const Call& call) {
    call.session.keyboard().tap(keyOf(call[0]));
    return {};
}

Result idle(const Call& call) {
    call.session.idles = flag(call[0]);
    return {};
}

Result waitIdle(const Call& call) {
    if (!call.session.idles) throw std::runtime_error("the server never idles; 'idle on' lets it");
    if (call.session.paused) throw std::runtime_error("the server is paused; resume it first");
    return {.turn = Turn::WhenIdle};
}

struct Command {
    std::string_view name;   ///< one word or two
    std::size_t least, most; ///< arguments
    std::string_view arguments;
    bool needsScene;
    Result (*run)(const Call&);
};

constexpr std::array kCommands{
    Command{"ping", 0, 0, "", false, ping},
    Command{"quit", 0, 0, "", false, quit},
    Command{"exit", 0, 0, "", false, quit},
    Command{"pause", 0, 0, "", false, pause},
    Command{"resume", 0, 0, "", false, resume},
    Command{"set", 2, 2, "NAME VALUE", true, set},
    Command{"get", 1, 1, "NAME", true, get},
    Command{"settings", 0, 0, "", true, settings},
    Command{"resolution", 2, 2, "WIDTH HEIGHT", true, resolution},
    Command{"camera get", 0, 0, "", true, cameraGet},
    Command{"camera set", 6, 7, "EX EY EZ FX FY FZ [FOV]", true, cameraSet},
    Command{"camera look-at", 6, 7, "EX EY EZ TX TY TZ [FOV]", true, cameraLookAt},
    Command{"camera turn", 2, 2, "RIGHT UP", true, cameraTurn},
    Command{"walk", 0, 0, "", true, walk},
    Command{"fly", 0, 0, "", true, fly},
    Command{"load camera", 1, 1, "FILE", true, loadCamera},
    Command{"load scene", 1, 1, "FILE", true, loadScene},
    Command{"load set", 1, 1, "FILE", true, loadSet},
    Command{"export camera", 1, 5, "FILE [WIDTH HEIGHT ANTIALIASING BLOOM]", true, exportCamera},
    Command{"export scene", 1, 1, "FILE", true, exportScene},
    Command{"screenshot", 1, 1, "FILE", true, screenshot},
    Command{"light", 2, 2, "N on|off", true, light},
    Command{"environment", 1, 1, "N", true, environment},
    Command{"key press", 1, 1, "KEY", true, keyPress},
    Command{"key release", 1, 1, "KEY|all", true, keyRelease},
    Command{"key tap", 1, 1, "KEY", true, keyTap},
    Command{"idle", 1, 1, "on|off", false, idle},
    Command{"wait-idle", 0, 0, "", true, waitIdle},
};

[[noreturn]] void refuseName(const std::string& name) {
    std::vector<std::string_view> names;
    for (const Command& command : kCommands) names.push_back(command.name);
    throw app::UsageError(rtcore::unknownNameMessage("command", name, names));
}

// Two words go before one.
const Command& find(const std::vector<std::string>& words, std::size_t& used) {
    if (words.empty()) throw app::UsageError("the command is empty");
    const std::string two = words.size() > 1 ? words[0] + " " + words[1] : "";
    for (const Command& command : kCommands) {
        used = command.name == two ? 2 : 1;
        if (command.name == two || command.name == words[0]) return command;
    }
    refuseName(two.empty() ? words[0] : two);
}

app::ExitCode exitCodeOf(const std::exception& error) {
    if (const auto* file = dynamic_cast<const rtcore::FileError*>(&error)) return app::exitCodeOf(file->kind);
    if (dynamic_cast<const std::invalid_argument*>(&error) != nullptr) return app::ExitCode::Usage;
    if (dynamic_cast<const app::UsageError*>(&error) != nullptr) return app::ExitCode::Usage;
    const auto* link = dynamic_cast<const ipc::Error*>(&error);
    if (link != nullptr && link->problem == ipc::Problem::NoSpace) return app::ExitCode::TryAgain;
    return app::ExitCode::Failed;
}

} // namespace

Result runCommand(std::string_view text, Session& session, Host& host) {
    const std::vector<std::string> words = app::splitWords(text);
    std::size_t used = 0;
    const Command& command = find(words, used);
    const Words arguments = Words(words).subspan(used);
    if (arguments.size() < command.least || arguments.size() > command.most) {
        const std::string takes = command.most == 0 ? "no arguments" : std::string(command.arguments);
        throw app::UsageError(std::string(command.name) + " takes " + takes);
    }
    if (command.needsScene && !session.ready()) return {.turn = Turn::Again};
    return command.run({session, host, arguments});
}

std::string failureText(const std::exception& error) {
    return std::to_string(static_cast<int>(exitCodeOf(error))) + " " + error.what();
}

} // namespace rtserver

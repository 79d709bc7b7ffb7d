#include "rtserver/session.h"

#include "renderer/settings_merge.h"

#include "rtcore/io/text/set.h"
#include "rtcore/settings/settings_table.h"

#include <stdexcept>
#include <utility>

namespace rtserver {

namespace {

constexpr double kTapSeconds = 0.05; ///< how long a key acts that was released before anybody looked

[[noreturn]] void refuseNumber(const std::string& what, int number, std::size_t count) {
    const std::string has = count == 0   ? "none"
                            : count == 1 ? "only number 0"
                                         : "numbers 0 to " + std::to_string(count - 1);
    throw std::invalid_argument("there is no " + what + " " + std::to_string(number) + "; the scene has " +
                                has);
}

bool isParallel(rtcore::Vec3 a, rtcore::Vec3 b) {
    constexpr float kSine = 1e-5F;
    return length(cross(normalize(a), normalize(b))) < kSine;
}

} // namespace

Session::Session(const Options& options, std::function<void(int, int)> reserve)
    : options_(options), reserve_(std::move(reserve)) {}

std::string Session::title() const { return world_->source.filename().string(); }

rtcore::RenderSettings Session::settingsOf(const World& world, const rtcore::CameraFile* camera) const {
    std::vector<rtcore::SettingAssignment> file;
    if (options_.settingsFile) file = rtcore::readSettingsFile(*options_.settingsFile).live;
    rtcore::RenderSettings settings = renderer::mergeSettings({.scene = world.loaded.live,
                                                               .settingsFile = file,
                                                               .camera = camera,
                                                               .commandLine = options_.settings});
    if (world_ != nullptr) {
        settings.width = settings_.width;
        settings.height = settings_.height;
    }
    return settings;
}

void Session::show(std::unique_ptr<World> world) {
    rtcore::LoadedScene& loaded = world->loaded;
    std::optional<rtcore::CameraFile> camera;
    std::filesystem::path path;
    if (world_ == nullptr && options_.camera) path = *options_.camera;
    if (path.empty() && loaded.sceneFile && loaded.sceneFile->cameraFile)
        path = *loaded.sceneFile->cameraFile;
    if (!path.empty()) {
        camera = rtcore::readCameraFile(path);
        renderer::applyCameraToScene(*camera, path, loaded.scene);
        loaded.camera = camera->camera;
    }
    const rtcore::RenderSettings settings = settingsOf(*world, camera ? &*camera : nullptr);
    reserve_(settings.width, settings.height);
    settings_ = settings;
    world_ = std::move(world);
    flyer_.emplace(loaded.camera, loaded.tree.bounds, loaded.scene.up);
    touch();
}

void Session::setCamera(const rtcore::Camera& camera) {
    const bool finite = isFinite(camera.eye) && isFinite(camera.forward) && isFinite(camera.up);
    if (!finite || normalize(camera.forward) == rtcore::Vec3{})
        throw std::invalid_argument("the camera needs a direction to look in");
    if (isParallel(camera.forward, camera.up))
        throw std::invalid_argument("the camera cannot look straight along its up direction");
    if (!(camera.horizontalFov > 0 && camera.horizontalFov < 180))
        throw std::invalid_argument("the field of view is more than 0 and less than 180 degrees");
    if (camera == flyer_->camera()) return;
    flyer_->setCamera(camera);
    touch();
}

void Session::setSettings(const rtcore::RenderSettings& settings) {
    if (settings.width != settings_.width || settings.height != settings_.height)
        reserve_(settings.width, settings.height);
    settings_ = settings;
    touch();
}

void Session::loadCamera(const std::filesystem::path& path) {
    const rtcore::CameraFile file = rtcore::readCameraFile(path);
    const std::vector<rtcore::SettingAssignment> now = rtcore::settingAssignments(settings_, true);
    rtcore::Scene& scene = world_->loaded.scene;
    const std::vector<rtcore::Light> lights = scene.lights;
    const int environment = scene.activeEnvironment;
    try {
        renderer::applyCameraToScene(file, path, scene);
        setSettings(renderer::mergeSettings({.scene = now, .camera = &file}));
    } catch (...) {
        scene.lights = lights;
        scene.activeEnvironment = environment;
        throw;
    }
    flyer_->setCamera(file.camera);
    touch();
}

void Session::loadSettings(const std::filesystem::path& path) {
    rtcore::RenderSettings settings = settings_;
    rtcore::applySettings(settings, rtcore::readSettingsFile(path).live);
    setSettings(settings);
}

void Session::switchLight(int light, std::optional<bool> on) {
    std::vector<rtcore::Light>& lights = world_->loaded.scene.lights;
    if (light < 0 || static_cast<std::size_t>(light) >= lights.size())
        refuseNumber("light", light, lights.size());
    std::uint32_t& state = lights[static_cast<std::size_t>(light)].on;
    const std::uint32_t wanted = on.value_or(state == 0) ? 1 : 0;
    if (state != wanted) touch();
    state = wanted;
}

void Session::setEnvironment(int environment) {
    rtcore::Scene& scene = world_->loaded.scene;
    if (environment < 0 || static_cast<std::size_t>(environment) >= scene.environments.size())
        refuseNumber("environment", environment, scene.environments.size());
    if (scene.activeEnvironment != environment) touch();
    scene.activeEnvironment = environment;
}

void Session::applyToggles(const ipc::KeyState& keys) {
    const rtcore::Scene& scene = world_->loaded.scene;
    for (int digit = 0; digit <= 9; ++digit) {
        const std::uint32_t presses = keys.pressed('0' + digit);
        if (presses == 0) continue;
        const int number = (digit + 9) % 10; // 1 is the first, 0 the tenth
        if (keys.held('M')) {
            if (static_cast<std::size_t>(number) < scene.environments.size()) setEnvironment(number);
        } else if (presses % 2 == 1 && static_cast<std::size_t>(number) < scene.lights.size()) {
            switchLight(number, std::nullopt);
        }
    }
}

bool Session::applyKeys(const ipc::KeyState& keys, double seconds) {
    applyToggles(keys);
    const std::bitset<kActions> held = actionsOf(keys.down, defaultBindings());
    std::bitset<ipc::kMaxKeys> tappedKeys = keys.down;
    for (int key = 0; key < ipc::kMaxKeys; ++key) {
        if (keys.pressed(key) > 0) tappedKeys.set(static_cast<std::size_t>(key));
    }
    const std::bitset<kActions> tapped = actionsOf(tappedKeys, defaultBindings()) & ~held;
    const auto act = [&](const std::bitset<kActions>& actions, double time) {
        flyer_->releaseAll();
        for (int i = 0; i < kActions; ++i) {
            if (actions[static_cast<std::size_t>(i)]) flyer_->press(static_cast<Action>(i));
        }
        if (flyer_->advance(time)) touch();
        flyer_->releaseAll();
    };
    act(held, seconds);
    if (tapped.any()) act(tapped, kTapSeconds);
    std::bitset<kActions> moving = held;
    moving.reset(static_cast<std::size_t>(Action::Sprint));
    return moving.any();
}

} // namespace rtserver

/// What the server shows and how: the scene, the camera, the settings, the lights. Knows nothing of clients
/// and of frames.
#pragma once

#include "rtserver/keyboard.h"
#include "rtserver/server_options.h"
#include "rtserver/world.h"

#include "rtcore/io/text/cam.h"
#include "rtcore/motion/key_bindings.h"
#include "rtcore/settings/render_settings.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace rtcore {
class Player;
}

namespace rtserver {

/// One thread. What changes the next frame makes it stale().
class Session {
  public:
    /// `reserve` throws when frames of that size cannot be published. `options` must outlive it.
    Session(const Options& options, std::function<void(int, int)> reserve);

    ~Session();

    /// Shows another scene: its camera and its settings, but the frames keep their size. The first one gets
    /// what the command line says of camera, settings and size. Throws FileError, with the old scene still
    /// there.
    void show(std::unique_ptr<World> world);
    bool ready() const { return world_ != nullptr; }
    const World& world() const { return *world_; }
    std::string title() const; ///< for messages

    const rtcore::Camera& camera() const { return camera_; }
    /// Throws std::invalid_argument for one that cannot be looked through.
    void setCamera(const rtcore::Camera& camera);
    /// To the right and upwards, degrees.
    void turn(double right, double upwards);
    /// Throws std::runtime_error where there is no room for a body.
    void setWalking(bool walking);
    bool walking() const;

    const rtcore::RenderSettings& settings() const { return settings_; }
    /// Throws what `reserve` throws, with nothing changed.
    void setSettings(const rtcore::RenderSettings& settings);

    /// Looks through a .cam and takes over what else it says. Throws FileError, with nothing changed.
    void loadCamera(const std::filesystem::path& path);
    /// Takes the table [live] of a .set over. Throws FileError.
    void loadSettings(const std::filesystem::path& path);
    /// Counted from 0. They throw std::invalid_argument when the scene has fewer.
    void switchLight(int light, std::optional<bool> on); ///< nothing: the other way round
    void setEnvironment(int environment);

    /// Lets what was pressed act for the time since the last call, and then hands in what is pressed now.
    void move(std::chrono::nanoseconds time, const ipc::KeyState& keys);
    /// Nothing moves until something is pressed.
    bool atRest() const;
    Keyboard& keyboard() { return keyboard_; }

    bool paused = false;
    bool idles = true; ///< false: every frame is drawn, though it equals the last
    bool stale() const { return stale_; }
    void touch() { stale_ = true; }
    void drawn() { stale_ = false; }

  private:
    rtcore::RenderSettings settingsOf(const World& world, const rtcore::CameraFile* camera) const;
    void apply(const rtcore::ActionTap& tap);
    void takeCamera();

    const Options& options_;
    std::function<void(int, int)> reserve_;
    std::unique_ptr<World> world_;
    std::unique_ptr<rtcore::Player> player_; ///< refers to *world_
    rtcore::Camera camera_;
    rtcore::KeyBindings bindings_;
    rtcore::RenderSettings settings_;
    Keyboard keyboard_;
    bool stale_ = true;
};

} // namespace rtserver

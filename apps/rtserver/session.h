/// What the server shows and how: the scene, the camera, the settings, the lights. Knows nothing of clients
/// and of frames.
#pragma once

#include "rtserver/flying.h"
#include "rtserver/keyboard.h"
#include "rtserver/server_options.h"
#include "rtserver/world.h"

#include "rtcore/io/text/cam.h"
#include "rtcore/settings/render_settings.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace rtserver {

/// One thread. What changes the next frame makes it stale().
class Session {
  public:
    /// `reserve` throws when frames of that size cannot be published. `options` must outlive it.
    Session(const Options& options, std::function<void(int, int)> reserve);

    /// Shows another scene: its camera and its settings, but the frames keep their size. The first one gets
    /// what the command line says of camera, settings and size. Throws FileError, with the old scene still
    /// there.
    void show(std::unique_ptr<World> world);
    bool ready() const { return world_ != nullptr; }
    const World& world() const { return *world_; }
    std::string title() const; ///< for messages

    const rtcore::Camera& camera() const { return flyer_->camera(); }
    /// Throws std::invalid_argument for one that cannot be looked through.
    void setCamera(const rtcore::Camera& camera);
    Flyer& flyer() { return *flyer_; }

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

    /// Lets held keys and taps act: those held for `seconds`. True when any moves the camera.
    bool applyKeys(const ipc::KeyState& keys, double seconds);
    Keyboard& keyboard() { return keyboard_; }

    bool paused = false;
    bool stale() const { return stale_; }
    void touch() { stale_ = true; }
    void drawn() { stale_ = false; }

  private:
    rtcore::RenderSettings settingsOf(const World& world, const rtcore::CameraFile* camera) const;
    void applyToggles(const ipc::KeyState& keys);

    const Options& options_;
    std::function<void(int, int)> reserve_;
    std::unique_ptr<World> world_;
    std::optional<Flyer> flyer_;
    rtcore::RenderSettings settings_;
    Keyboard keyboard_;
    bool stale_ = true;
};

} // namespace rtserver

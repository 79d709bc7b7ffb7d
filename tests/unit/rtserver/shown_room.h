/// A document that shows a room made in memory, and what a server has around it, without ipc.
#pragma once

#include "rtserver/commands/commands.h"
#include "rtserver/commands/key_edits.h"
#include "rtserver/document/light_list.h"
#include "rtserver/document/model_edits.h"
#include "rtserver/document/sky_edits.h"
#include "rtserver/walk/workspace.h"

#include "rtcore/platform/error.h"

#include "support/small_scene.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// A grey floor with a box on it, which is the part "box", the bookmark "door", two lights, of which the
/// first is "left", two environments, "noon" and dusk.hdr; seen from above the floor.
inline rtcore::LoadedScene makeRoom(float albedo = 0.5F) {
    SceneBuilder b;
    rtcore::Material paint = matte(albedo);
    paint.nameOffset = b.buffers.addName("grey");
    const std::uint32_t grey = b.material(paint);
    b.square({0, 0, 0}, {0, 1, 0}, 10, grey);
    b.box({-0.5F, 0, -3}, {0.5F, 1, -2}, grey);
    b.buffers.parts = {{b.buffers.addName("box"), 2, 12}};
    b.scene.lights = {{pointLight({0, 4, 0}, 20), "left"}, pointLight({3, 4, 0}, 20)};
    for (const char* name : {"noon", "dusk"}) {
        b.scene.environments.push_back(std::make_shared<const rtcore::Environment>(
            rtcore::Environment::fromEquirectangular(rtcore::HdrImage(4, 2, {1, 1, 1}), name)));
    }
    rtcore::LoadedScene room;
    room.scene = b.finish();
    room.tree = rtcore::buildKdTree(room.scene.mesh(), {});
    room.camera.eye = {0, 1.8F, 3};
    room.camera.forward = {0, 0, -1};
    room.sceneFile.emplace();
    room.sceneFile->bookmarks = {{"door", room.camera}};
    room.sceneFile->bookmarks[0].camera.eye = {2, 1.8F, 3};
    room.bookmarks = room.sceneFile->bookmarks;
    room.scene.environmentFiles.resize(2);
    room.scene.environmentFiles[0].name = "noon";
    room.scene.environmentFiles[0].files = {"/rooms/noon.hdr"};
    room.scene.environmentFiles[1].files = {"/rooms/dusk.hdr"};
    room.modelPath = "/rooms/room.obj";
    return room;
}

inline std::unique_ptr<rtserver::World> worldOf(rtcore::LoadedScene scene) {
    return std::make_unique<rtserver::World>(std::move(scene), "/rooms/room.scn", rtcore::ImportOptions());
}

inline rtcore::CameraFile cameraFileOf(const rtcore::Camera& camera) {
    rtcore::CameraFile file;
    file.camera = camera;
    return file;
}

/// Notes what commands ask of the server.
class FakeHost final : public rtserver::Host {
  public:
    void load(const std::filesystem::path& path, std::optional<std::filesystem::path> cached) override {
        if (loading) throw std::runtime_error("another scene is being loaded");
        loads.emplace_back(path, std::move(cached));
    }
    void quit() override { quitted = true; }
    bool quits() const override { return quitted; }
    void setParent(std::optional<std::int64_t> process) override { parent = process; }
    const rtserver::FrameMaker& frames() const override { return maker; }
    const rtserver::Messages& messages() const override { return told; }

    rtserver::FrameMaker maker{1};
    rtserver::Messages told;
    bool loading = false, quitted = false;
    std::optional<std::int64_t> parent;
    std::vector<std::pair<std::filesystem::path, std::optional<std::filesystem::path>>> loads;
};

/// Fixture: the document and the walk in it, small frames, and what changed since the last look.
class ShownRoom : public testing::Test {
  protected:
    ShownRoom() {
        options.settings = {{"width", 32}, {"height", 24}, {"antialiasing", 1}};
        options.threads = 1;
    }
    void SetUp() override {
        document.show(worldOf(makeRoom()));
        changes();
    }

    /// Keys edit as they do in a server.
    void move(std::chrono::nanoseconds time, const ipc::KeyState& keys) {
        walk.move(time, keys,
                  [&](const rtcore::ActionTap& tap) { rtserver::editByKey(tap, state, keyHost, messages); });
    }
    /// Since the last call.
    rtcore::Changes changes() { return seen.take(document.revisions()); }
    void reserve(const rtcore::RenderSettings& settings) {
        if (full) throw rtcore::FileError(rtcore::FailureKind::TryAgain, "", "no room for that");
        reserved.emplace_back(settings.width, settings.height);
    }
    bool lightIsOn(std::size_t light) const { return document.scene()->lights.at(light).light.on != 0; }
    int environment() const { return document.scene()->activeEnvironment; }

    rtserver::Options options;
    rtserver::Messages messages;
    bool full = false; ///< no further frame can be reserved
    std::vector<std::pair<int, int>> reserved;
    rtserver::Workspace state{options, [this](const rtcore::RenderSettings& settings) { reserve(settings); },
                              messages};
    rtserver::Document& document = state.document;
    rtserver::Walk& walk = state.walk;
    FakeHost keyHost;
    rtcore::Subscription seen;
};

/// Draws a frame of the document.
inline void draw(rtserver::FrameMaker& frames, const rtserver::Workspace& state,
                 const rtserver::FrameDetail& detail = {}) {
    rtcore::RenderControl control;
    ASSERT_TRUE(frames.trace(state, detail, nullptr, control));
    frames.develop(state.document);
}

} // namespace test

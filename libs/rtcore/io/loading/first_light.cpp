#include "rtcore/io/loading/first_light.h"

#include "rtcore/io/loading/modelled_sky.h"
#include "rtcore/look/visible_points.h"
#include "rtcore/render/visible_scene.h"
#include "rtcore/sky/scene_sky.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

class FirstLight {
  public:
    explicit FirstLight(Loading& loading) : loading_(loading), out_(loading.out) {}

    void give() {
        Scene& scene = out_.scene;
        const LightingOptions& lighting = loading_.options.lighting;
        bool surrounded = lighting.environment || scene.sky;
        if (!out_.sceneFile && (!hasLight() || !ownLightsReach())) {
            hideDomes(loading_);
            surrounded = surrounded || scene.environment() != nullptr;
            // With the domes hidden, the lights may reach after all.
            if (hasLight() && !surrounded && !lighting.preset && !ownLightsReach())
                return lightBeside(lighting.usual);
        }
        if (lighting.preset) return lightByPreset(*lighting.preset, true);
        if (hasLight() || (surrounded && out_.sceneFile)) {
            if (!out_.sceneFile) loading_.take(settingsOf(lighting.usual));
            if (surrounded) loading_.take({{"skyLight.on", true}});
            if (!surrounded && !out_.sceneFile) fillTheDark();
        } else if (surrounded) {
            giveGround();
            addRoomLights(scene, out_.tree, loading_.surveyed());
            loading_.take(settingsOf(LightingPreset::Sky, loading_.surveyed()));
        } else if (out_.sceneFile) {
            addHeadlight(scene, out_.tree.bounds, out_.camera);
            out_.preset = LightingPreset::Headlight;
        } else {
            lightByPreset(lighting.usual);
        }
    }

    /// Adds a light beside the viewer where none reaches what is seen.
    void lightTheDark() {
        Scene& scene = out_.scene;
        if (out_.sceneFile || out_.preset == LightingPreset::Headlight || loading_.options.lighting.preset ||
            shines())
            return;
        const Mesh& mesh = scene.model.mesh;
        const KdTree shown = visibleTree(out_.tree, scene);
        const std::vector<VisiblePoint> places = visiblePoints(shown, mesh, out_.camera);
        if (places.empty() || isOpen(shown, mesh, places) ||
            lightReaches(shown, mesh, lightsOf(scene.lights), places, kPlainAmbient))
            return;
        addHeadlight(scene, out_.tree.bounds, out_.camera);
        loading_.warn(say("no light reaches what is seen; one beside the viewer was added"));
    }

  private:
    void lightByPreset(LightingPreset preset, bool last = false) {
        Scene& scene = out_.scene;
        const PresetLighting lights = presetLighting(preset, out_.tree, scene.model.mesh, loading_.surveyed(),
                                                     out_.camera, loading_.options.lighting.sky);
        lightBy(scene, lights);
        out_.preset = preset;
        loading_.take(settingsOf(preset, loading_.surveyed()), last);
    }

    /// A material gives off light.
    bool shines() const {
        return std::any_of(out_.scene.materials.begin(), out_.scene.materials.end(),
                           [](const Material& m) { return !isBlack(m.emission); });
    }

    bool hasLight() const {
        // A scene lit by its surroundings alone is a choice; one without any light is an oversight.
        const bool chosen =
            out_.sceneFile && (!out_.sceneFile->defaultLight || shines() || !isBlack(out_.scene.ambient));
        return chosen || out_.scene.lights.size() > (loading_.options.lighting.sky ? 1 : 0);
    }

    /// Whether the lights of the model, if it has any, can be noticed where its first camera looks.
    bool ownLightsReach() const {
        const Scene& scene = out_.scene;
        const KdTree shown = visibleTree(out_.tree, scene);
        const std::vector<VisiblePoint> places = visiblePoints(shown, scene.model.mesh, out_.camera);
        return scene.lights.empty() || places.empty() ||
               lightReaches(shown, scene.model.mesh, lightsOf(scene.lights), places, kPlainAmbient);
    }

    /// Beside the lights of the model, which light nothing that is seen. The sun becomes a light like the
    /// others: files put that of a sky behind all, where it has other samples and gives other images.
    void lightBeside(LightingPreset preset) {
        Scene& scene = out_.scene;
        const std::vector<SceneLight> own = std::exchange(scene.lights, {});
        lightByPreset(preset);
        for (SceneLight& each : scene.lights) each.ofSky = false;
        scene.lights.insert(scene.lights.end(), own.begin(), own.end());
        loading_.warn(say("its own lights reach nothing that is seen; other light was added"));
    }

    void giveGround() {
        Scene& scene = out_.scene;
        if (!scene.sky || !wantsGround(scene.model.mesh, loading_.surveyed())) return;
        Sky sky = *scene.sky;
        sky.ground = true;
        setSky(scene, sky);
    }

    /// An object is not half black by its author's only light, before nothing.
    void fillTheDark() {
        Scene& scene = out_.scene;
        if (out_.indoors || loading_.surveyed().inside() || loading_.surveyed().isStage() || shines()) return;
        const auto fill = fillLight(scene, visibleTree(out_.tree, scene), out_.camera);
        if (!fill) return;
        scene.background = *fill;
        loading_.take({{"skyLight.on", true}});
        loading_.warn(
            say("its own lights leave much of what is seen in the dark; a background that lights was added"));
    }

    Loading& loading_;
    LoadedScene& out_;
};

} // namespace

void giveLight(Loading& loading) {
    FirstLight light(loading);
    light.give();
    light.lightTheDark();
}

} // namespace rtcore

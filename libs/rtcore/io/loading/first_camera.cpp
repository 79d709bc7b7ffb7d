#include "rtcore/io/loading/first_camera.h"

#include "rtcore/look/visible_points.h"
#include "rtcore/survey/default_view.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace rtcore {

namespace {

class FirstCamera {
  public:
    explicit FirstCamera(Loading& loading) : loading_(loading), out_(loading.out) {}

    void choose() {
        const Mesh& mesh = out_.scene.model.mesh;
        if (out_.sceneFile) {
            out_.bookmarks = out_.sceneFile->bookmarks;
        } else if (loading_.hasCamera) {
            const std::span<const Camera> cameras = out_.scene.model.cameras;
            const auto shown = std::find_if(cameras.begin(), cameras.end(),
                                            [&](const Camera& camera) { return isFirstView(camera); });
            loading_.hasCamera = shown != cameras.end();
            if (loading_.hasCamera && shown != cameras.begin()) out_.camera = *shown;
            bookmarkCameras(static_cast<std::size_t>(shown - cameras.begin()));
        }
        out_.ownCamera = loading_.hasCamera;
        if (!loading_.hasCamera) out_.camera = defaultCamera(out_.tree, mesh, loading_.surveyed());
        out_.indoors = isEnclosed(out_.tree, mesh, axesOf(out_.scene), out_.camera.eye);
    }

  private:
    /// Whether one who does not know the model sees it by that camera: not so near that most of an object is
    /// beyond the image.
    bool isFirstView(const Camera& camera) {
        constexpr float kMinPart = 0.5F;
        const Mesh& mesh = out_.scene.model.mesh;
        const Axes axes = axesOf(out_.scene);
        const Box3& bounds = loading_.surveyed().subject.bounds;
        if (!showsModel(visiblePoints(out_.tree, mesh, camera), bounds)) return false;
        const bool object = !loading_.surveyed().inside() && !loading_.surveyed().isStage();
        if (!object || isIndoors(out_.tree, mesh, axes, camera.eye)) return true;
        std::vector<VisiblePoint> model =
            visiblePoints(out_.tree, mesh, defaultCamera(out_.tree, mesh, loading_.surveyed()));
        std::erase_if(model, [&](const VisiblePoint& place) { return !bounds.contains(place.position); });
        return partInImage(model, camera) >= kMinPart;
    }

    /// All but the one that is shown, under their names.
    void bookmarkCameras(std::size_t shown) {
        const Model& model = out_.scene.model;
        std::vector<std::string> unused;
        for (std::size_t i = 0; i < model.cameras.size(); ++i) {
            if (i == shown) continue;
            const std::string own(model.name(model.cameras[i].nameOffset));
            std::string name = own.empty() ? "camera " + std::to_string(i + 1) : own;
            for (int n = 2; findBookmark(out_.bookmarks, name) != out_.bookmarks.end(); ++n)
                name = (own.empty() ? "camera" : own) + " " + std::to_string(n);
            if (i < shown) unused.push_back(name);
            out_.bookmarks.push_back({name, model.cameras[i]});
            out_.bookmarks.back().camera.nameOffset = 0;
        }
        if (unused.empty()) return;
        const bool one = unused.size() == 1;
        loading_.warn(say(one ? "its camera {0} shows little or nothing of the model; kept as a bookmark"
                              : "its cameras {0} show little or nothing of the model; kept as bookmarks",
                          firstOf(unused)));
    }

    Loading& loading_;
    LoadedScene& out_;
};

} // namespace

void decideModelUnits(Loading& loading) {
    ModelUnits units;
    if (loading.out.sceneFile) {
        units.up = units.otherUp = loading.out.scene.up;
        units.metresPerUnit = loading.out.scene.metresPerUnit;
        units.upSaid = units.unitSaid = Said::ByScene;
    } else {
        units = guessModelUnits(loading.out.origin, loading.out.tree, loading.out.scene.model);
    }
    units = withUserSays(units, loading.options.import.up, loading.options.import.metresPerUnit);
    // A camera of the model's or the scene's own knows what is up, unless the user knows better.
    if (loading.hasCamera && units.upSaid == Said::ByUser && units.up != loading.out.scene.up)
        loading.out.camera.up = upwardsOf(loading.out.camera.forward, units.up);
    loading.out.units = units;
    loading.out.scene.up = units.up;
    loading.out.scene.metresPerUnit = units.metresPerUnit;
}

void chooseCamera(Loading& loading) { FirstCamera(loading).choose(); }

} // namespace rtcore

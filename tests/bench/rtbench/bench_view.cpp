#include "bench/rtbench/bench_view.h"

#include "rtcore/io/text/strict_table.h"
#include "rtcore/io/text/text_file.h"
#include "rtcore/io/text/toml_parser.h"
#include "rtcore/survey/default_view.h"

#include <algorithm>
#include <cmath>

namespace rtbench {

using rtcore::Vec3;

namespace {

constexpr float kRadiansPerDegree = 0.01745329252F;
constexpr rtcore::Limits kFieldOfView{
    .minimum = 1, .maximum = 179, .minimumExcluded = false, .maximumExcluded = false};

BenchView readView(rtcore::StrictTable& table) {
    const auto name = table.text("name");
    const auto eye = table.vector("eye");
    const auto at = table.vector("at");
    const auto up = table.vector("up");
    const auto fov = table.number("fov", kFieldOfView);
    const auto light = table.vector("light");
    table.finish();
    BenchView view;
    view.name = name.value_or("");
    view.eye = table.require("eye", eye);
    view.at = table.require("at", at);
    view.up = up.value_or(view.up);
    view.fov = fov.value_or(view.fov);
    view.light = table.require("light", light);
    const Vec3 across = cross(normalize(view.at - view.eye), normalize(view.up));
    if (!(length(across) > 1e-5F)) table.fail("at", "eye and at are the same, or one above the other");
    return view;
}

} // namespace

rtcore::Camera BenchView::camera(float aspect) const {
    rtcore::Camera camera;
    camera.eye = eye;
    camera.forward = at - eye;
    camera.up = up;
    const float half = std::tan(fov * 0.5F * kRadiansPerDegree) * aspect;
    camera.horizontalFov = 2 * std::atan(half) / kRadiansPerDegree;
    return camera;
}

ViewFile::ViewFile(const std::filesystem::path& path) {
    const std::string name = path.string();
    const rtcore::TextValue content = rtcore::parseToml(rtcore::readShortText(path), name);
    rtcore::StrictTable root(content, name);
    root.checkVersion();
    std::vector<rtcore::StrictTable> tables = root.tables("view");
    root.finish();
    for (rtcore::StrictTable& table : tables) {
        const std::string scene = table.require("scene", table.text("scene"));
        entries_.push_back({rtcore::pathFromUtf8(scene).stem().string(), readView(table)});
    }
}

std::vector<BenchView> ViewFile::viewsOf(const std::filesystem::path& model) const {
    std::vector<BenchView> views;
    for (const Entry& entry : entries_) {
        if (entry.stem == model.stem().string()) views.push_back(entry.view);
    }
    return views;
}

BenchView makeView(const rtcore::LoadedScene& loaded) {
    const rtcore::Scene& scene = loaded.scene;
    const rtcore::Camera camera =
        loaded.sceneFile
            ? loaded.camera
            : rtcore::defaultCamera(loaded.tree, scene.mesh(),
                                    rtcore::survey(loaded.tree, scene.mesh(), rtcore::axesOf(scene)));
    BenchView view;
    view.eye = camera.eye;
    view.at = camera.eye + camera.forward;
    view.up = camera.up;
    view.fov = std::clamp(camera.horizontalFov, 1.0F, 120.0F);
    view.light = rtcore::defaultLight(camera, loaded.tree.bounds).position;
    const auto hasPosition = [](const rtcore::Light& light) { return traitsOf(light).position; };
    const auto placed = std::ranges::find_if(scene.lights, hasPosition, &rtcore::SceneLight::light);
    if (loaded.sceneFile && placed != scene.lights.end()) view.light = placed->light.position;
    return view;
}

} // namespace rtbench

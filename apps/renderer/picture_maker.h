/// One loaded scene, and the images that are made of it.
#pragma once

#include "renderer/frame_list.h"
#include "renderer/preview.h"
#include "renderer/renderer_options.h"
#include "renderer/shared_light.h"

#include "common/progress/progress.h"

#include "rtcore/io/scene_loader.h"
#include "rtcore/io/text/cam.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/neural/nets.h"
#include "rtcore/post/develop.h"
#include "rtcore/render/image_renderer.h"
#include "rtcore/render/light_meter.h"
#include "rtcore/render/section_tracer.h"
#include "rtcore/sections/cap_painter.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace renderer {

struct FrameReport {
    int width = 0, height = 0;
    std::uint64_t samples = 0; ///< of an image that does without some of them: all that it could take
    double renderSeconds = 0, writeSeconds = 0;
    rtcore::RayStatistics rays;
    rtcore::NetReport net;
    rtcore::RenderSettings settings; ///< with the net that was chosen
};

/// Not for several threads at once: it uses all of them itself.
class PictureMaker {
  public:
    /// `settingsFile` holds what --set names. `options` and `progress` must outlive it.
    PictureMaker(rtcore::LoadedScene scene, std::vector<rtcore::SettingAssignment> settingsFile,
                 const RendererOptions& options, app::Progress& progress);

    /// Images rendered from now on are shown there while they refine; null: nowhere.
    void showOn(Preview* preview) { preview_ = preview; }

    /// The list whose frames are rendered, whichever of them: by its first camera the exposures of a
    /// recording are scaled, and the light that its images share is learned of all. Without one, each camera
    /// stands for itself.
    void setList(std::vector<std::filesystem::path> cameras) { list_ = std::move(cameras); }
    /// The first camera of a list that still grows.
    void setFirstOfList(const std::filesystem::path& camera) { firstOfList_ = camera; }

    /// Whether each image finds its exposure by itself: it is neither fixed nor said by an option, and those
    /// of .cam files count.
    bool findsExposures() const;
    /// What suits the images of these cameras, of one film, found by small ones, and brought to the light of
    /// Whitted's rays as recorded exposures are: the first camera is that of the film. Throws as make() does.
    std::vector<float> findExposures(const std::vector<std::filesystem::path>& cameras);

    /// makeLight() of the views of the list; without one, of that .cam file, or, if it is "", of views from
    /// all over the model.
    void makeLight(const std::filesystem::path& camera, const std::filesystem::path& path);

    /// Reads the net that denoises, if any, before a list is begun: each of its frames needs the same. Throws
    /// what Nets::of() throws; UsageError for a list that leaves the choice to the machine.
    void readNet();

    const rtcore::LoadedScene& loaded() const { return loaded_; }
    /// Of the model without its hidden parts.
    const rtcore::RayTracer& surfaces() const { return *surfaces_; }

    /// The scene as it is shown by that camera in place of its own, cut by `sections` alone, from now on. It
    /// is white where nothing is seen. Valid until the next image. Throws as make() does.
    const rtcore::LdrImage& picture(const rtcore::Camera& camera, int width, int height,
                                    const rtcore::SectionPlanes& sections);

    /// Renders the frame and writes all its outputs, each one complete or not at all; `index` of `count` is
    /// for the progress. Throws rtcore::FileError: a bad .cam, an output that cannot be written, Stopped.
    FrameReport make(const FrameTask& task, int index, int count);

    /// rtcore::writeDebugScene() of the view of a .cam file; "": the scene's camera.
    void writeDebugScene(const std::filesystem::path& camera, const std::filesystem::path& path);

    /// The last frame as it is shown, if it was filmed or written into a file that holds such images.
    const rtcore::LdrImage& developed() const { return developed_; }

  private:
    /// A camera, with the settings of all places.
    struct Shot {
        rtcore::Camera camera;
        rtcore::RenderSettings settings;
        bool recorded = false; ///< its exposure is that of the .cam file
    };

    /// The shot of a .cam file, which switches lights on and off; "": that of the scene itself.
    Shot prepare(const std::filesystem::path& cameraFile);
    void makePanorama(int width, Shot& shot) const;
    /// loaded_, for false colours, until the next prepare().
    void useOneUnit(const rtcore::RenderSettings& settings);
    void shareScale(const FrameTask& task, Shot& shot);
    /// The same for a frame, with the noise and the exposure that its list gives it.
    Shot prepare(const FrameTask& task);
    /// The same without any camera's.
    rtcore::RenderSettings ownSettings() const;
    rtcore::ExposureMode measured() const;
    /// The factor by which recorded exposures are scaled, for images of that camera or of its list.
    float recordedScale(const std::filesystem::path& cameraFile);
    float findExposure(const Shot& shot, rtcore::RenderControl& control);
    /// On what --focus-at names, if it does.
    void focus(const rtcore::Camera& camera, rtcore::RenderSettings& settings);
    /// Reads the net that the settings ask for, before any light is traced, which would be lost where there
    /// is none; in place of "automatic", they get what is there.
    void chooseNet(rtcore::RenderSettings& settings);
    void checkDigest(rtcore::Net net) const;
    void chooseNetByItself(rtcore::RenderSettings& settings);
    void useNet(const std::shared_ptr<const rtcore::UNet>& net);
    void render(const rtcore::Camera& camera, const rtcore::RenderSettings& settings, int index, int count);
    /// Light that the images of the run share goes into the renderers. `task`, whose lights are on, is of the
    /// image at hand.
    void shareLight(const FrameTask& task, const rtcore::RenderSettings& settings);
    std::vector<LightView> viewsOfList(const rtcore::Scene& lit);
    std::vector<LightView> viewsAllOver(const rtcore::RenderSettings& settings) const;
    void addGroundShadow(const rtcore::Camera& camera, const rtcore::RenderSettings& settings, int index,
                         int count);
    /// The frame with its effects, which take long where a net is among them.
    const rtcore::HdrImage& finish(const rtcore::RenderSettings& settings, int index, int count);
    void tell(const std::vector<rtcore::ImageRemark>& remarks);
    /// Once: of parts that have no caps.
    void tellOfOpenParts();
    /// The exposure; nothing is done when no output is wanted.
    float develop(const FrameTask& task, const Shot& shot, const rtcore::HdrImage& radiance);
    void write(const FrameTask& task, const rtcore::HdrImage& radiance,
               const rtcore::RenderSettings& settings);

    rtcore::LoadedScene loaded_;
    std::vector<rtcore::SceneLight> lights_; ///< as the scene has them, before a .cam switches any
    int environment_;
    std::vector<rtcore::SettingAssignment> settingsFile_;
    const RendererOptions& options_;
    app::Progress& progress_;
    Preview* preview_ = nullptr;
    std::vector<std::filesystem::path> list_;
    std::filesystem::path firstOfList_;
    SharedLight sharedLight_;
    std::optional<float> white_; ///< the light on what the frame shows, where its exposure is by that
    std::optional<rtcore::Scene> asLoaded_;        ///< what useOneUnit() changed
    rtcore::LuminanceUnit unit_;                   ///< of the image at hand
    std::optional<rtcore::ValueScale> valueScale_; ///< of false colours of a list, once it is known
    bool warnedOfUnit_ = false;
    std::optional<float> scale_;   ///< of recorded exposures, once it is known
    bool toldOfScene_ = false;     ///< what there is to tell in detail
    bool toldOfNet_ = false;       ///< that there is none
    bool warned_ = false;          ///< that a .cam is of another scene
    bool warnedOfUnused_ = false;  ///< of settings
    bool toldOfOpenParts_ = false; ///< that sections cut
    rtcore::KdTree tree_;          ///< of what is shown
    std::shared_ptr<const rtcore::KdRayTracer> surfaces_;
    rtcore::SectionSurfaces sections_; ///< of the image before, whose planes are mostly those of the next
    // Kept, so that their memory is reused.
    rtcore::ImageRenderers images_;
    rtcore::LightMeter meter_;
    rtcore::Nets nets_;
    rtcore::PictureDeveloper developer_;
    rtcore::Frame frame_;
    rtcore::LdrImage developed_;
    std::optional<rtcore::Backdrop> backdrop_;
    std::shared_ptr<const rtcore::SkyGround> shadowGround_; ///< null: none was needed yet
    rtcore::CapPainter caps_;
};

} // namespace renderer

#include "renderer/stand_by.h"

#include "renderer/frame_run.h"
#include "renderer/load_phases.h"
#include "renderer/picture_maker.h"
#include "renderer/requests.h"

#include "common/process/stop.h"

#include "rtcore/io/text/scn.h"
#include "rtcore/platform/error.h"

#include <memory>
#include <optional>
#include <system_error>
#include <utility>

namespace renderer {

namespace {

/// A file as it was.
struct FileStamp {
    std::filesystem::path path;
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;

    explicit FileStamp(std::filesystem::path file) : path(std::move(file)) {
        std::error_code error;
        time = std::filesystem::last_write_time(path, error);
        size = std::filesystem::file_size(path, error);
    }
    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// Those are compared by what they say.
bool isDescription(const std::filesystem::path& scene) { return scene.extension() == ".scn"; }

/// All that the scene is made of; without the view where the request has its own, and no light is placed by
/// that of the scene.
std::string descriptionOf(const Request& request, const rtcore::LightingOptions& lighting) {
    if (!isDescription(request.scene)) return request.scene.string();
    rtcore::SceneFile file = rtcore::readSceneFile(request.scene);
    file.bookmarks.clear();
    file.measures = {};
    file.notes.clear();
    if (!request.camera.empty() && !file.defaultLight && !lighting.preset) {
        file.camera.reset();
        file.cameraFile.reset();
    }
    return rtcore::formatSceneFile(file, "/scene.scn");
}

/// The scene that was asked for last.
class OpenScene {
  public:
    OpenScene(const RendererOptions& options, const std::vector<rtcore::SettingAssignment>& settings,
              app::Progress& progress)
        : options_(options), settings_(settings), progress_(progress) {}

    void render(const Request& request, Preview& preview) {
        std::string description = descriptionOf(request, options_.lighting);
        if (maker_ == nullptr || description != description_ || changed()) {
            maker_.reset(); // its memory first
            options_.scene = request.scene;
            rtcore::LoadedScene loaded = loadWithProgress(options_, progress_);
            stamps_.clear();
            for (const std::filesystem::path& file : loaded.files)
                if (file != request.scene || !isDescription(file)) stamps_.emplace_back(file);
            const auto ofScene = loaded.sceneFile ? loaded.sceneFile->cameraFile : std::nullopt;
            ownCamera_ = ofScene.value_or("");
            maker_ = std::make_unique<PictureMaker>(std::move(loaded), settings_, options_, progress_);
            description_ = std::move(description);
        }
        preview.setRun(request.run);
        maker_->showOn(&preview);
        const std::filesystem::path& camera = request.camera.empty() ? ownCamera_ : request.camera;
        FrameRun(options_, progress_, *maker_).renderOne(singleFrame(camera, {}));
    }

  private:
    bool changed() const {
        for (const FileStamp& stamp : stamps_)
            if (!(FileStamp(stamp.path) == stamp)) return true;
        return false;
    }

    RendererOptions options_;
    const std::vector<rtcore::SettingAssignment>& settings_;
    app::Progress& progress_;
    std::string description_;
    std::filesystem::path ownCamera_; ///< .cam that the scene names
    std::vector<FileStamp> stamps_;   ///< of the files that it was loaded from, but for the description
    std::unique_ptr<PictureMaker> maker_;
};

} // namespace

app::ExitCode standBy(const RendererOptions& options, const std::vector<rtcore::SettingAssignment>& settings,
                      Preview& preview, app::Progress& progress) {
    OpenScene scene(options, settings, progress);
    std::optional<Request> request =
        Request{options.preview->run, options.scene, options.camera.value_or("")};
    Requests requests;
    while (request) {
        try {
            scene.render(*request, preview);
        } catch (const rtcore::FileError&) {
            // What is not wanted any more may have lost its files, too.
            if (app::stopSignal() != 0 || !requests.pending()) throw;
        }
        request = requests.next();
    }
    app::beginWork();
    app::throwIfStopped();
    return app::ExitCode::Done;
}

} // namespace renderer

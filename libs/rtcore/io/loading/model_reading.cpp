#include "rtcore/io/loading/model_reading.h"

#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/import/import_report.h"
#include "rtcore/platform/error.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace rtcore {

namespace {

class ModelReading {
  public:
    explicit ModelReading(Loading& loading) : loading_(loading), out_(loading.out) {}

    void read(const std::filesystem::path& path, InputFile file, FileKind kind, const ImportOptions& import) {
        Scene& scene = out_.scene;
        out_.modelPath = path;
        out_.files.push_back(path);
        if (kind == FileKind::Bsp) {
            take(readBsp(file.read(), path.string()));
            out_.modelFiles = {std::filesystem::absolute(path)};
            if (import.pose.value_or(PoseChoice{}) != PoseChoice{})
                loading_.warn(say("a .bsp has the pose that it was built in, so the pose {0} is passed over",
                                  poseText(*import.pose)));
        } else if (!loadBuilt()) {
            loading_.begin(LoadPhase::ImportingModel);
            ImportedModel imported = importModel(path, import);
            for (const Sentence& warning : imported.report.warnings) loading_.warn(warning);
            out_.origin = std::move(imported.report.origin);
            out_.modelFiles.assign(imported.report.files.begin(), imported.report.files.end());
            out_.files.insert(out_.files.end(), out_.modelFiles.begin(), out_.modelFiles.end());
            scene.model = std::move(imported.model);
        }
        if (out_.tree.nodes.empty()) {
            loading_.begin(LoadPhase::BuildingTree);
            out_.tree = buildKdTree(scene.model.mesh, buildOptions(scene.model.mesh.triangles.size()),
                                    &out_.buildTimes, loading_.options.buildProgress);
        }
        scene.origin = out_.origin.zero;
        scene.materials.assign(scene.model.materials.begin(), scene.model.materials.end());
        if (!scene.model.cameras.empty()) {
            out_.camera = scene.model.cameras.front();
            loading_.hasCamera = true;
        }
    }

  private:
    void take(BspContent content) {
        for (const std::string& line : content.warnings) loading_.warn(readWarning(line));
        out_.origin = std::move(content.origin);
        out_.scene.model = std::move(content.model);
        if (content.tree) out_.tree = std::move(*content.tree);
    }

    bool loadBuilt() {
        if (!loading_.options.cachedModel) return false;
        try {
            take(readBsp(openFileBytes(*loading_.options.cachedModel),
                         loading_.options.cachedModel->string()));
            out_.files.push_back(*loading_.options.cachedModel);
            return true;
        } catch (const FileError& error) {
            out_.warnings.push_back(error.sentence());
            return false;
        }
    }

    /// The exact tree saves about a sixth of the time of each ray and costs several times that of the quick
    /// one, whose leaves are large.
    BuildOptions buildOptions(std::size_t triangles) {
        constexpr std::uint64_t kRaysPerTriangle = 4;
        constexpr int kQuick = 3;
        constexpr float kQuickIntersectionCost = 0.05F;
        BuildOptions build = loading_.options.build;
        const bool few =
            loading_.options.primaryRays > 0 && loading_.options.primaryRays < kRaysPerTriangle * triangles;
        if (few && triangles > kFastTreeTriangles) {
            out_.fastTree = true;
            build.method = BuildMethod::Fast;
            build.fastQuality = kQuick;
            build.intersectionCost = kQuickIntersectionCost;
        }
        return build;
    }

    Loading& loading_;
    LoadedScene& out_;
};

} // namespace

void readModel(Loading& loading, const std::filesystem::path& path, InputFile file, FileKind kind,
               const ImportOptions& import) {
    ModelReading(loading).read(path, std::move(file), kind, import);
}

void takeModelLights(Scene& scene) {
    for (const Light& light : scene.model.lights)
        scene.lights.emplace_back(light, std::string(scene.model.name(light.nameOffset)));
}

} // namespace rtcore

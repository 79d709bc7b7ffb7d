#include "rtcore/io/loading/loading.h"

#include "rtcore/platform/sentence.h"

#include "rtcore/sky/scene_sky.h"

#include <utility>

namespace rtcore {

void Loading::begin(LoadPhase phase) const {
    if (options.onPhase) options.onPhase(phase);
}

void Loading::warn(const Sentence& warning) {
    out.warnings.push_back(say("{0}: {1}", out.modelPath.string(), warning));
}

void Loading::take(const std::vector<SettingAssignment>& settings, bool last) {
    for (auto* const all : {&out.live, &out.still})
        all->insert(last ? all->end() : all->begin(), settings.begin(), settings.end());
}

void Loading::addFile(const EnvironmentFile& file, Environment environment) {
    out.files.insert(out.files.end(), file.files.begin(), file.files.end());
    addEnvironment(out.scene, file, std::move(environment));
}

const Survey& Loading::surveyed() {
    if (!survey_) survey_ = survey(out.tree, out.scene.model.mesh, axesOf(out.scene));
    return *survey_;
}

} // namespace rtcore

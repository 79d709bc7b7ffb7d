/// A scene on its way from a file to a LoadedScene.
#pragma once

#include "rtcore/io/scene_loader.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/survey/survey.h"

#include <optional>
#include <vector>

namespace rtcore {

/// The state that the steps of loading hand on, in the order in which loadScene() takes them. One thread.
class Loading {
  public:
    /// `given` must outlive it.
    explicit Loading(const LoadOptions& given) : options(given) {}

    const LoadOptions& options;
    LoadedScene out;
    bool hasCamera = false;          ///< of the scene's or the model's own
    std::optional<Sky> describedSky; ///< by the .scn

    void begin(LoadPhase phase) const;
    /// Under the name of the model.
    void warn(const Sentence& warning);
    /// Files' own assignments stand behind what follows from them, and before what the user says, which comes
    /// last.
    void take(const std::vector<SettingAssignment>& settings, bool last = false);
    void addFile(const EnvironmentFile& file, Environment environment);
    /// By the up axis and the unit that are decided: once, when it is first asked for.
    const Survey& surveyed();

  private:
    std::optional<Survey> survey_;
};

} // namespace rtcore

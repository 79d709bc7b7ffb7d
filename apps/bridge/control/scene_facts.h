/// The facts of a scene that panels show, as pages get them: all at first, then the changes.
#pragma once

#include "common/commands/state_report.h"

#include "ipc/layout/status.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bridge {

/// One thread.
class SceneFacts {
  public:
    /// The answer to `state`. False: it is none.
    bool read(std::string_view report);
    /// Forgets a server that is gone.
    void clear();
    bool known() const { return known_; }

    /// All keys of the event `state` but the session's own (`mayUndo`, `mayRedo`).
    const nlohmann::json& all() const { return all_; }
    /// Those that the last read() changed; of `values` only what changed. Empty: none.
    const nlohmann::json& changes() const { return changes_; }

    const std::vector<std::string>& bookmarks() const { return bookmarks_; }
    const std::vector<std::string>& flights() const { return flights_; }
    const std::vector<std::string>& variants() const { return variants_; }
    std::size_t notes() const { return notes_; }   ///< how many
    std::size_t lights() const { return lights_; } ///< how many
    bool hasSky() const { return hasSky_; }
    const app::ReportedEdit& undo() const { return undo_; }
    const app::ReportedEdit& redo() const { return redo_; }
    /// As text that the server reads; "": not known.
    std::string settingText(const std::string& name) const;

  private:
    bool known_ = false;
    nlohmann::json all_ = nlohmann::json::object(), changes_ = nlohmann::json::object();
    std::vector<std::string> bookmarks_, flights_, variants_;
    std::size_t notes_ = 0;
    std::vector<rtcore::SettingAssignment> settings_;
    app::ReportedEdit undo_, redo_;
    std::size_t lights_ = 0;
    bool hasSky_ = false;
};

/// The traits of each kind of light, with its name.
nlohmann::json lightKindsJson();
nlohmann::json sceneJson(const app::StateReport& state);
/// The event `status`.
nlohmann::json statusJson(const ipc::Status& status);
/// Events `message` of lines as `messages` answers them, with the details of that answer, without folders.
std::vector<nlohmann::json> messageEvents(std::string_view lines, std::string_view details = {});
/// The text with folders cut from the paths in it.
std::string withoutFolders(std::string_view text);

} // namespace bridge

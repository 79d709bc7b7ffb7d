/// The answer to the command `state`: all that a panel shows, of one moment, as TOML (docs/protocol.md).
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/math/box.h"
#include "rtcore/scene/camera.h"
#include "rtcore/settings/settings_table.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct NamedSwitch {
    bool on = false;
    std::string name; ///< may be empty
    friend bool operator==(const NamedSwitch&, const NamedSwitch&) = default;
};

struct ReportedLight {
    int id = 0; ///< unique
    bool on = false;
    std::string name; ///< may be empty
    /// As a .scn of version 2 has it; nothing where very many would be too long.
    std::optional<rtcore::LightDescription> description = {};
    /// As rtcore::powerOf() counts it; nothing where the description tells it. Of a luminaire it takes the
    /// file.
    std::optional<float> power = {};
    friend bool operator==(const ReportedLight&, const ReportedLight&) = default;
};

/// The environment map that is shown, where it is one of a file.
struct ReportedMap {
    float rotation = 0; ///< degrees
    float strength = 1; ///< factor
    friend bool operator==(const ReportedMap&, const ReportedMap&) = default;
};

/// An edit that undo takes back, or redo makes again.
struct ReportedEdit {
    int number = 0; ///< none is given twice while the server runs; 0: there is no such edit
    int person = 0; ///< for whom the asking client made it, by the command `by`; 0: for none, or another did
    friend bool operator==(const ReportedEdit&, const ReportedEdit&) = default;
};

/// A camera path of the scene.
struct ReportedFlight {
    std::string name;   ///< not empty
    double seconds = 0; ///< of the whole
    rtcore::FlightTiming timing = rtcore::FlightTiming::Even;
    bool closed = false, turntable = false;
    int keyCount = 0;
    std::vector<int> keyTimes = {}; ///< milliseconds; of kMaxReportedKeys of all flights, the first ones
    friend bool operator==(const ReportedFlight&, const ReportedFlight&) = default;
};
inline constexpr std::size_t kMaxReportedKeys = 1500;

struct StateReport {
    std::string scene;                     ///< absolute path of the scene or model
    rtcore::Vec3 up{0, 1, 0};              ///< one of the six axes
    float metresPerUnit = 1;               ///< above 0
    rtcore::LocalOrigin origin = {};       ///< from which all positions in here count
    std::vector<ReportedLight> lights;     ///< in the scene's order; the first ones of very many
    int sun = 0;                           ///< id of the light of the sky; 0: there is none
    std::vector<NamedSwitch> environments; ///< at most one is on; the last one is the sky, if any
    std::optional<ReportedMap> map = {};   ///< nothing where none of a file is shown
    std::optional<rtcore::Sky> sky = {};
    rtcore::Box3 bounds = {}; ///< of the model, all parts of it
    rtcore::SectionPlanes sections = {};
    rtcore::KeptMeasures measures = {};              ///< the first ones of very many
    int measureCount = 0;                            ///< of all
    rtcore::SceneNotes notes = {};                   ///< the first ones of very many; without their views
    int noteCount = 0;                               ///< of all
    bool notesShortened = false;                     ///< texts of more than kShortNote bytes
    rtcore::Camera camera;                           ///< nameOffset is 0
    std::vector<rtcore::SettingAssignment> settings; ///< all of them
    std::string undo = {}, redo = {};                ///< what these would do; "": there is nothing
    ReportedEdit undoEdit = {}, redoEdit = {};       ///< the same edits
    std::vector<std::string> bookmarks = {};         ///< names; none where there are very many
    std::vector<std::string> bookmarkViews = {};     ///< a word each: the same word, the same view
    std::vector<ReportedFlight> flights = {};        ///< none where there are very many lights
    std::vector<std::string> variants = {};          ///< names; none where there are very many lights
    std::string variant = {};                        ///< the one that is active; "": none
    bool modified = false;                           ///< there is something to save, other than the camera
    int edits = 0;                                   ///< made and not taken back, since the scene was loaded
    bool indoors = false;                            ///< the scene's own view is from inside
    friend bool operator==(const StateReport&, const StateReport&) = default;
};

/// Where there is no room for all: bytes of a note's text, whose last character is an ellipsis then.
inline constexpr std::size_t kShortNote = 240;

/// Bytes of names that are no UTF-8 are shown as `\xNN`. At most `max` bytes: where that is too little texts
/// of notes are shortened, then notes and measures left out from the end, or, where that does not do, the
/// descriptions of lights are left out, then names, then lights and environments from the end. Throws
/// std::runtime_error where even that does not do.
std::string formatStateReport(const StateReport& state, std::size_t max);

/// Throws rtcore::FileError BadData.
StateReport parseStateReport(std::string_view text);

} // namespace app

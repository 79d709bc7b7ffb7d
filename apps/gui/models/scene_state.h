/// The server's scene, settings, lights, environment maps and edits, as it reports and the panels show them.
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/math/box.h"

#include <QList>
#include <QMap>
#include <QSizeF>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace gui {

struct NamedSwitch {
    bool on = false;
    QString name; ///< may be empty
    friend bool operator==(const NamedSwitch&, const NamedSwitch&) = default;
};

struct ShownLight {
    int id = 0;
    bool on = false;
    QString name;                                             ///< may be empty
    std::optional<rtcore::LightDescription> description = {}; ///< nothing where there are very many lights
    std::optional<float> power = {};                          ///< as app::ReportedLight
    friend bool operator==(const ShownLight&, const ShownLight&) = default;
};

/// The environment map of a file, while it is shown.
struct ShownMap {
    float rotation = 0; ///< degrees
    float strength = 1; ///< factor
    friend bool operator==(const ShownMap&, const ShownMap&) = default;
};

/// A camera path that is kept with the scene.
struct ShownFlight {
    QString name;
    double seconds = 0;
    rtcore::FlightTiming timing = rtcore::FlightTiming::Even;
    bool closed = false, turntable = false;
    int keyCount = 0;
    std::vector<int> keyTimes = {}; ///< milliseconds; of very many the first ones
    friend bool operator==(const ShownFlight&, const ShownFlight&) = default;
};

struct SceneState {
    QString up;                      ///< "+y"
    float metresPerUnit = 1;         ///< above 0
    rtcore::LocalOrigin origin;      ///< from which positions count
    QMap<QString, QString> settings; ///< name to value, both as `settings` writes them
    QList<ShownLight> lights;
    int sun = 0;                     ///< id of the light of the sky, whose map shows it, too; 0: none
    QList<NamedSwitch> environments; ///< at most one is on; the last one is the sky, if any
    std::optional<ShownMap> map;     ///< nothing where none of a file is shown
    std::optional<rtcore::Sky> sky;
    rtcore::Box3 bounds; ///< of the model; empty: it has none
    rtcore::SectionPlanes sections;
    rtcore::KeptMeasures measures; ///< the first ones of very many
    int measureCount = 0;          ///< of all
    rtcore::SceneNotes notes;      ///< the first ones of very many; without their views
    int noteCount = 0;             ///< of all
    bool notesShortened = false;   ///< long texts
    float parallelWidth = 0;       ///< of a view without perspective that rests; 0: it has one
    float framedAspect = 0;        ///< of the image that this is the width of; 0: of any
    QString undo, redo;            ///< the steps that these would make (editLabel()); empty: none
    QStringList bookmarks;         ///< names of the scene's own
    QStringList bookmarkViews;     ///< a word each: the same word, the same view
    std::vector<ShownFlight> flights;
    QStringList variants;  ///< names
    QString variant;       ///< the one that is active; empty: none
    bool modified = false; ///< there is something to save, other than the camera
    int edits = 0;         ///< made and not taken back
    bool indoors = false;  ///< the scene's own view is from inside
    friend bool operator==(const SceneState&, const SceneState&) = default;
};

/// Of an image of that size: scene units between its left and right edge; 0: it has perspective.
double parallelWidth(const SceneState& state, const QSizeF& image);

/// Null when there is none.
const ShownLight* lightOf(const SceneState& state, int id);

/// Width or height, which follow the window and have no usual value.
bool isPictureSize(const QString& setting);

/// The server's report on the scene that it shows.
struct StateAnswer {
    QString scene; ///< absolute path
    SceneState state;
};

/// The answer to the command `state`; nothing when it is none.
std::optional<StateAnswer> readState(const QString& answer);

} // namespace gui

/// THE table of commands: what a user of CUI types and what a client sends to a server. CUI, its completion,
/// its manual page, the server, the window, the bridge, its page and their documents read it. It knows
/// neither rays nor sockets.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// In the order of the table.
enum class CommandId {
    Status,
    Fps,
    Watch,
    List,
    Free,
    About,
    Script,
    Render,
    Ping,
    Exit,
    Quit,
    Parent,
    Pause,
    Resume,
    Idle,
    FrameTime,
    RestLight,
    Messages,
    WaitIdle,
    Resolution,
    Set,
    Get,
    Defaults,
    Quality,
    Settings,
    State,
    Undo,
    Redo,
    Also,
    By,
    Visitor,
    CameraGet,
    CameraSet,
    CameraOrthographic,
    CameraLookAt,
    CameraTurn,
    CameraPivot,
    CameraOrbit,
    CameraPan,
    CameraApproach,
    CameraFit,
    CameraView,
    CameraReset,
    CameraPaste,
    CameraAngle,
    CameraLens,
    CameraZoom,
    Up,
    Units,
    Focus,
    Speed,
    Walk,
    Fly,
    LoadCamera,
    LoadScene,
    LoadSet,
    Save,
    SaveAs,
    Pack,
    PackProgress,
    PackStop,
    ExportCamera,
    ExportScene,
    ExportVideoStart,
    ExportVideo,
    ExportVideoStop,
    Play,
    PlayStop,
    Screenshot,
    Bloom,
    Light,
    LightGet,
    LightAdd,
    LightCopy,
    LightRemove,
    LightMove,
    LightAim,
    LightColour,
    LightTemperature,
    LightPower,
    LightKind,
    LightSize,
    LightAngles,
    LightMirrored,
    LightTurn,
    LightFile,
    LightName,
    Environment,
    EnvironmentOpen,
    EnvironmentNone,
    EnvironmentRotation,
    EnvironmentStrength,
    Sky,
    SkyHour,
    SkyDate,
    SkyPlace,
    SkyNorth,
    SkyDirection,
    SkyTurbidity,
    SkyStrength,
    SkyGround,
    SkyHaze,
    Look,
    Lights,
    Environments,
    Scene,
    Bookmarks,
    BookmarkAdd,
    BookmarkGo,
    BookmarkRename,
    BookmarkMove,
    BookmarkRemove,
    Materials,
    MaterialGet,
    MaterialPresets,
    MaterialSet,
    MaterialCopy,
    MaterialPreset,
    MaterialReset,
    Parts,
    PartHide,
    PartShow,
    PartIsolate,
    PartShowAll,
    Seen,
    Mask,
    Sections,
    SectionAdd,
    SectionHere,
    SectionThrough,
    SectionBox,
    SectionMove,
    SectionAt,
    SectionPlane,
    SectionTurn,
    SectionRemove,
    SectionClear,
    SectionLight,
    SectionCaps,
    SectionColour,
    SectionHatching,
    SectionLeave,
    SectionCut,
    Plan,
    PlanOutline,
    Storeys,
    StoreyGo,
    MeasurePoint,
    MeasureSeen,
    MeasureDistance,
    MeasureAngle,
    MeasureFace,
    MeasureVolume,
    MeasureList,
    MeasureHidden,
    MeasureKeepDistance,
    MeasureKeepChain,
    MeasureKeepAngle,
    MeasureKeepHeight,
    MeasureKeepSeen,
    MeasureKeepFace,
    MeasureKeepVolume,
    MeasureName,
    MeasureRemove,
    MeasureUnit,
    MeasureExport,
    NoteList,
    NoteGet,
    NoteAdd,
    NoteAt,
    NoteText,
    NoteRemove,
    NoteGo,
    NoteExport,
    FlightList,
    FlightGet,
    FlightThrough,
    FlightTurntable,
    FlightFrom,
    FlightCopy,
    FlightRename,
    FlightRemove,
    FlightSeconds,
    FlightTrim,
    FlightTiming,
    FlightClosed,
    FlightTarget,
    FlightKeyAdd,
    FlightKeySet,
    FlightKeyMove,
    FlightKeyTime,
    FlightKeyExposure,
    FlightKeyRemove,
    FlightGo,
    FlightPlay,
    FlightExport,
    VariantList,
    VariantGet,
    VariantAdd,
    VariantUpdate,
    VariantRename,
    VariantRemove,
    VariantRebase,
    VariantGo,
    VariantLeave,
    MeasureLight,
    MeasureLightAt,
    MeasureLightGrid,
    MeasureProgress,
    MeasureStop,
    KeyPress,
    KeyRelease,
    KeyTap,
    Bindings,
    BindingsDefault,
    Bind,
    Unbind,
};
inline constexpr std::size_t kCommands = static_cast<std::size_t>(CommandId::Unbind) + 1;

enum class ArgumentType {
    Integer,       ///< decimal, in [minimum, maximum]
    Number,        ///< finite, in the range
    Choice,        ///< one of `words`
    Path,          ///< absolute, once it is sent to a server
    Text,          ///< anything; so are those below, which only the server can check
    Setting,       ///< the name of a setting
    SettingValue,  ///< of the setting before it
    Date,          ///< a day, such as 2026-06-21
    Part,          ///< the number of a part, or a pattern for names
    Material,      ///< the number of a material, or a pattern for names
    MaterialKey,   ///< a key of a [[material]]
    MaterialValue, ///< of the key before it: a number, true or false
    Bookmark,      ///< the name of a bookmark
    Flight,        ///< the name of a flight
    Variant,       ///< the name of a variant
    Note,          ///< the text of a note
    Author,        ///< the name of its author
    Key,           ///< the name of a key
    Action,        ///< what a key can be bound to
};

struct CommandArgument {
    std::string_view name = {}; ///< in capitals, as help shows it; none of a Choice
    ArgumentType type = ArgumentType::Text;
    double minimum = 0, maximum = 0;     ///< Integer and Number
    bool open = false;                   ///< a Number's range is without its two ends
    std::string words = {};              ///< what may stand in its place, parted by '|'
    std::vector<std::string> files = {}; ///< of a Path: usual extensions; none = any
    bool optional = false;               ///< may be missing, and then all that follow are
    bool repeats = false;                ///< stands for any number of words; the last one only
};

enum class Runner {
    Server, ///< the line is sent to the server
    Shell,  ///< CUI does it itself
};

/// The effect of a command on the server.
enum class CommandEffect {
    Tells,   ///< only says something
    Waits,   ///< needs what is shown, and leaves it as it is: a file of it, or its standing still
    Steers,  ///< changes how the server works, or records, but not what is shown
    Keeps,   ///< changes what is kept with the scene and is in no image of it, such as notes
    Changes, ///< changes what is shown
};

/// How people in browsers may use a command. A row that does not say it forbids it.
enum class BrowserUse {
    Forbidden, ///< files, names, other people's keys, the server's life
    Own,       ///< the bridge itself sends it
    Look,      ///< a page may ask for it, of viewers too: it only tells
    Move,      ///< the driver's page may: it changes the view or takes a while, not the model
    Edit,      ///< the driver's page may, unless edits are locked
};

/// Limits of arguments that have none of their own.
inline constexpr double kMaxWhole = 1e9, kMaxNumber = 1e30;

struct CommandSpec {
    CommandId id;
    std::string_view name; ///< one word to three, a blank between them
    std::vector<CommandArgument> arguments = {};
    CommandEffect effect = CommandEffect::Changes;
    Runner runner = Runner::Server;
    std::string_view step = {}; ///< what clients call a step of `undo` by it; "": it makes none
    BrowserUse browser = BrowserUse::Forbidden;
    std::vector<std::string_view> sets = {}; ///< settings that it may change, beside those in its arguments
    bool needsScene = true;                  ///< waits until there is one; of the server's
    std::string_view help;                   ///< sentence without a full stop, for --help
    std::string_view more = {}; ///< further sentences for the manual, which has code in backquotes

    /// Its changes are one step of `undo`.
    bool edits() const { return !step.empty(); }
};

/// All rows, by CommandId. Safe from many threads.
std::span<const CommandSpec> commandTable();

const CommandSpec& commandOf(CommandId id);
/// By its whole name; nullptr: there is none.
const CommandSpec* commandNamed(std::string_view name);

/// "X Y", "N on|off|toggle", "FILE [FPS]"; empty without arguments.
std::string argumentsLabel(const CommandSpec& command);
/// The name, and that.
std::string commandLabel(const CommandSpec& command);

/// The words of an argument, apart.
std::vector<std::string_view> wordsOf(const CommandArgument& argument);

} // namespace app

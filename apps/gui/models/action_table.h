/// The actions of the menus, as data: a row here and a call of Actions::on() make an action.
#pragma once

#include <QKeySequence>
#include <QString>

#include <span>

namespace gui {

enum class ActionId {
    Open,
    Save,
    SaveAs,
    Pack,
    Plan,
    ImportCamera,
    Exit,
    Connect,
    StartServer,
    Disconnect,
    ShareInBrowser,
    ServerLog,
    ExportCamera,
    Recording,
    RecordWalk,
    QuickRender,
    Render,
    BuildTree,
    KeepImage,
    CompareDivider,
    CompareBlink,
    CompareDifference,
    Jobs,
    Screenshot,
    CopyImage,
    CopyCamera,
    PasteCamera,
    ResetCamera,
    Orbit,
    Walk,
    Fly,
    FitView,
    FitSelection,
    ViewFront,
    ViewBack,
    ViewLeft,
    ViewRight,
    ViewTop,
    ViewBottom,
    ViewThreeQuarter,
    FieldOfView,
    Measure,
    AddNote,
    AddKeyFrame,
    UpAndUnit,
    PlanInCorner,
    ViewsStrip,
    GroundFloor,
    StoreyAbove,
    StoreyBelow,
    AddBookmark,
    Undo,
    Redo,
    KeepVariant,
    Statistics,
    LookSky,
    LookStudio,
    LookHeadlight,
    OpenEnvironment,
    NoEnvironment,
    LightMeter,
    StopServer,
    PauseServer,
    PingServer,
    RestartServer,
    IgnoreAspectRatio,
    SmoothTransformation,
    ShowOverlay,
    ShowErrors,
    ShowCube,
    LightMarks,
    SectionHandles,
    ShowMeasures,
    ShowNotes,
    SettingsPanel,
    LightsPanel,
    ModelPanel,
    SectionsPanel,
    MeasuresPanel,
    NotesPanel,
    FlightsPanel,
    BookmarksPanel,
    AllPanels,
    ShowBar,
    FullScreen,
    AtRestLive,
    AtRestRefined,
    AtRestGlobal,
    Configure,
    Keys,
    About,
};

enum class MenuId { File, Edit, View, Camera, Light, Render, Window, Server, Help };

enum Trait : unsigned {
    NeedsServer = 1, ///< enabled only while a server is there
    Checkable = 2,
    SeparatorBefore = 4,
    RecentFilesAfter = 8, ///< the submenu of recent files follows
    SkiesAfter = 16,      ///< that of installed environment maps follows
    VariantsAfter = 32,   ///< that of the scene's variants follows
};

struct ActionRow {
    ActionId id;
    MenuId menu;
    const char* text;             ///< in English, with its mnemonic; actionText() translates it
    const char* tip;              ///< one line for the status bar
    const char* shortcut = "";    ///< as QKeySequence reads it; "" = none
    unsigned traits = 0;          ///< of Trait
    const char* thesis = nullptr; ///< the shortcut of the scheme Thesis, where it is another one
    bool has(Trait trait) const { return (traits & trait) != 0; }
};

/// The origin of the shortcuts: the habits of desktops, or the thesis that describes the first version.
enum class ShortcutScheme { Desktop, Thesis };
/// "thesis"; anything else is Desktop.
ShortcutScheme shortcutSchemeOf(const QString& preference);

/// In the order of the menus.
std::span<const ActionRow> actionTable();
const ActionRow& actionRow(ActionId id);

/// Translated.
QString actionText(const ActionRow& row);
QString actionTip(const ActionRow& row);
QString menuText(MenuId menu);
QKeySequence shortcutOf(const ActionRow& row, ShortcutScheme scheme = ShortcutScheme::Desktop);

} // namespace gui

#include "gui/models/action_table.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace gui {

namespace {

// lupdate finds the texts by this name (scripts/translate.sh), and files them under the namespace.
constexpr const char* kContext = "gui";
#define TEXT(text) text

constexpr ActionRow kRows[]{
    ActionRow{ActionId::Open, MenuId::File, TEXT("&Open…"), TEXT("Show a scene or a model"), "Ctrl+O",
              RecentFilesAfter},
    ActionRow{ActionId::Save, MenuId::File, TEXT("&Save"), TEXT("Write the scene as it is now to its file"),
              "Ctrl+S", NeedsServer | SeparatorBefore, "Ctrl+Alt+S"},
    ActionRow{ActionId::SaveAs, MenuId::File, TEXT("Save &as…"),
              TEXT("Write the scene as it is now to another file, and go on with that"), "Ctrl+Shift+S",
              NeedsServer},
    ActionRow{ActionId::Pack, MenuId::File, TEXT("Pac&k with its files…"),
              TEXT("Copy the scene and all that it needs to a folder that can be moved"), "", NeedsServer},
    ActionRow{ActionId::Plan, MenuId::File, TEXT("P&lan…"),
              TEXT("Draw a plan, a section or an elevation to scale"), "", NeedsServer | SeparatorBefore},
    ActionRow{ActionId::ShareInBrowser, MenuId::File, TEXT("Share in a &browser…"),
              TEXT("Let others look at it, and walk in it, in web pages"), "",
              NeedsServer | Checkable | SeparatorBefore},
    ActionRow{ActionId::Screenshot, MenuId::File, TEXT("S&creenshot"),
              TEXT("Save the image under the next free name"), "F12", SeparatorBefore | NeedsServer},
    ActionRow{ActionId::Exit, MenuId::File, TEXT("E&xit"), TEXT("Close the window"), "Ctrl+Q",
              SeparatorBefore},

    ActionRow{ActionId::Undo, MenuId::Edit, TEXT("&Undo"),
              TEXT("Take the last change of settings, lights or camera back"), "Ctrl+Z", 0},
    ActionRow{ActionId::Redo, MenuId::Edit, TEXT("Re&do"), TEXT("Make it again"), "Ctrl+Shift+Z"},
    ActionRow{ActionId::KeepVariant, MenuId::Edit, TEXT("&Keep as a variant…"),
              TEXT("Keep the materials, parts, lights and the sky as they are now under a name"), "",
              NeedsServer | SeparatorBefore | VariantsAfter},
    ActionRow{ActionId::CopyImage, MenuId::Edit, TEXT("Copy &image"), TEXT("Copy the image that is shown"),
              "Ctrl+Alt+C", SeparatorBefore | NeedsServer},
    ActionRow{ActionId::Configure, MenuId::Edit, TEXT("P&references…"), TEXT("Behaviour, image and keys"),
              "Ctrl+,", SeparatorBefore},

    ActionRow{ActionId::Orbit, MenuId::View, TEXT("&Orbit"),
              TEXT("A drag turns the model, Shift moves it, the wheel goes nearer; without, a click takes "
                   "the mouse, "
                   "which looks around"),
              "F2", NeedsServer | Checkable},
    ActionRow{ActionId::Walk, MenuId::View, TEXT("Wal&k"),
              TEXT("On the ground, by the keys and the mouse; F does it, too"), "", NeedsServer | Checkable},
    ActionRow{ActionId::Fly, MenuId::View, TEXT("Fl&y"), TEXT("Anywhere, by the keys and the mouse"), "",
              NeedsServer | Checkable},
    ActionRow{ActionId::FitView, MenuId::View, TEXT("&Whole model"),
              TEXT("All of the model, from the side where you are"), "Home", NeedsServer | SeparatorBefore},
    ActionRow{ActionId::FitSelection, MenuId::View, TEXT("Selected &part"),
              TEXT("The part that is selected, from the side where you are"), "Shift+Home", NeedsServer},
    ActionRow{ActionId::ViewThreeQuarter, MenuId::View, TEXT("From the front, a&slant"),
              TEXT("All of the model, from the front, the right and a little above"), "Num+0",
              NeedsServer | SeparatorBefore},
    ActionRow{ActionId::ViewFront, MenuId::View, TEXT("From the &front"),
              TEXT("All of the model, from its front"), "Num+1", NeedsServer},
    ActionRow{ActionId::ViewBack, MenuId::View, TEXT("From the &back"),
              TEXT("All of the model, from its back"), "Ctrl+Num+1", NeedsServer},
    ActionRow{ActionId::ViewRight, MenuId::View, TEXT("From the &right"),
              TEXT("All of the model, from its right side"), "Num+3", NeedsServer},
    ActionRow{ActionId::ViewLeft, MenuId::View, TEXT("From the &left"),
              TEXT("All of the model, from its left side"), "Ctrl+Num+3", NeedsServer},
    ActionRow{ActionId::ViewTop, MenuId::View, TEXT("From &top"), TEXT("All of the model, from above"),
              "Num+7", NeedsServer},
    ActionRow{ActionId::ViewBottom, MenuId::View, TEXT("From b&elow"), TEXT("All of the model, from below"),
              "Ctrl+Num+7", NeedsServer},
    ActionRow{ActionId::Measure, MenuId::View, TEXT("&Measure"),
              TEXT("Click points, which corners and edges catch: distances, angles, heights, areas, volumes"),
              "Ctrl+M", NeedsServer | Checkable | SeparatorBefore},
    ActionRow{ActionId::AddNote, MenuId::View, TEXT("Add a &note"),
              TEXT("Click a place of the model and write what is to be said of it"), "Ctrl+Shift+N",
              NeedsServer | Checkable},
    ActionRow{ActionId::AddKeyFrame, MenuId::View, TEXT("&Add a key frame"),
              TEXT("Let the flight that is selected end at the current view, or begin one"), "Ctrl+Shift+B",
              NeedsServer},
    ActionRow{ActionId::UpAndUnit, MenuId::View, TEXT("Up a&xis and unit…"),
              TEXT("Which axis of the model is up, and how long a unit of it is"), "", NeedsServer},

    ActionRow{ActionId::PlanInCorner, MenuId::View, TEXT("Plan in the &corner"),
              TEXT("A small plan of the storey where you are: a click goes there, a drag looks there"),
              "Ctrl+Shift+P", NeedsServer | Checkable | SeparatorBefore},
    ActionRow{ActionId::GroundFloor, MenuId::View, TEXT("To the &ground floor"),
              TEXT("Stand on the ground floor, where you are"), "", NeedsServer},
    ActionRow{ActionId::StoreyAbove, MenuId::View, TEXT("One storey &up"),
              TEXT("Stand on the storey above, where you are"), "Ctrl+PgUp", NeedsServer},
    ActionRow{ActionId::StoreyBelow, MenuId::View, TEXT("One storey &down"),
              TEXT("Stand on the storey below, where you are"), "Ctrl+PgDown", NeedsServer},
    ActionRow{ActionId::ViewsStrip, MenuId::View, TEXT("Strip of &views"),
              TEXT("Your bookmarks as images beside each other: a click goes there"), "Shift+F5",
              Checkable | SeparatorBefore},

    ActionRow{ActionId::FieldOfView, MenuId::Camera, TEXT("Field of &view…"),
              TEXT("How much the camera sees, as an angle or a lens; Ctrl and the wheel change it, too"),
              "Ctrl+Shift+F", NeedsServer},
    ActionRow{ActionId::ResetCamera, MenuId::Camera, TEXT("Reset ca&mera"),
              TEXT("The view that the scene names"), "Ctrl+Home", NeedsServer},
    ActionRow{ActionId::AddBookmark, MenuId::Camera, TEXT("Add boo&kmark"),
              TEXT("Keep the current view; Alt and a digit go back to it"), "Ctrl+B", NeedsServer},
    ActionRow{ActionId::CopyCamera, MenuId::Camera, TEXT("Cop&y camera"), TEXT("Copy the camera as text"),
              "Ctrl+C", NeedsServer | SeparatorBefore, "Ctrl+Shift+C"},
    ActionRow{ActionId::PasteCamera, MenuId::Camera, TEXT("&Paste camera"),
              TEXT("Look through the camera of the clipboard"), "Ctrl+V", NeedsServer, "Ctrl+Shift+V"},
    ActionRow{ActionId::ImportCamera, MenuId::Camera, TEXT("&Import camera…"),
              TEXT("Look through a .cam file"), "Ctrl+I", NeedsServer},
    ActionRow{ActionId::ExportCamera, MenuId::Camera, TEXT("&Export camera…"),
              TEXT("Write the camera to a .cam file"), "Ctrl+E", NeedsServer},
    ActionRow{ActionId::RecordWalk, MenuId::Camera, TEXT("Record the &walk"),
              TEXT("Record the camera from now on, or end that; also while walking"), "F3",
              SeparatorBefore | NeedsServer | Checkable},
    ActionRow{ActionId::Recording, MenuId::Camera, TEXT("&Recording…"),
              TEXT("Record the camera, 30 times a second"), "Ctrl+Shift+R", NeedsServer},

    ActionRow{ActionId::LookSky, MenuId::Light, TEXT("&Sky and sun"),
              TEXT("Light the scene by a sky with a sun, in place of its lights"), "", NeedsServer},
    ActionRow{ActionId::LookStudio, MenuId::Light, TEXT("S&tudio"),
              TEXT("Light it by soft lights before white walls, in place of its lights"), "", NeedsServer},
    ActionRow{ActionId::LookHeadlight, MenuId::Light, TEXT("&Headlight"),
              TEXT("Light it by one light beside you, in place of its lights"), "", NeedsServer},
    ActionRow{ActionId::OpenEnvironment, MenuId::Light, TEXT("&Environment map…"),
              TEXT("Let an image of all directions surround and light the scene"), "",
              NeedsServer | SeparatorBefore | SkiesAfter},
    ActionRow{ActionId::NoEnvironment, MenuId::Light, TEXT("&No background"),
              TEXT("Neither sky nor environment map"), "", NeedsServer},
    ActionRow{ActionId::LightMeter, MenuId::Light, TEXT("Light &meter"),
              TEXT("Show at the pointer how much light falls there, and how bright it is"), "Ctrl+Shift+M",
              NeedsServer | Checkable | SeparatorBefore},

    ActionRow{ActionId::QuickRender, MenuId::Render, TEXT("&Quick render"),
              TEXT("Show the current view in higher quality"), "Ctrl+R", NeedsServer},
    ActionRow{ActionId::Render, MenuId::Render, TEXT("Re&nder…"),
              TEXT("Render the view, a scene or a recorded list into a file"), "Ctrl+Alt+R"},
    ActionRow{ActionId::Jobs, MenuId::Render, TEXT("&Jobs"), TEXT("Running and queued jobs"), "Ctrl+J",
              Checkable},
    ActionRow{ActionId::AtRestLive, MenuId::Render, TEXT("At rest: &live frame"),
              TEXT("When the camera rests, show what the server draws; once more: refine it again"), "Ctrl+H",
              SeparatorBefore | Checkable},
    ActionRow{ActionId::AtRestRefined, MenuId::Render, TEXT("At rest: re&fined"),
              TEXT("When the camera rests, render the view in higher quality"), "", Checkable},
    ActionRow{ActionId::AtRestGlobal, MenuId::Render, TEXT("At rest: &global illumination"),
              TEXT("When the camera rests, render all light, also from surface to surface"), "Ctrl+G",
              Checkable},
    ActionRow{ActionId::KeepImage, MenuId::Render, TEXT("Compare &with this image"),
              TEXT("Keep the image that is shown, to compare others with it"), "Ctrl+Alt+K",
              SeparatorBefore | NeedsServer},
    ActionRow{ActionId::CompareDivider, MenuId::Render, TEXT("Compare: &divider"),
              TEXT("The kept image left of a divider that can be dragged"), "", Checkable},
    ActionRow{ActionId::CompareBlink, MenuId::Render, TEXT("Compare: &in turns"),
              TEXT("The kept image and the one that is shown, one after the other"), "", Checkable},
    ActionRow{ActionId::CompareDifference, MenuId::Render, TEXT("Compare: diff&erence"),
              TEXT("How much the image differs from the kept one, brightened, with figures"), "", Checkable},
    ActionRow{ActionId::BuildTree, MenuId::Render, TEXT("Build &kd-tree…"),
              TEXT("Write a model and its kd-tree to a .bsp file, which loads quickly"), "Ctrl+Alt+B",
              SeparatorBefore},

    ActionRow{ActionId::SettingsPanel, MenuId::Window, TEXT("S&ettings panel"),
              TEXT("All settings of the viewport"), "F5", Checkable},
    ActionRow{ActionId::LightsPanel, MenuId::Window, TEXT("&Lights panel"),
              TEXT("Lights, the sky and environment maps"), "F6", Checkable},
    ActionRow{ActionId::ModelPanel, MenuId::Window, TEXT("&Model panel"),
              TEXT("Parts and materials of the model; a right click on the image selects them"), "F8",
              Checkable},
    ActionRow{ActionId::SectionsPanel, MenuId::Window, TEXT("Sect&ions panel"),
              TEXT("Planes that cut the model open"), "Shift+F8", Checkable},
    ActionRow{ActionId::MeasuresPanel, MenuId::Window, TEXT("Me&asures panel"),
              TEXT("Measures that are kept, and their unit"), "Shift+F7", Checkable},
    ActionRow{ActionId::NotesPanel, MenuId::Window, TEXT("Notes an&d comments"),
              TEXT("Texts at places of the model"), "Shift+F6", Checkable},
    ActionRow{ActionId::FlightsPanel, MenuId::Window, TEXT("Fli&ghts panel"),
              TEXT("Paths of the camera by key frames, and films of them"), "Ctrl+F7", Checkable},
    ActionRow{ActionId::BookmarksPanel, MenuId::Window, TEXT("&Bookmarks panel"), TEXT("Views that you keep"),
              "F7", Checkable},
    ActionRow{ActionId::AllPanels, MenuId::Window, TEXT("All &panels"),
              TEXT("Hide all panels, and show them again"), "F4"},
    ActionRow{ActionId::ShowBar, MenuId::Window, TEXT("Tool ba&r"), TEXT("The buttons below the menus"), "",
              Checkable | SeparatorBefore},
    ActionRow{ActionId::ShowOverlay, MenuId::Window, TEXT("Show &overlay"),
              TEXT("Frames/s, resolution, mode and state in the corner"), "Ctrl+F", Checkable},
    ActionRow{ActionId::ShowErrors, MenuId::Window, TEXT("Show &noise that is left"),
              TEXT("Colour an image that a net denoised by its error, and mark where that is largest"),
              "Ctrl+Shift+E", Checkable},
    ActionRow{ActionId::ShowCube, MenuId::Window, TEXT("Show &cube"),
              TEXT("The direction of the view in the corner, and whether you orbit, walk or fly"), "",
              Checkable},
    ActionRow{ActionId::LightMarks, MenuId::Window, TEXT("Mar&ks of lights"),
              TEXT("Show where lights are: click a mark to select its light, drag it to move the light"),
              "F9", Checkable},
    ActionRow{ActionId::SectionHandles, MenuId::Window, TEXT("&Handles of sections"),
              TEXT("Drag the planes that cut the model open, also while their panel is closed"), "",
              Checkable},
    ActionRow{ActionId::ShowMeasures, MenuId::Window, TEXT("Labels o&f measures"),
              TEXT("Show the measures that are kept over the image"), "Shift+F9", Checkable},
    ActionRow{ActionId::ShowNotes, MenuId::Window, TEXT("Notes o&ver the image"),
              TEXT("Show the numbers of notes over the image"), "", Checkable},
    ActionRow{ActionId::Statistics, MenuId::Window, TEXT("S&tatistics"),
              TEXT("Frames/s, rays/s, resolution, polygons"), "Ctrl+T", 0},
    ActionRow{ActionId::IgnoreAspectRatio, MenuId::Window, TEXT("Stretch to &window"),
              TEXT("Fill the whole window, whatever the aspect ratio"), "", SeparatorBefore | Checkable},
    ActionRow{ActionId::SmoothTransformation, MenuId::Window, TEXT("&Smooth scaling"),
              TEXT("Filter the image where it does not have the window's size"), "", Checkable},
    ActionRow{ActionId::FullScreen, MenuId::Window, TEXT("F&ull screen"), TEXT("Use the whole screen"), "F11",
              Checkable | SeparatorBefore},

    ActionRow{ActionId::Connect, MenuId::Server, TEXT("&Connect…"), TEXT("Connect to a running server"),
              "Ctrl+Shift+O", 0, "Ctrl+C"},
    ActionRow{ActionId::StartServer, MenuId::Server, TEXT("&Start new server…"),
              TEXT("Start a server with a scene or a model, and connect to it"), "Ctrl+N", 0, "Ctrl+S"},
    ActionRow{ActionId::Disconnect, MenuId::Server, TEXT("&Disconnect"), TEXT("Leave the server; it goes on"),
              "Ctrl+D", NeedsServer},
    ActionRow{ActionId::PauseServer, MenuId::Server, TEXT("P&ause server"),
              TEXT("Finish the image, then draw no more until this is off again"), "Ctrl+P",
              SeparatorBefore | NeedsServer | Checkable},
    ActionRow{ActionId::PingServer, MenuId::Server, TEXT("&Ping server"), TEXT("Test whether it answers"), "",
              NeedsServer},
    ActionRow{ActionId::ServerLog, MenuId::Server, TEXT("Server &log"), TEXT("Messages of the server"),
              "Ctrl+L", 0},
    ActionRow{ActionId::RestartServer, MenuId::Server, TEXT("&Restart server"),
              TEXT("Start the server again with the same scene and camera"), "", SeparatorBefore},
    ActionRow{ActionId::StopServer, MenuId::Server, TEXT("S&top server"), TEXT("End the server"), "Ctrl+K",
              NeedsServer},

    ActionRow{ActionId::Keys, MenuId::Help, TEXT("&Keys"), TEXT("All keys on one page"), "F1"},
    ActionRow{ActionId::About, MenuId::Help, TEXT("&About"), TEXT("About this program"), ""},
};

constexpr const char* kMenus[]{TEXT("&File"),   TEXT("&Edit"),   TEXT("&View"),
                               TEXT("&Camera"), TEXT("&Light"),  TEXT("Re&nder"),
                               TEXT("&Window"), TEXT("&Server"), TEXT("&Help")};

#undef TEXT

QString translated(const char* text) { return QCoreApplication::translate(kContext, text); }

} // namespace

std::span<const ActionRow> actionTable() { return kRows; }

const ActionRow& actionRow(ActionId id) {
    return *std::find_if(std::begin(kRows), std::end(kRows),
                         [&](const ActionRow& row) { return row.id == id; });
}

QString actionText(const ActionRow& row) { return translated(row.text); }
QString actionTip(const ActionRow& row) { return translated(row.tip); }
QString menuText(MenuId menu) { return translated(kMenus[static_cast<std::size_t>(menu)]); }

ShortcutScheme shortcutSchemeOf(const QString& preference) {
    return preference == QLatin1String("thesis") ? ShortcutScheme::Thesis : ShortcutScheme::Desktop;
}

QKeySequence shortcutOf(const ActionRow& row, ShortcutScheme scheme) {
    const bool other = scheme == ShortcutScheme::Thesis && row.thesis != nullptr;
    return QKeySequence(QLatin1String(other ? row.thesis : row.shortcut));
}

} // namespace gui

/// The Renderer's command line, read.
#pragma once

#include "renderer/light_bounds.h"
#include "renderer/output_names.h"
#include "renderer/preview_options.h"
#include "renderer/renderer_spec.h"

#include "common/cli/command_line.h"
#include "common/plans/plan_order.h"
#include "common/progress/progress.h"
#include "common/settings/selection_options.h"

#include "rtcore/io/import/model_import.h"
#include "rtcore/io/scene_loader.h"
#include "rtcore/post/backdrop.h"
#include "rtcore/settings/settings_table.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace renderer {

/// What goes around on a turntable is the camera.
struct Turntable {
    double seconds = 0; ///< of the whole
    double turns = 1;   ///< counterclockwise as seen from above; not 0
};

/// What the cameras of a run come from in place of a list: a flight of the scene, or a turntable.
struct FlightOrder {
    std::string name; ///< of the flight
    std::optional<Turntable> turntable;
};

struct RendererOptions {
    std::filesystem::path scene;
    std::vector<std::filesystem::path> outputs; ///< patterns as given; empty = what the scene names
    std::string standardOutputFormat = "png";   ///< of the output "-": png or ppm
    std::optional<std::filesystem::path> camera, model, list, settingsFile;
    std::optional<std::string> variant;            ///< of the scene; runsOf() knows which
    std::string outputWord;                        ///< that its outputs have in their names; "": none
    std::optional<FlightOrder> flight;             ///< excludes a list
    std::optional<std::filesystem::path> makeList; ///< the list of a flight to write; nothing is rendered
    FrameRange frames;
    Chunk chunk;
    bool force = false;
    bool verify = false;                             ///< only look which frames are there
    bool follow = false;                             ///< the list may still be written
    double followTimeout = 60;                       ///< seconds
    std::optional<std::filesystem::path> video;      ///< the film to make of the list
    std::optional<double> framesPerSecond;           ///< of the film
    std::optional<PreviewOptions> preview;           ///< show the image while it refines
    bool standBy = false;                            ///< then those that standard input asks for
    std::optional<std::int64_t> parent;              ///< stop with this process; 0 = the parent
    bool requeue = false;                            ///< exit with TryAgain when SIGTERM stops the run
    std::optional<int> panorama;                     ///< its width in pixels
    std::optional<rtcore::Vec2> focusAt;             ///< pixels of what a lens is focused at
    std::vector<rtcore::SettingAssignment> settings; ///< in the order of the command line
    int threads = 0;                                 ///< 0 = all cores
    rtcore::ImportOptions import;
    rtcore::LightingOptions lighting;
    app::Selection selection;
    std::filesystem::path nets; ///< the folder of their weights; empty: where they are looked for by default
    std::string netDigest;      ///< what the SHA-256 of the net's weights begins with; empty: any
    bool alpha = false;         ///< outputs have the background hidden
    /// What is shown in its place; excludes alpha.
    std::optional<rtcore::Backdrop> backdrop;
    std::optional<std::filesystem::path> backdropFile; ///< that it was read from
    bool groundShadow = false;                         ///< falls on what is transparent
    bool aovs = false; ///< .exr outputs hold what is known of surfaces as well
    bool verbose = false;
    std::optional<std::filesystem::path> report;     ///< what was made, for programs
    std::optional<std::filesystem::path> debugScene; ///< draw it there and render nothing
    std::optional<std::filesystem::path> light;      ///< a file of indirect light that images begin with
    std::optional<std::filesystem::path> makeLight;  ///< such a file to make; nothing is rendered
    LightBounds lightBounds;                         ///< of that
    std::optional<app::PlanOrder> plan;              ///< a drawing to make; nothing is rendered
    app::ProgressStyle progress = app::ProgressStyle::None;

    bool hidesBackground() const { return alpha || backdrop.has_value(); }
    /// It renders the frames of a list or a flight.
    bool hasFrames() const { return list || flight; }
    /// Frames of a list may go into a folder that is not there yet.
    MissingFolder missingFolder() const { return hasFrames() ? MissingFolder::Make : MissingFolder::Refuse; }
};

/// Throws app::UsageError for values and combinations that make no sense.
RendererOptions readRendererOptions(const app::Arguments& arguments);

} // namespace renderer

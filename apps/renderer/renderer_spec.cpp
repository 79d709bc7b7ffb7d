#include "renderer/renderer_spec.h"

#include "renderer/film_format.h"

#include "common/cli/file_notes.h"
#include "common/cli/import_option_group.h"
#include "common/cli/isa_option.h"
#include "common/cli/lighting_option_group.h"
#include "common/cli/parent_option.h"
#include "common/cli/selection_option_group.h"
#include "common/cli/threads_option.h"
#include "common/progress/progress.h"
#include "common/settings/setting_option.h"

#include "rtcore/scene/flight.h"
#include "rtcore/scene/image.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace renderer {

namespace {

using app::OptionGroup;
using app::ValueKind;

std::vector<std::string> suggestNets(std::span<const std::string>) {
    return {"off", "small", "base", "large", "automatic"};
}

OptionGroup outputOptions() {
    return {
        "Output",
        {{.name = "output",
          .letter = 'o',
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "write the image there; the extension says the format; .exr, .hdr and .pfm hold linear "
                  "radiance, not tone mapped; '-' is standard output; may be given several times [the "
                  "scene's output, else its name with .png in the current folder]",
          .more = "The scene's output counts if it lies in the folder of the `.scn` or below"},
         {.name = "format",
          .value = ValueKind::Choice,
          .argument = "NAME",
          .help = "format of the image on standard output: png or ppm [png]",
          .choices = {"png", "ppm"}},
         {.name = "aovs",
          .formerly = {"layers"},
          .help = "outputs with the extension .exr also hold AOVs: depth, normal, albedo, direct light "
                  "and ambient occlusion of the surfaces",
          .more = "See [post.md](post.md#aovs)"},
         {.name = "alpha",
          .help = "leave the background out: outputs are transparent there; .png, .tif, .tga, .webp and .exr "
                  "can hold that",
          .more = "It lights the model all the same, and mirrors show it. See "
                  "[post.md](post.md#without-a-background)"},
         {.name = "backdrop",
          .value = ValueKind::Text,
          .argument = "WHAT",
          .help =
              "show this in place of the background: a colour #rrggbb, two of them for a gradient from top "
              "to bottom (#rrggbb,#rrggbb), or an image file",
          .more = "It is shown as it is, lights nothing, and is in no mirror"},
         {.name = "ground-shadow",
          .help = "with --alpha or --backdrop: the model casts its shadow on a ground below it that is not "
                  "seen itself",
          .more = "The ground of the sky, else a level one below the lowest point of the model"},
         {.name = "width",
          .letter = 'w',
          .value = ValueKind::Text,
          .argument = "N",
          .help = "pixels from left to right; alone it keeps the aspect",
          .more = "That is the aspect of the `.cam`, the settings or the scene, else 4:3"},
         {.name = "height",
          .letter = 'h',
          .value = ValueKind::Text,
          .argument = "N",
          .help = "pixels from top to bottom; alone it keeps the aspect"},
         {.name = "size",
          .value = ValueKind::Text,
          .argument = "NAME",
          .help = "width and height at once: hd, fullhd, qhd, 4k, 8k, a4 ... a0 or 1200x800",
          .more = "Paper lies, at 300 dots per inch: `a4@150` has 150, `a4-upright@150` stands"},
         {.name = "panorama",
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "an image all around the eye, equirectangular, N x N/2 pixels; what the camera looks at is "
                  "in its middle, and the horizon is level",
          .more = "PNG and JPEG say so in XMP (GPano), by which phones and web pages show it round. 4096 is "
                  "enough for a phone, 8192 for a screen. A panorama has no lens, and sections have no caps "
                  "in it; `--aovs` hold distances from the eye in place of depths",
          .minimum = 2,
          .maximum = rtcore::kMaxImageSide}}};
}

OptionGroup sequenceOptions() {
    return {
        "View and video",
        {{.name = "camera",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "look through this .cam file",
          .more = "Its size, anti-aliasing, exposure, lights and environment count, too, where it names them",
          .files = {"cam"}},
         {.name = "model",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "take this model or .bsp in place of the one that the .scn names",
          .files = app::sceneExtensions()},
         {.name = "variant",
          .value = ValueKind::Text,
          .argument = "NAME",
          .help = "show this variant of the .scn; all: each in turn, with its name in the names of the "
                  "outputs; none: the scene without one",
          .more = "A [[variant]] ([formats.md](formats.md)) is a set of edits; the commands `variant ...` "
                  "keep them. With `-o room.png` the variant `oak floor` of all is `room_oak-floor.png`. "
                  "The scene is loaded for each"},
         {.name = "list",
          .letter = 'l',
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "render a frame for each .cam file that this text file lists; #### in the output's name "
                  "becomes the number of the frame, from 0001",
          .more = "The scene is loaded once",
          .files = {"lst", "txt"}},
         {.name = "flight",
          .value = ValueKind::Text,
          .argument = "NAME",
          .help = "render the frames of a flight that the .scn keeps, as those of a list",
          .more =
              "A [[flight]] ([formats.md](formats.md)) goes through key frames; the window and the commands "
              "`flight ...` make them. As many frames per second as `--fps` says. Where no key frame has an "
              "exposure, that of the film is measured beforehand, about once a second of it, and adapts over "
              "some seconds; with `exposure.mode` or `exposure.value` on the command line, or "
              "`exposure.recorded=automatic`, it is not"},
         {.name = "turntable",
          .value = ValueKind::Number,
          .argument = "S",
          .help =
              "go once around the model in S seconds, from the scene's view or that of --camera on, as by "
              "a flight",
          .more =
              "Around the upright axis through the middle of what the model is of, without ground and "
              "surroundings; the film can be shown over and over. All of it has one exposure, as `--flight` "
              "measures it",
          .minimum = 0.01,
          .maximum = rtcore::kMaxFlightSeconds},
         {.name = "turns",
          .value = ValueKind::Number,
          .argument = "N",
          .help = "with --turntable: so many times around; below 0 it goes clockwise, as seen from above [1]",
          .minimum = -rtcore::kMaxTurns,
          .maximum = rtcore::kMaxTurns},
         {.name = "make-list",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help =
              "render nothing; write the cameras of the flight or the turntable as a list of .cam files, in "
              "a folder beside it",
          .files = {"lst"}},
         {.name = "frames",
          .value = ValueKind::Text,
          .argument = "A-B",
          .help = "render only these frames of the list or flight; also A, A- and -B"},
         {.name = "chunk",
          .value = ValueKind::Text,
          .argument = "I/N",
          .help = "render the I-th of N equal parts of the list or flight, or of --frames",
          .more = "All parts together hold each frame once, each part in a row"},
         {.name = "force",
          .help = "render frames again whose files are there already and whole; they are skipped otherwise"},
         {.name = "verify",
          .help =
              "render nothing; list the frames whose files are missing or broken, and exit with 1 if there "
              "are any"},
         {.name = "follow",
          .help = "the list is still being written: wait for more frames until the line '# end' comes"},
         {.name = "follow-timeout",
          .value = ValueKind::Number,
          .argument = "S",
          .help = "with --follow: take the list as complete when no frame came for S seconds [60]",
          .minimum = 0,
          .maximum = 1e6},
         {.name = "video",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "make a film of the list or flight by ffmpeg: " + filmExtensions() +
                  "; with -o the frames are kept as well, and those that are there are used"},
         {.name = "fps",
          .value = ValueKind::Number,
          .argument = "X",
          .help = "frames per second of the film or flight [as the .cam files were recorded, else 25]",
          .more = "The rate was recorded if the first and the last name their `time`. With `--follow` it is "
                  "always 25",
          .minimum = 0.1,
          .maximum = 1000}}};
}

OptionGroup qualityOptions() {
    return {
        "Quality",
        {{.name = "integrator",
          .value = ValueKind::Choice,
          .argument = "NAME",
          .help = "whitted: mirrors, glass and light that comes straight; path: all light, also from "
                  "surface to surface [whitted]",
          .choices = {"whitted", "path"}},
         {.name = "samples",
          .value = ValueKind::Text,
          .argument = "N",
          .help = "with --integrator=path: N paths per pixel [256]"},
         {.name = "denoise",
          .value = ValueKind::Text,
          .argument = "NET",
          .help = "with --integrator=path: a trained net takes the noise away: small, base, large or "
                  "automatic [off]; base@DIGEST only by weights whose SHA-256 begins so",
          .more = "See [post.md](post.md#denoising-by-a-net)",
          .suggest = suggestNets},
         {.name = "nets",
          .value = ValueKind::Text,
          .argument = "DIR",
          .help = "the folder of the nets' weights [RT_NETS, else where rtsuite-fetch-nets puts them]"},
         {.name = "antialiasing",
          .letter = 'a',
          .value = ValueKind::Text,
          .argument = "N",
          .help = "N x N samples per pixel"},
         {.name = "bloom",
          .letter = 'b',
          .value = ValueKind::Text,
          .argument = "N",
          .help = "bloom around bright spots: a blur of N pixels (standard deviation); 0 is none",
          .more = "See [post.md](post.md)"},
         {.name = "ambient-occlusion",
          .thesis = {"-ao"},
          .help = "switch ambient occlusion on: corners are darker than open surfaces"},
         {.name = "no-ambient-occlusion", .thesis = {"-nao"}, .help = "switch ambient occlusion off"},
         {.name = "ao-samples",
          .thesis = {"-aon"},
          .value = ValueKind::Text,
          .argument = "N",
          .help = "switch ambient occlusion on, with N rays per point"},
         {.name = "ao-distance",
          .thesis = {"-aok"},
          .value = ValueKind::Text,
          .argument = "X",
          .help = "switch ambient occlusion on, up to this distance"},
         {.name = "focus-at",
          .value = ValueKind::Text,
          .argument = "X,Y",
          .help = "switch depth of field on, focused on what is seen at this pixel",
          .more = "The pixel is counted from the upper left corner; `--setting depthOfField.fNumber=F` "
                  "says how strong the effect is"},
         {.name = "exposure",
          .value = ValueKind::Text,
          .argument = "C",
          .help = "fixed exposure: a luminance of C becomes half of the display's range [automatic]",
          .more = "One that a .cam file names is scaled with `--integrator=path`, since light from surface "
                  "to surface is added: see `exposure.recorded` in [formats.md](formats.md)"},
         {.name = "set",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "take settings from the table [still] of this .set file",
          .files = {"set"}},
         {.name = "setting",
          .value = ValueKind::Text,
          .argument = "NAME=VALUE",
          .help = "any setting by its name; may be given several times",
          .suggest = app::suggestAssignments},
         {.name = "settings",
          .help = "list all settings and exit",
          .more = "With range, default and meaning",
          .answers = true}}};
}

OptionGroup previewOptions() {
    return {
        "Preview",
        {{.name = "preview",
          .value = ValueKind::Text,
          .argument = "NAME",
          .help = "show the image while it is rendered, from coarse to fine, to programs that look for "
                  "an instance of this name; without --output no file is written; stops with the process "
                  "that started it",
          .more = "The name has 1 to 32 letters, digits, `_` or `-`. Only one image is rendered; "
                  "[protocol.md](protocol.md) has what viewers see"},
         {.name = "run-id",
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "mark the frames of the preview with N, so that viewers can tell runs apart [0]",
          .minimum = 0,
          .maximum = static_cast<double>(std::int64_t{1} << 53)},
         {.name = "linger",
          .value = ValueKind::Number,
          .argument = "S",
          .help = "seconds for which the last frame of the preview can be found [2]",
          .more = "A signal ends the waiting, with exit code 0",
          .minimum = 0,
          .maximum = 1e6},
         {.name = "stand-by",
          .help = "after that image, show those that lines on standard input ask for, until it ends",
          .more = "A line is `RUN<TAB>SCENE<TAB>CAMERA`: a run-id, a scene and a .cam file. It ends what is "
                  "being rendered, as does an empty line. What has not changed is not loaded again"}}};
}

OptionGroup lightOptions() {
    return {"Kept light",
            {{.name = "light",
              .value = ValueKind::Text,
              .argument = "FILE",
              .help = "with indirect.mode=live: images begin with the indirect light of this file, so that "
                      "they come sooner and those of a list do not flicker [a list learns it of its views]",
              .more = "A list makes the file where it is missing, so that its parts learn it once. A file of "
                      "another scene, or of the same by other light, is refused",
              .files = {"light"}},
             {.name = "make-light",
              .value = ValueKind::Text,
              .argument = "FILE",
              .help = "learn indirect light, write it to this .light file, and exit: that of the views of a "
                      "list, of one camera, or of views from all over the floors",
              .more = "A run that was stopped keeps what it has learned; the same command goes on",
              .files = {"light"}},
             {.name = "light-time",
              .value = ValueKind::Number,
              .argument = "S",
              .help = "with --make-light: learn for S seconds at most, about [no bound]",
              .minimum = 0.1,
              .maximum = 1e7},
             {.name = "light-size",
              .value = ValueKind::Number,
              .argument = "MB",
              .help = "with --make-light: learn no more once the file has so many megabytes [no bound]",
              .more = "It is never larger than some 60 MB",
              .minimum = 0.1,
              .maximum = 1000}}};
}

OptionGroup planOptions() {
    return {
        "Plans",
        {{.name = "plan",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help =
              "draw a plan to scale, write it to this .svg, .pdf, .dxf, .png or .tif file, and exit: what "
              "is cut, visible edges beyond, and the areas of rooms",
          .more = "See [plans.md](plans.md). A `.dxf` is in metres, at the coordinates of the model's file",
          .files = {"svg", "pdf", "dxf", "png", "tif", "tiff"}},
         {.name = "plan-from",
          .value = ValueKind::Choice,
          .argument = "SIDE",
          .help =
              "with --plan: above, a plan of a storey; front, back, left or right, an elevation; section, "
              "what the scene's section leaves [above]",
          .choices = {"above", "front", "back", "left", "right", "section"}},
         {.name = "plan-storey",
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "with --plan: the N-th storey from below [that of a camera indoors, else the lowest]",
          .minimum = 1,
          .maximum = 1000},
         {.name = "plan-floor",
          .value = ValueKind::Number,
          .argument = "M",
          .help = "with --plan: a floor at M metres, in the coordinates of the model's file, in place of a "
                  "storey that is found",
          .minimum = -1e7,
          .maximum = 1e7},
         {.name = "plan-height",
          .value = ValueKind::Number,
          .argument = "M",
          .help = "with --plan: cut M metres above the floor [1.2]",
          .minimum = 0,
          .maximum = 1e4},
         {.name = "plan-scale",
          .value = ValueKind::Number,
          .argument = "N",
          .help = "with --plan: 1 to N [100]",
          .minimum = 0.01,
          .maximum = 1e6},
         {.name = "plan-paper",
          .value = ValueKind::Choice,
          .argument = "SIZE",
          .help =
              "with --plan: A4, A3, A2, A1 or A0, lying; a .pdf takes as many sheets as it needs, a .png or "
              ".tif as many files [one as large as it must be]",
          .choices = {"A4", "A3", "A2", "A1", "A0"}},
         {.name = "plan-dpi",
          .value = ValueKind::Number,
          .argument = "N",
          .help = "with --plan: pixels of a .png or .tif to an inch of paper [300]",
          .minimum = 10,
          .maximum = 2400},
         {.name = "plan-image",
          .value = ValueKind::Choice,
          .argument = "WHAT",
          .help =
              "with --plan: what a .png or .tif has: lines, the rendered light of what they show, or both, "
              "lines over light [lines]",
          .more = "Light is rendered as an image is, with the scene's settings and those of the command line",
          .choices = {"lines", "light", "both"}},
         {.name = "plan-door",
          .value = ValueKind::Number,
          .argument = "M",
          .help = "with --plan: openings of up to M metres part rooms, wider ones join them [1.2]",
          .more = "What has an opening of more than 3 m to the outside is no room",
          .minimum = 0,
          .maximum = 100}}};
}

OptionGroup runOptions() {
    return {
        "Running",
        {app::threadsOption(),
         app::isaOption(),
         app::progressOption(),
         app::parentOption(),
         {.name = "requeue",
          .help = "exit with 75 (try again), not 143, when SIGTERM stops the run, so that a batch system "
                  "sends the job again"},
         {.name = "verbose", .letter = 'v', .help = "report times and rays on stderr"},
         {.name = "report",
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "write a report of the images as JSON: times, rays, settings, what a net did and the error "
                  "that is left",
          .more = "See [A report of a run](#a-report-of-a-run)",
          .files = {"json"}},
         {.name = "debug-scene",
          .thesis = {"-dbg"},
          .value = ValueKind::Text,
          .argument = "FILE",
          .help = "write what the renderer works with - cells of the kd-tree, lights, camera, normals - as "
                  "an .obj model, and exit",
          .more = "With a `.mtl` beside it, in the coordinates of the scene: cells of the kd-tree by depth "
                  "and the heaviest leaves, lights, what the camera sees, normals where its rays hit",
          .files = {"obj"}}}};
}

} // namespace

const app::ProgramSpec& rendererSpec() {
    static const app::ProgramSpec spec{
        .name = "Renderer",
        .purpose =
            "Renders images of a scene by ray tracing. Values on the command line beat those of the .cam "
            "file, these the .set file, and these the .scn file.",
        .positionals = {{.name = "SCENE",
                         .help = "scene description (.scn), kd-tree (.bsp) or any model file",
                         .files = app::sceneExtensions()}},
        .groups = {outputOptions(), sequenceOptions(), qualityOptions(), lightOptions(), planOptions(),
                   previewOptions(), runOptions(), app::lightingOptionGroup(), app::selectionOptionGroup(),
                   app::importOptionGroup()},
        .examples = {{"Renderer nave.scn -o nave.png -w 1280 -h 720 -a 3",
                      "one image, 3 x 3 samples per pixel"},
                     {"Renderer cow.obj -o cow.png -o cow.exr",
                      "a model by itself, as it is shown and as linear radiance"},
                     {"Renderer nave.scn -l flight.lst -o out/frame_####.png --frames 1-100",
                      "a part of a video; frames that are there already are skipped"},
                     {"Renderer nave.scn -l flight.lst --video flight.mp4", "a film; needs ffmpeg"},
                     {"Renderer house.glb --plan plan.pdf --plan-scale 50 --plan-paper A3",
                      "a plan on sheets of A3, 1:50"},
                     {"Renderer house.glb --make-light house.light",
                      "its indirect light, for --light and for walks"}},
        .environment = app::importEnvironmentNotes(app::HelpWord{
            "RT_NETS", "the folder of the weights of nets that denoise, where --nets names none"}),
        .files = app::sceneFileNotes(),
    };
    return spec;
}

} // namespace renderer

// Rows for the camera and for motion.
#include "common/commands/command_rows.h"

#include "rtcore/settings/settings_table.h"

namespace app {

using enum ArgumentType;
using enum CommandEffect;
using enum Runner;

namespace {

CommandArgument fieldOfView() { return maybe(between("FOV", 0, 180)); }

ArgumentList upright() {
    const double widest = rtcore::requireSetting("width").maximum; // by one pixel
    return {maybe(number("UX")), number("UY"), number("UZ"), maybe(number("ASPECT", 1 / widest, widest))};
}

} // namespace

std::vector<CommandSpec> cameraCommands() {
    return {
        {.id = CommandId::CameraGet,
         .name = "camera get",
         .effect = Tells,
         .help = "print the camera, as a .cam file has it"},
        {.id = CommandId::CameraSet,
         .name = "camera set",
         .arguments = numbers({"EX", "EY", "EZ", "FX", "FY", "FZ"}) + ArgumentList{fieldOfView()} + upright(),
         .step = "look there",
         .browser = BrowserUse::Move,
         .help = "look from E into the direction F, with U upwards",
         .more = "FOV, in degrees, is that of an image of that ASPECT, or of any image; with perspective. "
                 "Without FOV that stays as it is"},
        {.id = CommandId::CameraOrthographic,
         .name = "camera orthographic",
         .arguments = numbers({"EX", "EY", "EZ", "FX", "FY", "FZ"}) +
                      ArgumentList{between("WIDTH", 0, 1e18)} + upright(),
         .step = "look there",
         .browser = BrowserUse::Move,
         .help = "the same without perspective; WIDTH of the scene from the left edge to the right one"},
        {.id = CommandId::CameraLookAt,
         .name = "camera look-at",
         .arguments = numbers({"EX", "EY", "EZ", "TX", "TY", "TZ"}) + ArgumentList{fieldOfView()},
         .step = "look there",
         .browser = BrowserUse::Move,
         .help = "look from E to the point T"},
        {.id = CommandId::CameraTurn,
         .name = "camera turn",
         .arguments = {number("RIGHT", -360, 360), number("UP", -360, 360)},
         .browser = BrowserUse::Own,
         .help = "turn by these angles, degrees, as the mouse does"},
        {.id = CommandId::CameraPivot,
         .name = "camera pivot",
         .arguments = {maybe(number("RIGHT", 0, 1)), maybe(number("DOWN", 0, 1))},
         .effect = Steers,
         .browser = BrowserUse::Move,
         .help = "turn about what is seen there from now on, 0..1 from the left and from the top",
         .more =
             "Without arguments, or where nothing is seen, about the middle of the model. Prints the point"},
        {.id = CommandId::CameraOrbit,
         .name = "camera orbit",
         .arguments = {number("RIGHT", -360, 360), number("UP", -180, 180)},
         .browser = BrowserUse::Move,
         .help = "turn the model about the pivot by these angles, degrees, as one turns a thing in the hand",
         .more = "It is the eye that moves; up stays up, and the pivot stays where it is in the image. "
                 "Walking ends"},
        {.id = CommandId::CameraPan,
         .name = "camera pan",
         .arguments = {number("RIGHT", -10, 10), number("UP", -10, 10)},
         .browser = BrowserUse::Move,
         .help = "move the model across the image, by these parts of its width where the pivot is"},
        {.id = CommandId::CameraApproach,
         .name = "camera approach",
         .arguments = {number("FACTOR", 0.001, 1000)},
         .browser = BrowserUse::Move,
         .help = "go so many times as near to the pivot, which stays where it is in the image"},
        {.id = CommandId::CameraFit,
         .name = "camera fit",
         .arguments = {maybe(manyOf(text("PART", Part)))},
         .step = "look there",
         .browser = BrowserUse::Move,
         .help = "show all of the model, or of these parts, from the side where the camera is",
         .more = "PART is a number or a pattern for names, as `part hide` takes them"},
        {.id = CommandId::CameraView,
         .name = "camera view",
         .arguments = {choice("front|back|left|right|top|bottom|three-quarter")},
         .step = "look there",
         .browser = BrowserUse::Move,
         .help = "show all of the model from that side"},
        {.id = CommandId::CameraReset,
         .name = "camera reset",
         .step = "reset camera",
         .browser = BrowserUse::Move,
         .help = "look as the scene itself says, walking or not"},
        {.id = CommandId::CameraPaste,
         .name = "camera paste",
         .arguments = {text("TEXT")},
         .step = "paste camera",
         .help = "look through a camera that is given as the text of a .cam file",
         .more = "As `load camera` does by its file"},
        {.id = CommandId::CameraAngle,
         .name = "camera angle",
         .arguments = {between("DEGREES", 0, 180)},
         .step = "field of view",
         .browser = BrowserUse::Move,
         .help = "the field of view, from the left to the right edge, with perspective"},
        {.id = CommandId::CameraLens,
         .name = "camera lens",
         .arguments = {number("MM", 0.1, 10000)},
         .step = "field of view",
         .browser = BrowserUse::Move,
         .help = "the same by the focal length of a lens for film of 36 x 24 mm",
         .more = "18 mm are 90 degrees, 50 mm 39.6"},
        {.id = CommandId::CameraZoom,
         .name = "camera zoom",
         .arguments = {number("FACTOR", 0.001, 1000)},
         .step = "field of view",
         .browser = BrowserUse::Move,
         .help = "zoom by a factor; the camera stays where it is",
         .more = "The field of view stays between 0.5 and 170 degrees, or where it is. Prints it then, in "
                 "degrees; without perspective, the width"},
        {.id = CommandId::Up,
         .name = "up",
         .arguments = {maybe(choice("+x|-x|+y|-y|+z|-z|auto"))},
         .step = "up axis",
         .help = "this axis of the model is up; auto: as it was guessed; print what holds now, and why",
         .more =
             "The model stays where it is: the view of one that brings no camera is found again, else the "
             "view is turned upright"},
        {.id = CommandId::Units,
         .name = "units",
         .arguments = {maybe(orElse(number("METRES", 1e-9, 1e9), "auto|mm|cm|m|in|ft"))},
         .step = "unit",
         .help = "set the length of one model unit; print what holds now, and why",
         .more = "Walking, flying and depth of field go by it"},
        {.id = CommandId::Focus,
         .name = "focus",
         .arguments = {number("X", 0, 1), number("Y", 0, 1)},
         .step = "focus there",
         .browser = BrowserUse::Move,
         .sets = {"depthOfField.on", "depthOfField.focus"},
         .help = "focus a lens on what is there, 0..1 from the left and from the top, and print its distance",
         .more = "That is the setting `depthOfField.focus` then. Fails where nothing is seen"},
        {.id = CommandId::Speed,
         .name = "speed",
         .arguments = {number("FACTOR", 0.001, 1000)},
         .browser = BrowserUse::Move,
         .help = "fly so many times as fast as usual",
         .more = "0.001 to 1000, until another scene is shown"},
        {.id = CommandId::Walk,
         .name = "walk",
         .browser = BrowserUse::Move,
         .help = "walk with gravity and collisions",
         .more = "From a view from outside one begins before the door or the front of the model. Fails where "
                 "there "
                 "is no room to stand and no floor below, and where the model is too small"},
        {.id = CommandId::Fly,
         .name = "fly",
         .browser = BrowserUse::Move,
         .help = "fly freely, through walls"},
    };
}

} // namespace app

#include "common/cli/lighting_option_group.h"

#include "rtcore/look/lighting_preset_name.h"

namespace app {

OptionGroup lightingOptionGroup() {
    return {"Surroundings",
            {{.name = "environment",
              .value = ValueKind::Text,
              .argument = "FILE",
              .help = "show this environment map and let it light the scene: a sphere, a cross or a strip",
              .more = "In place of the scene's own, and of its sky",
              .files = {"hdr", "exr", "pfm", "png", "jpg"}},
             {.name = "sky",
              .value = ValueKind::Text,
              .argument = "SPEC",
              .help = "show a computed sky with a sun: the hour, or the keys of a scene's [sky], parted by "
                      "commas, such as 'hour=17,latitude=48.2,turbidity=4'",
              .more = "`direction=1/2/-1` points to the sun. See [formats.md](formats.md)"},
             {.name = "look",
              .value = ValueKind::Choice,
              .argument = "LOOK",
              .help = "what lights the scene in place of its own lights: sky, studio or headlight",
              .more = "`sky`: a sky with a sun, and lights under the ceilings of rooms; `studio`: white "
                      "walls and floor, and three soft lights that mirrors show; `headlight`: one light "
                      "beside the viewer. Without this "
                      "option a model that brings no light gets `sky`, and a scene file keeps what it says",
              .choices = {rtcore::kLightingPresetNames.begin(), rtcore::kLightingPresetNames.end()}}}};
}

} // namespace app

#include "common/cli/selection_option_group.h"

namespace app {

namespace {

std::vector<std::string> suggestLights(std::span<const std::string> /*words*/) { return {"all", "none"}; }

} // namespace

OptionGroup selectionOptionGroup() {
    return {
        "Parts, sections and lights",
        {{.name = "isolate",
          .value = ValueKind::Text,
          .argument = "PART",
          .help = "show this part of the model alone; given several times, these",
          .more = "A name, also with `*` and `?`, or a number, as the command `part isolate` takes them; "
                  "`CUI parts` lists them. What else a `.scn` hides or shows does not count then"},
         {.name = "hide",
          .value = ValueKind::Text,
          .argument = "PART",
          .help = "leave this part of the model out; may be given several times",
          .more = "`--hide` and `--show` count in their order, after `--isolate`"},
         {.name = "show",
          .value = ValueKind::Text,
          .argument = "PART",
          .help = "show this part of the model where the scene hides it; may be given several times"},
         {.name = "section",
          .value = ValueKind::Text,
          .argument = "X,Y,Z,NX,NY,NZ",
          .help = "cut the model open: take away what lies beyond the point, along the normal; may be "
                  "given six times",
          .more = "`--section=0,1.2,0,0,1,0` takes away all above 1.2. In place of the sections of a "
                  "`.scn`"},
         {.name = "section-box",
          .value = ValueKind::Text,
          .argument = "X,Y,Z,X2,Y2,Z2",
          .help = "leave what is in the box between these corners"},
         {.name = "section-except",
          .value = ValueKind::Text,
          .argument = "PART",
          .help = "leave this part of the model whole, whatever is cut; may be given several times"},
         {.name = "section-light",
          .value = ValueKind::Choice,
          .argument = "LIGHT",
          .help = "whole: the rooms of what is cut keep their light, as if nothing was cut; cut: light "
                  "falls in [whole]",
          .choices = {"whole", "cut"}},
         {.name = "section-caps",
          .value = ValueKind::Choice,
          .argument = "COLOURS",
          .help =
              "close solids that are cut: own: in the colours of their materials; one: all in the scene's "
              "sectionColour; none: one looks into them [own]",
          .choices = {"own", "one", "none"}},
         {.name = "lights",
          .value = ValueKind::Text,
          .argument = "LIST",
          .help = "switch these lights on and all others off: names and numbers, parted by commas; all; "
                  "none",
          .more = "Numbers are those that `CUI lights` prints and `.cam` files have. It counts for every "
                  "camera, whatever its `.cam` says. Sky and emitting surfaces stay",
          .suggest = suggestLights}}};
}

} // namespace app

/// A scene with something to switch.
#pragma once

#include "process/sample_scene.h"

namespace test {

/// lit.scn: two lights, two environment maps, a camera of its own; needs room.obj.
inline void writeLitScene(const TemporaryFolder& folder) {
    writeText(folder / "sky.ppm", "P3 2 1 255 10 20 30 200 210 220\n");
    writeText(folder / "lit.scn",
              "version = 1\nmodel = \"room.obj\"\nmodelLights = false\n"
              "[camera]\neye = [0.25, 1.5, 6.0]\nlookAt = [0.0, 1.0, 0.0]\n"
              "[[light]]\nname = \"lamp & co\"\nkind = \"point\"\nposition = [0.0, 6.0, 3.0]\n"
              "intensity = [90.0, 90.0, 90.0]\n"
              "[[light]]\nkind = \"point\"\nposition = [4.0, 5.0, 3.0]\nintensity = [90.0, 90.0, 60.0]\n"
              "[[environment]]\nname = \"noon\"\nequirectangular = \"sky.ppm\"\n"
              "[[environment]]\nname = \"dusk\"\nequirectangular = \"sky.ppm\"\nintensity = 0.1\n"
              "[live]\nexposure.mode = \"fixed\"\nexposure.value = 2.0\n");
}

} // namespace test

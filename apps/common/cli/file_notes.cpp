#include "common/cli/file_notes.h"

namespace app {

std::vector<HelpWord> sceneFileNotes() {
    return {{"*.scn", "a scene: its model, camera, lights, materials and environment maps, as text (TOML)"},
            {"*.bsp", "a model with its kd-tree, as BSPBuilder writes it"},
            {"*.cam", "a camera, the size of the image and its exposure, as text (TOML)"},
            {"*.set", "settings for live frames and for stills, as text (TOML)"},
            {"../share/rtsuite/scenes", "scenes to begin with, as seen from the folder of the programs"}};
}

std::vector<HelpWord> importEnvironmentNotes(std::optional<HelpWord> first) {
    std::vector<HelpWord> notes;
    if (first) notes.push_back(*first);
    notes.insert(notes.end(),
                 {{"RT_ISA", "the instruction set whose vector code is used, of those that --version lists"},
                  {"RT_IMPORTER", "the program that reads models, in place of the one that is installed"},
                  {"TMPDIR", "the folder for temporary files where there is no room in memory"}});
    return notes;
}

std::vector<std::string> modelExtensions() {
    return {"obj", "ply", "gltf", "glb", "3ds", "x",     "fbx", "dae", "stl",
            "off", "3mf", "x3d",  "lwo", "ac",  "blend", "xyz", "pts"};
}

std::vector<std::string> sceneExtensions() {
    std::vector<std::string> all = modelExtensions();
    all.insert(all.begin(), {"scn", "bsp"});
    return all;
}

} // namespace app

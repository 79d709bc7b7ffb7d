#include "rtcore/scene/exporter_habits.h"

#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace rtcore {

namespace {

using Units = std::array<double, kLengthUnits>; // m, cm, mm, inch, foot

constexpr double kSure = 4; ///< the user would have to have chosen otherwise
constexpr double kAny = 0;  ///< what the program was given

struct FormatHabit {
    std::string_view mark; ///< in the importer's name
    std::string_view name;
    double zUp;
    Units units;
    const char* files = form("{0} files"); ///< a form with its name
};

constexpr Units kSuch{0.4, 0.2, 0, -1, -2.5};

// Scans come in metres and millimetres; printing knows millimetres alone. What games and simulators read is
// made in metres. Assimp turns 3DS and ASE, which count z upwards, but not Blender's own files,
// trueSpace, Quick3D and height maps.
constexpr std::array kFormats{
    FormatHabit{"Stereolithography", "STL", 2, {0, -0.5, 2, -0.5, -3}},
    FormatHabit{"Stanford", "PLY", -0.7, {0.3, 0, 0.3, -2, -3}},
    FormatHabit{"Point cloud", "XYZ and PTS", 2, {2, 0, 0.3, -2, -2}},
    FormatHabit{"Wavefront", "OBJ", -1.5, {0.4, 0.4, -0.2, -1.2, -2.5}},
    FormatHabit{"Open CASCADE", "STEP", kSure, {-2, -2, 2, -2, -3}},
    FormatHabit{"AC3D", "AC3D", -kSure, {3, 0, -1, -0.5, 0}},
    FormatHabit{"Blender", "Blender", kSure, {6, 0, -1, -1, -2}},
    FormatHabit{"TrueSpace", "trueSpace", kSure, kSuch},
    FormatHabit{"Quick3D", "Quick3D", kSure, kSuch},
    FormatHabit{"Heightmap", "3D GameStudio", kSure, kSuch, form("height maps of {0}")},
    FormatHabit{"", "", -kSure, kSuch, form("such files")},
};

struct ProgramHabit {
    std::string_view mark; ///< in what the file says, small letters
    std::string_view name;
    double zUp;      ///< of formats that leave it to the program
    double zUpInObj; ///< many turn the model for OBJ, whose readers expect +y
    Units units;
};

constexpr Units kMillimetres{-kSure, -1, kSure, -1, -kSure};
constexpr Units kCentimetres{-1, 3, -1, -1, -3};
constexpr Units kUnitless{0, 0, 0, 0, -2};

// The first that fits counts. CAD and printing programs count z upwards and in millimetres in every format.
constexpr std::array kPrograms{
    ProgramHabit{"openscad", "OpenSCAD", kSure, kSure, kMillimetres},
    ProgramHabit{"freecad", "FreeCAD", kSure, kSure, kMillimetres},
    ProgramHabit{"mesh-mesh-mesh", "FreeCAD", kSure, kSure, kMillimetres},
    ProgramHabit{"tinkercad", "Tinkercad", kSure, kSure, kMillimetres},
    ProgramHabit{"meshmixer", "Meshmixer", kSure, 0, kMillimetres},
    ProgramHabit{"netfabb", "netfabb", kSure, kSure, kMillimetres},
    ProgramHabit{"uranium stlwriter", "Cura", kSure, kSure, kMillimetres},
    ProgramHabit{"slic3r", "Slic3r", kSure, kSure, kMillimetres},
    ProgramHabit{"stlb atf", "Autodesk's CAD", kSure, kSure, kMillimetres},
    ProgramHabit{"stlexp", "CAD", kSure, kSure, kMillimetres},
    ProgramHabit{"solidworks", "SolidWorks", kSure, 1, kMillimetres},
    ProgramHabit{"fusion 360", "Fusion 360", kSure, 1, kMillimetres},
    ProgramHabit{"rhino", "Rhino", kSure, -0.5, {-0.5, 0, 2, -1, -3}},
    ProgramHabit{"gmsh", "Gmsh", 3, 3, {1, -1, 1, -2, -3}},
    ProgramHabit{"sketchup", "SketchUp", kSure, -1, {0.5, 0, 1, 1, -1}},
    ProgramHabit{"sweet home 3d", "Sweet Home 3D", -kSure, -kSure, kCentimetres},
    ProgramHabit{"blender", "Blender", kSure, -kSure, {1.2, 0.2, 0.2, -1.5, -3}},
    ProgramHabit{"uses centimeters as units", "Maya", -2, -2, kCentimetres},
    ProgramHabit{"maya", "Maya", -2, -2, kCentimetres},
    ProgramHabit{"cinema 4d", "Cinema 4D", -2, -2, kCentimetres},
    ProgramHabit{"cinema4d", "Cinema 4D", -2, -2, kCentimetres},
    ProgramHabit{"3ds max", "3ds Max", 2, -1.5, {0.5, 0.5, 0, 1, -2}},
    ProgramHabit{"houdini", "Houdini", -kSure, -kSure, {3, 0, -1, -2, -3}},
    ProgramHabit{"zbrush", "ZBrush", -kSure, -kSure, kUnitless},
    ProgramHabit{"milkshape", "MilkShape", -kSure, -kSure, kUnitless},
    ProgramHabit{"wings 3d", "Wings 3D", -kSure, -kSure, kUnitless},
    ProgramHabit{"assimp", "Assimp", -2.5, -1, {0.5, 0, 0, -1, -2}},
    ProgramHabit{"open asset import library", "Assimp", -2.5, -1, {0.5, 0, 0, -1, -2}},
};

std::string smallLetters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

const FormatHabit& formatHabit(const ModelOrigin& origin) {
    return *std::find_if(kFormats.begin(), kFormats.end(), [&](const FormatHabit& habit) {
        return origin.format.find(habit.mark) != std::string::npos;
    });
}

} // namespace

OriginHabits habitsOf(const ModelOrigin& origin) {
    const FormatHabit& format = formatHabit(origin);
    OriginHabits habits{format.zUp, format.units, say(format.files, format.name)};
    const std::string words = smallLetters(origin.exporter);
    const auto program = std::find_if(kPrograms.begin(), kPrograms.end(), [&](const ProgramHabit& habit) {
        return words.find(habit.mark) != std::string::npos;
    });
    if (program == kPrograms.end()) return habits;
    const bool obj = format.mark == "Wavefront";
    // A program that converts what it is given leaves the format's habits as they are.
    const bool converts = program->name == "Assimp";
    habits.zUp = (converts ? habits.zUp : kAny) + (obj ? program->zUpInObj : program->zUp);
    // Where the program was given another unit than its usual one, the format's counts.
    constexpr double kFormatToo = 0.5;
    for (std::size_t i = 0; i < kLengthUnits; ++i)
        habits.units.at(i) = program->units.at(i) + kFormatToo * format.units.at(i);
    habits.name = program->name;
    return habits;
}

} // namespace rtcore

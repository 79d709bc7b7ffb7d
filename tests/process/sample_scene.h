/// Input that the process tests feed to the programs: small models and text files, written on the spot.
#pragma once

#include "support/run_program.h"
#include "support/temporary_folder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace test {

/// Runs a program of this build with progress off, unless the arguments ask for some.
ProgramResult renderer(const std::vector<std::string>& arguments, const ProgramSettings& settings = {});
ProgramResult bspBuilder(const std::vector<std::string>& arguments, const ProgramSettings& settings = {});
std::filesystem::path programPath(const std::string& name);

/// A room of a few boxes with normals of its own; OBJ.
void writeRoom(const std::filesystem::path& path);
/// A wavy floor of 2 * side * side triangles; OBJ. Side 200: 80,000 triangles, about a second to build and
/// load.
void writeWaves(const std::filesystem::path& path, int side);
/// A .cam that looks into the room from (x, 2, 6), with `extra` lines.
void writeCamera(const std::filesystem::path& path, double x, const std::string& extra = "");
void writeText(const std::filesystem::path& path, const std::string& text);
std::string readBytes(const std::filesystem::path& path);

struct PictureSize {
    int width = 0, height = 0;
    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};
/// By the header of a PNG, in memory or in a file; {0, 0} when it is none.
PictureSize pngSize(const std::string& bytes);
PictureSize pngFileSize(const std::filesystem::path& path);

/// Names of all files in the folder, sorted.
std::vector<std::string> filesIn(const std::filesystem::path& folder);

} // namespace test

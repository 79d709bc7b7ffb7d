/// Whether the colours of a file are linear, or codes as displays show them. Formats of before colour
/// management do not say it; programs that write them have their habits.
#pragma once

#include "rtcore/io/import/materials/material_mapping.h"

#include <array>
#include <string_view>

namespace rtcore {

enum class ColourEncoding { Linear, Display };

/// A habit of programs, and the sign of them.
struct ExporterColours {
    enum class Sign { Begins, Contains };
    std::string_view words; ///< of what the file says of the program that wrote it, in small letters
    Sign sign;
    ColourEncoding encoding;
};

/// The first that fits counts (docs/import.md, "Colours of materials").
inline constexpr std::array kExporterColours{
    ExporterColours{"blender", ExporterColours::Sign::Contains, ColourEncoding::Linear},
    ExporterColours{"maya", ExporterColours::Sign::Contains, ColourEncoding::Linear},
    ExporterColours{"sketchup", ExporterColours::Sign::Contains, ColourEncoding::Display},
    ExporterColours{"rhino", ExporterColours::Sign::Begins, ColourEncoding::Display},
    ExporterColours{"freecad", ExporterColours::Sign::Begins, ColourEncoding::Display},
    ExporterColours{"three.js", ExporterColours::Sign::Begins, ColourEncoding::Display}};

/// `exporter`: what the file says of the program that wrote it, "" for nothing. Null where nothing is known
/// of it: its colours are taken as linear.
const ExporterColours* exporterColours(std::string_view exporter);

bool hasDisplayColours(std::string_view exporter);

/// Decodes the colours of a material that has them as displays show them. Those above 1 are light, and stay.
void decodeColours(SourceMaterial& material);

} // namespace rtcore

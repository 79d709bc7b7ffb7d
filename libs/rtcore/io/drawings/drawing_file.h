/// Drawings as files: SVG and PDF to scale, DXF in metres.
#pragma once

#include "rtcore/io/drawings/sheet.h"

#include <filesystem>
#include <optional>
#include <string>

namespace rtcore {

enum class DrawingFormat { Svg, Pdf, Dxf };
/// By the extension; nothing for others.
std::optional<DrawingFormat> drawingFormatOf(const std::filesystem::path& path);

/// SVG 1.1 in millimetres, a group for each layer, named as Inkscape does.
std::string svgOf(const Sheet& sheet);

/// PDF with a page for each sheet; what is outside of its frame is clipped. Letters that Latin-1 lacks become
/// question marks. Throws Refusal where a sheet is wider or higher than 5.08 m, which PDF cannot be.
std::string pdfOf(const std::vector<Sheet>& sheets);

/// DXF of AutoCAD's release 12, in metres and at the positions that the model's file has, with the layers
/// CUT, CUT-OPEN, SEEN and ROOMS.
std::string dxfOf(const Drawing& drawing);

/// Writes the drawing, all of it or nothing; on `paper`, if that is given, as PDF on several pages where it
/// is too large for one. Throws FileError CannotWrite; Refusal where it does not fit on one sheet of paper
/// and is no PDF, and where there are more than 400 of them.
void writeDrawing(const std::filesystem::path& path, const Drawing& drawing, const SheetOptions& options,
                  const std::optional<PaperSize>& paper);

} // namespace rtcore

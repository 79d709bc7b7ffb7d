/// Drawings as files: SVG, PDF, PNG and TIFF to scale, DXF in metres.
#pragma once

#include "rtcore/io/drawings/drawing_format.h"
#include "rtcore/io/drawings/sheet.h"
#include "rtcore/scene/image.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rtcore {

/// SVG 1.1 in millimetres, a group for each layer, named as Inkscape does.
std::string svgOf(const Sheet& sheet);

/// PDF with a page for each sheet; what is outside of its frame is clipped. Letters that Latin-1 lacks become
/// question marks. Throws Refusal where a sheet is wider or higher than 5.08 m, which PDF cannot be.
std::string pdfOf(const std::vector<Sheet>& sheets);

/// DXF of AutoCAD's release 12, in metres and at the positions that the model's file has, with the layers
/// CUT, CUT-OPEN, SEEN and ROOMS.
std::string dxfOf(const Drawing& drawing);

/// Throws Refusal where an image cannot be as large: more than kMaxImageSide or kMaxImagePixels.
void refuseLargeImage(double width, double height);

/// The sheet in pixels, so many to an inch, smoothed. `behind`, which may be null, is an image of the same
/// resolution of what is drawn, whose upper left corner is that of the drawing's bounds, to half a pixel;
/// letters over it have a white rim. Throws Refusal where the sheet has more pixels than an image may have,
/// std::bad_alloc.
LdrImage sheetImage(const Sheet& sheet, double dpi, const LdrImage* behind);

/// A drawing, ready to be written; a null image is none.
struct DrawingOrder {
    const Drawing& drawing;
    SheetOptions options;
    std::optional<PaperSize> paper;  ///< nothing: one sheet that is as large as it must be
    const LdrImage* light = nullptr; ///< of an image: what is rendered of the drawing's bounds
    bool lines = true;               ///< of an image with light: whether it has them as well
};

/// The files that writeDrawing() writes: `path`, or, of an image on several sheets, "plan-A1.png" for
/// "plan.png" and so on. Throws Refusal for another extension, where a drawing does not fit on one sheet of
/// paper and is neither PDF nor image, and where there are more than 400 sheets.
std::vector<std::filesystem::path> drawingFiles(const std::filesystem::path& path, const DrawingOrder& order);

/// Writes the drawing, each file all of it or nothing. Throws what drawingFiles() throws, and FileError
/// CannotWrite.
void writeDrawing(const std::filesystem::path& path, const DrawingOrder& order);

} // namespace rtcore

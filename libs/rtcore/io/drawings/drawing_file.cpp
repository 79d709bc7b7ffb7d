#include "rtcore/io/drawings/drawing_file.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

constexpr int kMaxSheets = 400;

std::vector<Sheet> sheetsFor(const DrawingOrder& order) {
    if (order.paper) return sheetsOf(order.drawing, order.options, *order.paper);
    return {sheetOf(order.drawing, order.options)};
}

DrawingFormat formatFor(const std::filesystem::path& path) {
    const std::optional<DrawingFormat> format = drawingFormatOf(path);
    if (!format) throw Refusal(say("{0}: drawings are .svg, .pdf, .dxf, .png or .tif files", path.string()));
    return *format;
}

void writeText(const std::filesystem::path& path, const std::string& content) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(content));
    writeFileAtomically(path, std::span(&bytes, 1));
}

/// Light has its own colours where the model is cut.
void prepareForLight(Sheet& sheet, bool lines) {
    if (!lines) sheet.layers.clear();
    for (SheetLayer& layer : sheet.layers) layer.areas.clear();
}

void writeImages(const std::vector<std::filesystem::path>& paths, const DrawingOrder& order) {
    std::vector<Sheet> sheets = sheetsFor(order);
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (order.light != nullptr) prepareForLight(sheets[i], order.lines);
        writeImage(paths[i], sheetImage(sheets[i], order.options.dpi, order.light),
                   {.dpi = order.options.dpi});
    }
}

} // namespace

std::vector<std::filesystem::path> drawingFiles(const std::filesystem::path& path,
                                                const DrawingOrder& order) {
    const DrawingFormat format = formatFor(path);
    const int sheets = order.paper && format != DrawingFormat::Dxf
                           ? numberOfSheets(order.drawing, order.options.scale, *order.paper)
                           : 1;
    if (sheets > kMaxSheets)
        throw Refusal(say("the drawing takes more than {0} sheets of {1}; take a smaller scale", kMaxSheets,
                          order.paper->name));
    if (sheets > 1 && format == DrawingFormat::Svg)
        throw Refusal(
            say("the drawing takes {0} sheets of {1}; write a .pdf, or take a larger paper or a smaller "
                "scale",
                sheets, order.paper->name));
    if (format != DrawingFormat::Image) return {path};
    std::vector<std::filesystem::path> paths;
    for (const Sheet& sheet : sheetsFor(order)) {
        const double pixels = pixelsOfMillimetre(order.options.dpi);
        refuseLargeImage(sheet.width * pixels, sheet.height * pixels);
        if (sheet.label.empty()) return {path};
        const std::string name = path.stem().string() + "-" + sheet.label + path.extension().string();
        paths.push_back(path.parent_path() / name);
    }
    return paths;
}

void writeDrawing(const std::filesystem::path& path, const DrawingOrder& order) {
    const std::vector<std::filesystem::path> paths = drawingFiles(path, order);
    switch (formatFor(path)) {
    case DrawingFormat::Dxf:
        return writeText(path, dxfOf(order.drawing));
    case DrawingFormat::Pdf:
        return writeText(path, pdfOf(sheetsFor(order)));
    case DrawingFormat::Svg:
        return writeText(path, svgOf(sheetsFor(order).front()));
    case DrawingFormat::Image:
        return writeImages(paths, order);
    }
}

} // namespace rtcore

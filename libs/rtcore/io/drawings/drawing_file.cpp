#include "rtcore/io/drawings/drawing_file.h"

#include "rtcore/platform/files.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

constexpr int kMaxSheets = 400;

std::string contentOf(DrawingFormat format, const Drawing& drawing, const SheetOptions& options,
                      const std::optional<PaperSize>& paper) {
    if (format == DrawingFormat::Dxf) return dxfOf(drawing);
    const std::vector<Sheet> sheets =
        paper ? sheetsOf(drawing, options, *paper) : std::vector<Sheet>{sheetOf(drawing, options)};
    if (format == DrawingFormat::Pdf) return pdfOf(sheets);
    if (sheets.size() > 1)
        throw Refusal(
            say("the drawing takes {0} sheets of {1}; write a .pdf, or take a larger paper or a smaller "
                "scale",
                sheets.size(), paper->name));
    return svgOf(sheets[0]);
}

} // namespace

std::optional<DrawingFormat> drawingFormatOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".svg") return DrawingFormat::Svg;
    if (extension == ".pdf") return DrawingFormat::Pdf;
    if (extension == ".dxf") return DrawingFormat::Dxf;
    return std::nullopt;
}

void writeDrawing(const std::filesystem::path& path, const Drawing& drawing, const SheetOptions& options,
                  const std::optional<PaperSize>& paper) {
    const std::optional<DrawingFormat> format = drawingFormatOf(path);
    if (!format) throw Refusal(say("{0}: drawings are .svg, .pdf or .dxf files", path.string()));
    if (paper && numberOfSheets(drawing, options.scale, *paper) > kMaxSheets)
        throw Refusal(say("the drawing takes more than {0} sheets of {1}; take a smaller scale", kMaxSheets,
                          paper->name));
    const std::string content = contentOf(*format, drawing, options, paper);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(content));
    writeFileAtomically(path, std::span(&bytes, 1));
}

} // namespace rtcore

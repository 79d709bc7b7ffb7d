#include "rtcore/io/drawings/drawing_file.h"

#include <fmt/format.h>

#include <iterator>

namespace rtcore {

namespace {

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&') {
            result += "&amp;";
        } else if (c == '<') {
            result += "&lt;";
        } else if (static_cast<unsigned char>(c) < 0x20) {
            result += ' ';
        } else {
            result += c;
        }
    }
    return result;
}

void addPath(std::string& data, const FlatLoop& points, bool closed) {
    for (std::size_t i = 0; i < points.size(); ++i)
        fmt::format_to(std::back_inserter(data), "{}{:.5f} {:.5f}", i == 0 ? "M" : "L", points[i][0],
                       points[i][1]);
    if (closed) data += 'Z';
}

void addLayer(std::string& svg, const SheetLayer& layer) {
    const auto out = std::back_inserter(svg);
    fmt::format_to(out, "<g id=\"{0}\" inkscape:groupmode=\"layer\" inkscape:label=\"{0}\">\n", layer.name);
    if (!layer.areas.empty()) {
        std::string data;
        for (const FlatLoop& area : layer.areas) addPath(data, area, true);
        const int code = static_cast<int>(255 * layer.grey);
        fmt::format_to(out, "<path fill=\"#{0:02x}{0:02x}{0:02x}\" fill-rule=\"evenodd\" d=\"{1}\"/>\n", code,
                       data);
    }
    for (const SheetLayer::Line& line : layer.lines) {
        std::string data;
        addPath(data, line.points, line.closed);
        fmt::format_to(out, "<path fill=\"none\" stroke=\"#000\" stroke-width=\"{:g}\" d=\"{}\"/>\n",
                       line.width, data);
    }
    // Capital letters of sans-serif faces are about seven tenths of their size.
    for (const SheetLayer::Text& text : layer.texts)
        fmt::format_to(out,
                       "<text x=\"{:.5f}\" y=\"{:.5f}\" font-family=\"sans-serif\" font-size=\"{:g}\" "
                       "text-anchor=\"{}\">{}</text>\n",
                       text.at[0], text.at[1], text.height / 0.7, text.left ? "start" : "middle",
                       escaped(text.text));
    svg += "</g>\n";
}

} // namespace

std::string svgOf(const Sheet& sheet) {
    std::string svg = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" "
        "width=\"{0:.5f}mm\" height=\"{1:.5f}mm\" viewBox=\"0 0 {0:.5f} {1:.5f}\" stroke-linejoin=\"round\" "
        "stroke-linecap=\"round\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        sheet.width, sheet.height);
    for (const SheetLayer& layer : sheet.layers) addLayer(svg, layer);
    addLayer(svg, sheet.margin);
    return svg + "</svg>\n";
}

} // namespace rtcore

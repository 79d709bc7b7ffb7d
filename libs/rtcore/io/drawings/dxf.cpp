#include "rtcore/io/drawings/drawing_file.h"

#include <fmt/format.h>

#include <iterator>

namespace rtcore {

namespace {

/// Pairs of a group code and a value, a line for each.
class DxfText {
  public:
    template <typename Value>
    void add(int code, const Value& value) {
        fmt::format_to(std::back_inserter(text_), "{:3}\n{}\n", code, value);
    }
    void point(int code, const FlatPoint& p) {
        add(code, fmt::format("{:.9f}", p[0]));
        add(code + 10, fmt::format("{:.9f}", p[1]));
        add(code + 20, "0.0");
    }
    void entity(std::string_view type, std::string_view layer) {
        add(0, type);
        add(8, layer);
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

void addHeader(DxfText& dxf, const Drawing& drawing) {
    constexpr int kMetres = 6;
    dxf.add(0, "SECTION");
    dxf.add(2, "HEADER");
    dxf.add(9, "$ACADVER");
    dxf.add(1, "AC1009");
    dxf.add(9, "$INSUNITS");
    dxf.add(70, kMetres);
    dxf.add(9, "$EXTMIN");
    dxf.point(10, drawing.low);
    dxf.add(9, "$EXTMAX");
    dxf.point(10, drawing.high);
    dxf.add(0, "ENDSEC");
}

void addLayers(DxfText& dxf) {
    constexpr int kBlack = 7, kGrey = 8;
    const std::array<std::pair<std::string_view, int>, 4> layers{
        {{"CUT", kBlack}, {"CUT-OPEN", kBlack}, {"SEEN", kGrey}, {"ROOMS", kBlack}}};
    dxf.add(0, "SECTION");
    dxf.add(2, "TABLES");
    dxf.add(0, "TABLE");
    dxf.add(2, "LAYER");
    dxf.add(70, layers.size());
    for (const auto& [name, colour] : layers) {
        dxf.add(0, "LAYER");
        dxf.add(2, name);
        dxf.add(70, 0);
        dxf.add(62, colour);
        dxf.add(6, "CONTINUOUS");
    }
    dxf.add(0, "ENDTAB");
    dxf.add(0, "ENDSEC");
}

void addPolyline(DxfText& dxf, const FlatLoop& points, bool closed, std::string_view layer) {
    dxf.entity("POLYLINE", layer);
    dxf.add(66, 1);
    dxf.point(10, {0, 0});
    dxf.add(70, closed ? 1 : 0);
    for (const FlatPoint& p : points) {
        dxf.entity("VERTEX", layer);
        dxf.point(10, p);
    }
    dxf.entity("SEQEND", layer);
}

} // namespace

std::string dxfOf(const Drawing& drawing) {
    constexpr double kLetters = 0.25; // metres
    DxfText dxf;
    addHeader(dxf, drawing);
    addLayers(dxf);
    dxf.add(0, "SECTION");
    dxf.add(2, "ENTITIES");
    for (const FlatLine& line : drawing.seen) {
        dxf.entity("LINE", "SEEN");
        dxf.point(10, line.a);
        dxf.point(11, line.b);
    }
    for (const FlatLoop& loop : drawing.solids) addPolyline(dxf, loop, true, "CUT");
    for (const FlatLoop& loop : drawing.loops) addPolyline(dxf, loop, true, "CUT-OPEN");
    for (const FlatLoop& chain : drawing.chains) addPolyline(dxf, chain, false, "CUT-OPEN");
    for (std::size_t i = 0; i < drawing.rooms.size(); ++i) {
        dxf.entity("TEXT", "ROOMS");
        dxf.point(10, drawing.rooms[i].label);
        dxf.add(40, kLetters);
        dxf.add(1, fmt::format("{}: {:.2f} m2", i + 1, drawing.rooms[i].area));
    }
    dxf.add(0, "ENDSEC");
    dxf.add(0, "EOF");
    return dxf.text();
}

} // namespace rtcore

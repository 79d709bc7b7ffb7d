#include "rtcore/io/import/materials/exporter_colours.h"

#include "rtcore/math/colour.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>

namespace rtcore {

namespace {

Colour decoded(Colour c) {
    const auto linear = [](float v) { return v > 0 && v < 1 ? srgbDecode(v) : v; };
    return {linear(c.r), linear(c.g), linear(c.b)};
}

bool fits(const ExporterColours& row, std::string_view exporter) {
    return row.sign == ExporterColours::Sign::Begins ? exporter.starts_with(row.words)
                                                     : exporter.find(row.words) != std::string_view::npos;
}

} // namespace

const ExporterColours* exporterColours(std::string_view exporter) {
    std::string small(exporter);
    std::ranges::transform(small, small.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto row =
        std::ranges::find_if(kExporterColours, [&](const ExporterColours& e) { return fits(e, small); });
    return row != kExporterColours.end() ? &*row : nullptr;
}

bool hasDisplayColours(std::string_view exporter) {
    const ExporterColours* const row = exporterColours(exporter);
    return row != nullptr && row->encoding == ColourEncoding::Display;
}

void decodeColours(SourceMaterial& material) {
    // Where an image is to take its place it stays as it is known.
    const bool unset = material.diffuse == kUnsetDiffuse && !material.diffuseMap.empty();
    if (!unset) material.diffuse = decoded(material.diffuse);
    for (Colour* const colour :
         {&material.specular, &material.emission, &material.reflective, &material.transmission})
        *colour = decoded(*colour);
}

} // namespace rtcore

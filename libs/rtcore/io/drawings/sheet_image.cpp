#include "rtcore/io/drawings/drawing_file.h"
#include "rtcore/platform/sentence.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

namespace rtcore {

namespace {

struct DestroySurface {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;

/// Pixels of 32 bits: no alpha, red, green, blue from the highest byte down.
Surface surfaceOf(int width, int height) {
    Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
    if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
    return surface;
}

std::uint32_t* rowOf(cairo_surface_t* surface, int y) {
    unsigned char* const data = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    return reinterpret_cast<std::uint32_t*>(data + static_cast<std::size_t>(y) * stride);
}

class SheetPainter {
  public:
    SheetPainter(cairo_surface_t* surface, double pixelsOfMillimetre, bool rims)
        : surface_(surface), cairo_(cairo_create(surface)), factor_(pixelsOfMillimetre), rims_(rims) {
        cairo_set_source_rgb(cairo(), 1, 1, 1);
        cairo_paint(cairo());
        cairo_scale(cairo(), factor_, factor_);
        cairo_set_line_join(cairo(), CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(cairo(), CAIRO_LINE_CAP_ROUND);
        cairo_set_fill_rule(cairo(), CAIRO_FILL_RULE_EVEN_ODD);
        cairo_select_font_face(cairo(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    }

    void clip(const FlatPoint& low, const FlatPoint& high) {
        cairo_rectangle(cairo(), low[0], low[1], high[0] - low[0], high[1] - low[1]);
        cairo_clip(cairo());
    }
    void endClip() { cairo_reset_clip(cairo()); }

    /// Pixel by pixel, where the clip lets it.
    void add(const LdrImage& image, const FlatPoint& corner) {
        const Surface source = surfaceOf(image.width, image.height);
        for (int y = 0; y < image.height; ++y) {
            std::uint32_t* const row = rowOf(source.get(), y);
            for (int x = 0; x < image.width; ++x) {
                const Rgba8 pixel = image.at(x, y);
                row[x] = std::uint32_t{pixel.r} << 16U | std::uint32_t{pixel.g} << 8U | pixel.b;
            }
        }
        cairo_surface_mark_dirty(source.get());
        cairo_save(cairo());
        cairo_identity_matrix(cairo());
        cairo_set_source_surface(cairo(), source.get(), std::round(corner[0] * factor_),
                                 std::round(corner[1] * factor_));
        cairo_paint(cairo());
        cairo_restore(cairo());
    }

    void add(const SheetLayer& layer) {
        for (const FlatLoop& area : layer.areas) path(area, true);
        cairo_set_source_rgb(cairo(), layer.grey, layer.grey, layer.grey);
        cairo_fill(cairo());
        cairo_set_source_rgb(cairo(), 0, 0, 0);
        for (const SheetLayer::Line& line : layer.lines) {
            path(line.points, line.closed);
            cairo_set_line_width(cairo(), line.width);
            cairo_stroke(cairo());
        }
        for (const SheetLayer::Text& text : layer.texts)
            if (rims_) addRim(text);
        for (const SheetLayer::Text& text : layer.texts) add(text);
    }

    /// Throws std::bad_alloc where memory was not enough for all of it, Refusal where a text is no UTF-8.
    void finish() {
        const cairo_status_t status = cairo_status(cairo());
        if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
        if (status != CAIRO_STATUS_SUCCESS)
            throw Refusal(say("the image cannot be drawn: {0}", cairo_status_to_string(status)));
        cairo_surface_flush(surface_);
    }

  private:
    cairo_t* cairo() const { return cairo_.get(); }

    void path(const FlatLoop& loop, bool closed) {
        for (std::size_t i = 0; i < loop.size(); ++i)
            i == 0 ? cairo_move_to(cairo(), loop[i][0], loop[i][1])
                   : cairo_line_to(cairo(), loop[i][0], loop[i][1]);
        if (closed) cairo_close_path(cairo());
    }

    void path(const SheetLayer::Text& text) {
        cairo_set_font_size(cairo(), text.height / 0.7);
        cairo_text_extents_t extents;
        cairo_text_extents(cairo(), text.text.c_str(), &extents);
        cairo_move_to(cairo(), text.at[0] - (text.left ? 0 : 0.5 * extents.x_advance), text.at[1]);
        cairo_text_path(cairo(), text.text.c_str());
    }

    void addRim(const SheetLayer::Text& text) {
        constexpr double kRim = 0.8; // mm
        path(text);
        cairo_set_source_rgb(cairo(), 1, 1, 1);
        cairo_set_line_width(cairo(), kRim);
        cairo_stroke(cairo());
        cairo_set_source_rgb(cairo(), 0, 0, 0);
    }

    void add(const SheetLayer::Text& text) {
        path(text);
        cairo_set_fill_rule(cairo(), CAIRO_FILL_RULE_WINDING);
        cairo_fill(cairo());
        cairo_set_fill_rule(cairo(), CAIRO_FILL_RULE_EVEN_ODD);
    }

    struct DestroyCairo {
        void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
    };
    cairo_surface_t* surface_;
    std::unique_ptr<cairo_t, DestroyCairo> cairo_;
    double factor_;
    bool rims_;
};

LdrImage imageOf(cairo_surface_t* surface, int width, int height) {
    LdrImage image(width, height);
    for (int y = 0; y < height; ++y) {
        const std::uint32_t* const row = rowOf(surface, y);
        for (int x = 0; x < width; ++x)
            image.at(x, y) = {static_cast<std::uint8_t>(row[x] >> 16U),
                              static_cast<std::uint8_t>(row[x] >> 8U), static_cast<std::uint8_t>(row[x])};
    }
    return image;
}

} // namespace

void refuseLargeImage(double width, double height) {
    if (width < kMaxImageSide && height < kMaxImageSide && width * height <= double{kMaxImagePixels}) return;
    throw Refusal(say("{0} x {1} pixels are more than an image can have; take fewer to an inch or a smaller "
                      "scale; lines without light go on several sheets of paper",
                      fmt::format("{:.0f}", width), fmt::format("{:.0f}", height)));
}

LdrImage sheetImage(const Sheet& sheet, double dpi, const LdrImage* behind) {
    const double factor = pixelsOfMillimetre(dpi);
    const double wide = std::max(1.0, std::round(sheet.width * factor));
    const double high = std::max(1.0, std::round(sheet.height * factor));
    refuseLargeImage(wide, high);
    const int width = static_cast<int>(wide), height = static_cast<int>(high);
    const Surface surface = surfaceOf(width, height);
    SheetPainter painter(surface.get(), factor, behind != nullptr);
    painter.clip(sheet.frameLow, sheet.frameHigh);
    if (behind != nullptr) painter.add(*behind, sheet.corner);
    for (const SheetLayer& layer : sheet.layers) painter.add(layer);
    painter.endClip();
    painter.add(sheet.margin);
    painter.finish();
    return imageOf(surface.get(), width, height);
}

} // namespace rtcore

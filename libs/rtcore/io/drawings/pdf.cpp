#include "rtcore/io/drawings/drawing_file.h"
#include "rtcore/platform/sentence.h"

#include <hpdf.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>

namespace rtcore {

namespace {

constexpr double kPointsOfMillimetre = 72 / 25.4;

/// Letters that a page cannot have become question marks.
std::string latin1(std::string_view utf8) {
    std::string text;
    for (std::size_t i = 0; i < utf8.size();) {
        const auto c = static_cast<unsigned char>(utf8[i++]);
        if (c < 0x80) {
            text += c < 0x20 ? ' ' : static_cast<char>(c);
            continue;
        }
        const bool two = (c == 0xC2 || c == 0xC3) && i < utf8.size();
        text += two ? static_cast<char>((c & 3U) << 6U | (static_cast<unsigned char>(utf8[i]) & 0x3FU)) : '?';
        while (i < utf8.size() && (static_cast<unsigned char>(utf8[i]) & 0xC0U) == 0x80U) ++i;
    }
    return text;
}

/// One page, in millimetres from its upper left corner.
class PdfPage {
  public:
    PdfPage(HPDF_Doc document, HPDF_Font font, const Sheet& sheet)
        : page_(HPDF_AddPage(document)), font_(font), height_(sheet.height) {
        HPDF_Page_SetWidth(page_, points(sheet.width));
        HPDF_Page_SetHeight(page_, points(sheet.height));
        HPDF_Page_SetLineJoin(page_, HPDF_ROUND_JOIN);
        HPDF_Page_SetLineCap(page_, HPDF_ROUND_END);
        HPDF_Page_GSave(page_);
        HPDF_Page_Rectangle(page_, points(sheet.frameLow[0]), upwards(sheet.frameHigh[1]),
                            points(sheet.frameHigh[0] - sheet.frameLow[0]),
                            points(sheet.frameHigh[1] - sheet.frameLow[1]));
        HPDF_Page_Clip(page_);
        HPDF_Page_EndPath(page_);
        for (const SheetLayer& layer : sheet.layers) add(layer);
        HPDF_Page_GRestore(page_);
        add(sheet.margin);
    }

  private:
    static HPDF_REAL points(double millimetres) {
        return static_cast<HPDF_REAL>(millimetres * kPointsOfMillimetre);
    }
    HPDF_REAL upwards(double down) const { return points(height_ - down); }

    void path(const FlatLoop& loop, bool closed) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto step = i == 0 ? HPDF_Page_MoveTo : HPDF_Page_LineTo;
            step(page_, points(loop[i][0]), upwards(loop[i][1]));
        }
        if (closed) HPDF_Page_ClosePath(page_);
    }

    void add(const SheetLayer& layer) {
        HPDF_Page_SetGrayFill(page_, static_cast<HPDF_REAL>(layer.grey));
        for (const FlatLoop& area : layer.areas) path(area, true);
        if (!layer.areas.empty()) HPDF_Page_Eofill(page_);
        for (const SheetLayer::Line& line : layer.lines) {
            HPDF_Page_SetLineWidth(page_, points(line.width));
            path(line.points, line.closed);
            HPDF_Page_Stroke(page_);
        }
        HPDF_Page_SetGrayFill(page_, 0);
        for (const SheetLayer::Text& text : layer.texts) add(text);
    }

    /// Capitals of Helvetica are 718 thousandths of its size.
    void add(const SheetLayer::Text& text) {
        const std::string letters = latin1(text.text);
        HPDF_Page_BeginText(page_);
        HPDF_Page_SetFontAndSize(page_, font_, points(text.height / 0.718));
        const HPDF_REAL width = text.left ? 0 : HPDF_Page_TextWidth(page_, letters.c_str());
        HPDF_Page_TextOut(page_, points(text.at[0]) - width / 2, upwards(text.at[1]), letters.c_str());
        HPDF_Page_EndText(page_);
    }

    HPDF_Page page_;
    HPDF_Font font_;
    double height_;
};

std::string contentOf(HPDF_Doc document) {
    HPDF_SaveToStream(document);
    std::string content(HPDF_GetStreamSize(document), '\0');
    HPDF_UINT32 size = static_cast<HPDF_UINT32>(content.size());
    HPDF_ResetStream(document);
    HPDF_ReadFromStream(document, reinterpret_cast<HPDF_BYTE*>(content.data()), &size);
    content.resize(size);
    return content;
}

} // namespace

std::string pdfOf(const std::vector<Sheet>& sheets) {
    constexpr double kLargest = 5080;
    for (const Sheet& sheet : sheets) {
        if (std::max(sheet.width, sheet.height) > kLargest)
            throw Refusal(form(
                "a page of a .pdf is at most 5.08 m wide and high; name a paper, or take a smaller scale"));
    }
    const std::unique_ptr<HPDF_Doc_Rec, decltype(&HPDF_Free)> document(HPDF_New(nullptr, nullptr), HPDF_Free);
    if (!document) throw std::bad_alloc();
    HPDF_SetCompressionMode(document.get(), HPDF_COMP_ALL);
    const HPDF_Font font = HPDF_GetFont(document.get(), "Helvetica", "WinAnsiEncoding");
    for (const Sheet& sheet : sheets) PdfPage(document.get(), font, sheet);
    std::string content = contentOf(document.get());
    if (const HPDF_STATUS error = HPDF_GetError(document.get()); error != HPDF_OK || content.empty())
        throw Refusal(say("the .pdf cannot be made: error {0} of libharu", error));
    return content;
}

} // namespace rtcore

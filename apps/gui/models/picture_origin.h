/// How an image that a Renderer made for the viewport was made.
#pragma once

#include <QImage>
#include <QString>

namespace gui {

struct PictureOrigin {
    bool paths = false; ///< else by Whitted's rays
    int samples = 0;    ///< of each pixel, at least; 0: some have none of their own yet

    friend bool operator==(const PictureOrigin&, const PictureOrigin&) = default;
};

/// "37 samples" in the user's language.
QString samplesText(int samples);
/// "path tracing, 37 samples per pixel" in the user's language.
QString originText(const PictureOrigin& origin);

/// Writes the origin into the texts that go into files which hold some (PNG), as all programs do
/// (common/settings/image_texts.h).
void describe(QImage& picture, const PictureOrigin& origin);

} // namespace gui

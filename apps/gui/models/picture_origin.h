/// How an image that a Renderer made for the viewport was made.
#pragma once

#include <QImage>
#include <QString>

namespace gui {

struct PictureOrigin {
    bool paths = false; ///< else by Whitted's rays
    int samples = 0;    ///< of each pixel, at least; 0: some have none of their own yet
    /// That a net left in it, in codes of 255, and where it is largest; below 0: not known.
    float error = -1, largestError = -1;

    friend bool operator==(const PictureOrigin&, const PictureOrigin&) = default;
};

/// "37 samples" in the user's language.
QString samplesText(int samples);
/// "±0.6 of 255" in the user's language; empty where the error is not known.
QString errorText(const PictureOrigin& origin);
/// "path tracing, 37 samples per pixel" in the user's language.
QString originText(const PictureOrigin& origin);

/// Writes the origin into the texts that go into files which hold some (PNG), as all programs do
/// (common/settings/image_texts.h).
void describe(QImage& picture, const PictureOrigin& origin);

} // namespace gui

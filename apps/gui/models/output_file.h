/// Output files of the window, at paths of the user's choice, written as the other programs do.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>

namespace gui {

/// Replaces the file, whole or not at all, as rtcore::replaceFile() does. Empty, or why it cannot be.
QString writeOutput(const QString& path, const QByteArray& bytes);
/// The same for an image in the format that the extension names.
QString writeOutput(const QString& path, const QImage& image);

} // namespace gui

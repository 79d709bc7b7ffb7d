#include "gui/models/output_file.h"

#include "gui/session/server_sentence.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImageWriter>

#include <array>
#include <cstddef>
#include <span>

namespace gui {

QString writeOutput(const QString& path, const QByteArray& bytes) {
    const std::span content(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    const std::array pieces{std::as_bytes(content)};
    try {
        rtcore::writeFileAtomically(path.toStdString(), pieces);
    } catch (const rtcore::FileError& error) {
        return translated(error);
    }
    return {};
}

QString writeOutput(const QString& path, const QImage& image) {
    QBuffer buffer;
    QImageWriter writer(&buffer, QFileInfo(path).suffix().toLower().toLatin1());
    return writer.write(image) ? writeOutput(path, buffer.data()) : writer.errorString();
}

} // namespace gui

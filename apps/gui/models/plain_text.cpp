#include "gui/models/plain_text.h"

#include "rtcore/settings/plain_text.h"

#include <QStringList>
#include <QTextDocument>

namespace gui {

QString plainText(const QString& text) {
    QStringList lines = text.split(QLatin1Char('\n'));
    for (QString& line : lines) line = QString::fromStdString(rtcore::printable(line.toStdString()));
    return lines.join(QLatin1Char('\n'));
}

QString plainTip(const QString& text) {
    const QString plain = plainText(text);
    if (!Qt::mightBeRichText(plain)) return plain;
    return QStringLiteral("<qt>%1</qt>")
        .arg(plain.toHtmlEscaped().replace(QLatin1Char('\n'), QLatin1String("<br>")));
}

QString plainEntry(const QString& text) {
    return plainText(text).replace(QLatin1Char('&'), QLatin1String("&&"));
}

QString plainTitle(const QString& text) {
    return plainText(text).replace(QLatin1String("[*]"), QLatin1String("[*][*]"));
}

} // namespace gui

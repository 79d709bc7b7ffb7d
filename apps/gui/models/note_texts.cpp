#include "gui/models/note_texts.h"

#include "gui/models/plain_text.h"

#include <QDateTime>
#include <QLocale>

namespace gui {

QString noteRow(const rtcore::SceneNote& note, int number) {
    const QString author = QString::fromStdString(note.author);
    QString text = QString::fromStdString(note.text);
    text.replace(QLatin1Char('\n'), QLatin1Char(' ')).replace(QLatin1Char('\t'), QLatin1Char(' '));
    if (!author.isEmpty()) text = author + QStringLiteral(": ") + text;
    return QStringLiteral("%1  ").arg(number) + plainText(text);
}

QString noteHead(const rtcore::SceneNote& note) {
    QString head = plainText(QString::fromStdString(note.author));
    const QDateTime written = QDateTime::fromString(QString::fromStdString(note.written), Qt::ISODate);
    if (!written.isValid()) return head;
    if (!head.isEmpty()) head += QStringLiteral(", ");
    return head + QLocale().toString(written.toLocalTime(), QLocale::ShortFormat);
}

QString wholeNote(const rtcore::SceneNote& note) {
    const QString head = noteHead(note);
    QString text = QString::fromStdString(note.text);
    text.replace(QLatin1Char('\t'), QLatin1Char(' '));
    return (head.isEmpty() ? QString() : head + QLatin1Char('\n')) + plainText(text);
}

} // namespace gui

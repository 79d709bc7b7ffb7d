#include "gui/view/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace gui {

namespace {

void translate(const QLocale& locale, const QString& file, const QString& folder) {
    auto* translator = new QTranslator(QCoreApplication::instance());
    if (translator->load(locale, file, QStringLiteral("_"), folder)) {
        QCoreApplication::installTranslator(translator);
    } else {
        delete translator;
    }
}

} // namespace

void useLanguage(const QString& name) {
    const QLocale locale = name == QLatin1String("system") ? QLocale::system() : QLocale(name);
    QLocale::setDefault(locale);
    // Qt's own texts, such as those of the buttons; where its translations are not installed, they stay
    // English.
    translate(locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    translate(locale, QStringLiteral("gui"), QStringLiteral(":/translations"));
    translate(locale, QStringLiteral("tables"), QStringLiteral(":/translations"));
    translate(locale, QStringLiteral("sentences"), QStringLiteral(":/translations"));
}

} // namespace gui

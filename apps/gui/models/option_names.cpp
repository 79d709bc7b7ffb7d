#include "gui/models/option_names.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace gui {

namespace {

constexpr const char* kAbbreviations[] = {"ao", "fps", "id", "isa"};

QString translatedOption(const QString& text) {
    return QCoreApplication::translate("ProgramOptions", text.toUtf8().constData());
}

QString capitalised(QString text) {
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

// "ao-samples": "AO samples".
QString words(const std::string& name) {
    QStringList all = QString::fromStdString(name).split(QLatin1Char('-'));
    for (QString& word : all) {
        const bool letters = std::any_of(std::begin(kAbbreviations), std::end(kAbbreviations),
                                         [&](const char* each) { return word == QLatin1String(each); });
        if (letters) word = word.toUpper();
        if (word == QLatin1String("aovs")) word = QStringLiteral("AOVs");
    }
    return capitalised(all.join(QLatin1Char(' ')));
}

QString helpOf(const app::Option& option) { return translatedOption(QString::fromStdString(option.help)); }

} // namespace

QString optionLabel(const app::Option& option) { return translatedOption(words(option.name)); }

QString optionGroupTitle(const app::OptionGroup& group) {
    return translatedOption(QString::fromStdString(group.title));
}

// As rich text, so that a long one is broken into lines.
QString optionTip(const app::Option& option) {
    return QStringLiteral("<qt>%1.<br><code>--%2</code></qt>")
        .arg(capitalised(helpOf(option)).toHtmlEscaped(), QString::fromStdString(option.name));
}

QString optionTip(const app::ProgramSpec& spec, const char* name) {
    const app::Option* option = spec.find(name);
    return option == nullptr ? QString() : optionTip(*option);
}

QString optionDefault(const app::Option& option) {
    const QString help = helpOf(option);
    const qsizetype open = help.lastIndexOf(QLatin1Char('['));
    return open >= 0 && help.endsWith(QLatin1Char(']')) ? help.mid(open + 1).chopped(1) : QString();
}

QStringList optionTexts(const app::ProgramSpec& spec) {
    QStringList texts;
    for (const app::OptionGroup& group : spec.groups) {
        texts.append(QString::fromStdString(group.title));
        for (const app::Option& option : group.options) {
            if (option.answers) continue; // no field, no tooltip
            texts.append(words(option.name));
            texts.append(QString::fromStdString(option.help));
        }
    }
    texts.removeDuplicates();
    return texts;
}

} // namespace gui

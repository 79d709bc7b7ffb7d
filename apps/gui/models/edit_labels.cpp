#include "gui/models/edit_labels.h"

#include "gui/models/setting_labels.h"

#include "common/commands/command_table.h"
#include "common/commands/step_label.h"

#include <QCoreApplication>

#include <string>
#include <string_view>

namespace gui {

namespace {

QString englishOf(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

} // namespace

QString editLabel(const QString& step) {
    const app::StepLabel label = app::stepLabel(step.toStdString());
    if (label.isSetting) return settingLabel(label.of);
    if (label.text.empty()) return step; // of a newer server
    const QString text = QCoreApplication::translate("Edits", englishOf(label.text).toUtf8().constData());
    return label.of.empty() ? text : text + QLatin1Char(' ') + QString::fromStdString(label.of);
}

QStringList editTexts() {
    QStringList texts;
    for (const app::CommandSpec& command : app::commandTable())
        if (command.edits()) texts << englishOf(command.step);
    texts.removeDuplicates();
    return texts;
}

} // namespace gui

#include "gui/dialogs/option_fields.h"

#include "gui/dialogs/file_field.h"
#include "gui/models/option_names.h"
#include "gui/view/plain_widgets.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QProcess>

#include <utility>

namespace gui {

namespace {

QString fileFilter(const app::Option& option) {
    QStringList names;
    for (const std::string& extension : option.files)
        names.append(QStringLiteral("*.") + QString::fromStdString(extension));
    const QString all = OptionFields::tr("All files (*)");
    return names.isEmpty() ? all
                           : OptionFields::tr("Usual files (%1)").arg(names.join(QLatin1Char(' '))) +
                                 QStringLiteral(";;") + all;
}

// Such options may be given several times; blanks part their values.
bool repeats(const app::Option& option) { return option.argument == "NAME=VALUE"; }

} // namespace

OptionFields::OptionFields(const app::ProgramSpec& spec, const QStringList& without, QWidget* parent)
    : QWidget(parent) {
    auto* form = new QFormLayout(this);
    for (const app::OptionGroup& group : spec.groups) {
        bool titled = false;
        for (const app::Option& option : group.options) {
            if (option.answers || without.contains(QString::fromStdString(option.name))) continue;
            if (!std::exchange(titled, true)) form->addRow(headingLabel(optionGroupTitle(group)));
            addField(*form, option);
        }
    }
}

void OptionFields::addField(QFormLayout& form, const app::Option& option) {
    const bool isSwitch = option.value == app::ValueKind::None;
    const bool isFile = option.value == app::ValueKind::Text && option.argument == "FILE";
    QWidget* field = isSwitch                                 ? makeSwitch(option)
                     : option.value == app::ValueKind::Choice ? makeChoice(option)
                     : isFile                                 ? makeFile(option)
                                                              : makeLine(option);
    fields_.back().widget = field;
    field->setToolTip(optionTip(option));
    if (isSwitch) return form.addRow(QString(), field);
    field->setAccessibleName(optionLabel(option));
    form.addRow(optionLabel(option) + QLatin1Char(':'), field);
    form.labelForField(field)->setToolTip(optionTip(option));
}

QWidget* OptionFields::makeSwitch(const app::Option& option) {
    auto* box = new QCheckBox(optionLabel(option));
    fields_.append(
        {option.name, [box] { return box->isChecked() ? QStringList(QString()) : QStringList(); }, true});
    connect(box, &QCheckBox::toggled, this, &OptionFields::changed);
    return box;
}

QWidget* OptionFields::makeChoice(const app::Option& option) {
    auto* box = new QComboBox;
    const QString usual = optionDefault(option);
    box->addItem(usual.isEmpty() ? tr("default") : tr("default (%1)").arg(usual));
    for (const std::string& choice : option.choices) box->addItem(QString::fromStdString(choice));
    fields_.append({option.name, [box] {
                        return box->currentIndex() > 0 ? QStringList(box->currentText()) : QStringList();
                    }});
    connect(box, &QComboBox::currentIndexChanged, this, &OptionFields::changed);
    return box;
}

QWidget* OptionFields::makeFile(const app::Option& option) {
    auto* field = new FileField(FileField::Kind::Open, optionLabel(option), fileFilter(option));
    fields_.append({option.name, [field] {
                        return field->path().isEmpty() ? QStringList() : QStringList(field->path());
                    }});
    connect(field, &FileField::pathChanged, this, &OptionFields::changed);
    return field;
}

// Types and ranges are checked where the command line is: by the same table.
QWidget* OptionFields::makeLine(const app::Option& option) {
    auto* line = new QLineEdit;
    const QString usual = optionDefault(option);
    line->setPlaceholderText(usual.isEmpty() ? QString::fromStdString(option.argument) : usual);
    fields_.append({option.name, [line, several = repeats(option)] {
                        const QString text = line->text().trimmed();
                        if (text.isEmpty()) return QStringList();
                        return several ? QProcess::splitCommand(text) : QStringList(text);
                    }});
    connect(line, &QLineEdit::textChanged, this, &OptionFields::changed);
    return line;
}

void OptionFields::setOptionEnabled(std::string_view name, bool on) {
    for (const Field& field : fields_)
        if (field.name == name) field.widget->setEnabled(on);
    emit changed();
}

QStringList OptionFields::arguments() const {
    QStringList words;
    for (const Field& field : fields_) {
        if (!field.widget->isEnabledTo(this)) continue;
        for (const QString& value : field.values()) {
            const QString name = QStringLiteral("--") + QString::fromStdString(field.name);
            words.append(field.isSwitch ? name : name + QLatin1Char('=') + value);
        }
    }
    return words;
}

} // namespace gui

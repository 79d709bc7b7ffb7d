#include "gui/dialogs/fields.h"

#include "gui/view/plain_widgets.h"

#include "rtcore/settings/settings_table.h"

#include <QHBoxLayout>
#include <QSpinBox>

namespace gui {

QSpinBox* numberField(int minimum, int maximum, int value, const QString& accessibleName) {
    auto* box = new QSpinBox;
    box->setRange(minimum, maximum);
    box->setValue(value);
    box->setAccessibleName(accessibleName);
    return box;
}

int maxOf(std::string_view setting) { return static_cast<int>(rtcore::requireSetting(setting).maximum); }

QWidget* rowOfFields(std::initializer_list<QWidget*> fields) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    for (QWidget* field : fields) layout->addWidget(field, qobject_cast<QLabel*>(field) == nullptr ? 1 : 0);
    row->setFocusProxy(*fields.begin());
    row->setFocusPolicy(Qt::StrongFocus); // else the mnemonic of its label does nothing
    return row;
}

QWidget* sign(const QString& text) { return new PlainLabel(text); }

PlainLabel* wrappedLabel(const QString& text) {
    auto* label = new PlainLabel(text);
    label->setWordWrap(true);
    return label;
}

} // namespace gui

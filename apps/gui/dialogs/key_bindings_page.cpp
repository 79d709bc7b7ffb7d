#include "gui/dialogs/key_bindings_page.h"

#include "gui/dialogs/fields.h"
#include "gui/view/plain_widgets.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QSet>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>

namespace gui {

namespace {

enum Column { Keys, Action, Number };

QComboBox* actionBox(const QString& action) {
    auto* box = new QComboBox;
    for (const QString& each : bindableActions()) box->addItem(actionTitle(each), each);
    box->setCurrentIndex(box->findData(action));
    box->setAccessibleName(KeyBindingsPage::tr("Action"));
    return box;
}

QSpinBox* numberBox(int number) {
    constexpr int kMax = 99;
    auto* box = new QSpinBox;
    box->setRange(0, kMax);
    box->setSpecialValueText(QStringLiteral("–"));
    box->setValue(number);
    box->setAccessibleName(KeyBindingsPage::tr("Number of the light or environment map"));
    return box;
}

// Only lights and environment maps are counted, from 1.
void setNumbered(QSpinBox& box, bool numbered) {
    box.setMinimum(numbered ? 1 : 0);
    if (!numbered) box.setValue(0);
    box.setEnabled(numbered);
}

} // namespace

KeyBindingsPage::KeyBindingsPage(QWidget* parent)
    : QWidget(parent), table_(new QTableWidget(0, 3)), trouble_(wrappedLabel()) {
    table_->setHorizontalHeaderLabels({tr("Keys"), tr("Action"), tr("Number")});
    table_->horizontalHeader()->setSectionResizeMode(Action, QHeaderView::Stretch);
    table_->verticalHeader()->hide();
    table_->setAccessibleName(tr("Key bindings"));
    table_->setTabKeyNavigation(false);
    auto* hint = wrappedLabel(
        tr("A key is written by its name: W, 7, Space, Left, CapsLock. M+3 acts when 3 is pressed "
           "while M is down."));
    auto* add = new QPushButton(tr("&Add"));
    auto* remove = new QPushButton(tr("&Remove"));
    auto* defaults = new QPushButton(tr("&Defaults"));
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {add, remove, defaults}) buttons->addWidget(button);
    buttons->addStretch();
    auto* column = new QVBoxLayout(this);
    column->addWidget(hint);
    column->addWidget(table_);
    column->addWidget(trouble_);
    column->addLayout(buttons);
    connect(add, &QPushButton::clicked, this, [this] {
        addRow({QString(), bindableActions().first(), 0});
        table_->setCurrentCell(table_->rowCount() - 1, Keys);
        table_->editItem(table_->currentItem());
        check();
    });
    connect(remove, &QPushButton::clicked, this, &KeyBindingsPage::removeRow);
    connect(defaults, &QPushButton::clicked, this, [this] { setBindings(defaultBindings()); });
    connect(table_, &QTableWidget::cellChanged, this, &KeyBindingsPage::check);
}

void KeyBindingsPage::setBindings(const QList<Binding>& bindings) {
    filling_ = true;
    table_->setRowCount(0);
    for (const Binding& binding : bindings) addRow(binding);
    filling_ = false;
    check();
}

void KeyBindingsPage::addRow(const Binding& binding) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    table_->setItem(row, Keys, new QTableWidgetItem(binding.keys));
    auto* action = actionBox(binding.action);
    auto* number = numberBox(binding.number);
    setNumbered(*number, takesNumber(binding.action));
    table_->setCellWidget(row, Action, action);
    table_->setCellWidget(row, Number, number);
    connect(action, &QComboBox::currentIndexChanged, this, [this, action, number] {
        setNumbered(*number, takesNumber(action->currentData().toString()));
        check();
    });
    connect(number, &QSpinBox::valueChanged, this, &KeyBindingsPage::check);
}

void KeyBindingsPage::removeRow() {
    if (table_->currentRow() < 0) return;
    table_->removeRow(table_->currentRow());
    check();
}

QList<Binding> KeyBindingsPage::bindings() const {
    QList<Binding> all;
    for (int row = 0; row < table_->rowCount(); ++row) {
        const std::optional<QString> keys = normalKeys(table_->item(row, Keys)->text());
        const QString action =
            static_cast<QComboBox*>(table_->cellWidget(row, Action))->currentData().toString();
        const int number = static_cast<QSpinBox*>(table_->cellWidget(row, Number))->value();
        if (keys) all.append({*keys, action, takesNumber(action) ? number : 0});
    }
    return all;
}

bool KeyBindingsPage::valid() const { return trouble_->text().isEmpty(); }

void KeyBindingsPage::check() {
    if (filling_) return;
    QString trouble;
    QSet<QString> seen;
    for (int row = 0; row < table_->rowCount(); ++row) {
        const QString text = table_->item(row, Keys)->text();
        const std::optional<QString> keys = normalKeys(text);
        if (!keys) trouble = tr("“%1” is no key.").arg(text);
        if (keys && seen.contains(*keys)) trouble = tr("%1 stands twice.").arg(*keys);
        if (keys) seen.insert(*keys);
    }
    trouble_->setText(trouble);
    emit changed();
}

} // namespace gui

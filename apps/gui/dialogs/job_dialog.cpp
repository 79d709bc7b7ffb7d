#include "gui/dialogs/job_dialog.h"

#include "gui/dialogs/fields.h"
#include "gui/dialogs/option_fields.h"
#include "gui/session/server_sentence.h"
#include "gui/view/plain_widgets.h"

#include "common/cli/command_line.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace gui {

namespace {

// By the program's own table: unknown names, types, ranges.
QString complaint(const app::ProgramSpec& spec, const QStringList& arguments) {
    std::vector<std::string> words;
    for (const QString& argument : arguments) words.push_back(argument.toStdString());
    try {
        app::parseCommandLine(app::withStandardOptions(spec), words);
    } catch (const app::UsageError& error) {
        return translated(error);
    }
    return {};
}

// In one column with those of a form.
void alignLabel(QLabel& label, const QFormLayout& with) {
    int width = 0;
    for (int row = 0; row < with.rowCount(); ++row) {
        const QLayoutItem* item = with.itemAt(row, QFormLayout::LabelRole);
        if (item != nullptr && with.isRowVisible(row))
            width = std::max(width, item->widget()->sizeHint().width());
    }
    label.setMinimumWidth(width);
}

} // namespace

JobDialog::JobDialog(const app::ProgramSpec& spec, const QStringList& own, QWidget* parent)
    : QDialog(parent), spec_(spec), form_(new QFormLayout), further_(new OptionFields(spec, own)),
      command_(new QLineEdit), trouble_(wrappedLabel()) {
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form_);
}

QWidget* JobDialog::makeCommand() {
    command_->setReadOnly(true);
    command_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    command_->setAccessibleName(tr("Command"));
    auto* copy = new QPushButton(tr("Cop&y"));
    copy->setAutoDefault(false);
    copy->setToolTip(tr("Copy the command, for a terminal or a script"));
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(command_->text()); });
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(command_, 1);
    layout->addWidget(copy);
    row->setFocusProxy(command_);
    row->setFocusPolicy(Qt::StrongFocus);
    return row;
}

QWidget* JobDialog::makeFurther() {
    auto* area = new QScrollArea;
    area->setWidget(further_);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    constexpr int kHigh = 260;
    area->setMinimumHeight(kHigh);
    area->hide();
    return area;
}

void JobDialog::addCommonParts(const QString& accept) {
    auto* column = static_cast<QVBoxLayout*>(layout());
    auto* more = new QToolButton;
    more->setText(tr("&More options"));
    more->setCheckable(true);
    more->setAutoRaise(true);
    more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    more->setArrowType(Qt::RightArrow);
    more->setFocusPolicy(Qt::StrongFocus);
    QWidget* area = makeFurther();
    connect(more, &QToolButton::toggled, this, [this, more, area](bool on) {
        more->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
        area->setVisible(on);
        if (!on)
            QMetaObject::invokeMethod(
                this, [this] { adjustSize(); }, Qt::QueuedConnection);
    });
    auto* last = new QFormLayout;
    QWidget* command = makeCommand();
    last->addRow(tr("Comman&d:"), command);
    commandLabel_ = qobject_cast<QLabel*>(last->labelForField(command));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    accept_ = buttons->addButton(accept, QDialogButtonBox::AcceptRole);
    column->addWidget(more);
    column->addWidget(area, 1);
    column->addLayout(last);
    column->addWidget(trouble_);
    column->addWidget(buttons);
    accept_->setDefault(true); // once it belongs to the dialog
    connect(further_, &OptionFields::changed, this, &JobDialog::check);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        finish();
        QDialog::accept();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    constexpr int kWide = 560;
    setMinimumWidth(kWide);
    check();
}

QStringList JobDialog::arguments() const { return ownArguments() + further_->arguments(); }

void JobDialog::check() {
    if (accept_ == nullptr) return;
    alignLabel(*commandLabel_, form());
    const QStringList words = arguments();
    command_->setText(commandText(QString::fromStdString(spec_.name), words));
    command_->setCursorPosition(0);
    QString trouble = missing();
    if (trouble.isEmpty()) trouble = complaint(spec_, words);
    trouble_->setText(trouble);
    accept_->setEnabled(trouble.isEmpty());
}

} // namespace gui

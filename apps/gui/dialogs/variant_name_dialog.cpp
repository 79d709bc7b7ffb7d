#include "gui/dialogs/variant_name_dialog.h"

#include "gui/models/plain_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

namespace gui {

VariantNameDialog::VariantNameDialog(const QString& title, const QString& name, QWidget* parent)
    : QDialog(parent), name_(new QLineEdit(name)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(plainTitle(title));
    name_->selectAll();
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Name:"), name_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    form->addRow(buttons);
    const auto enable = [this, buttons] {
        buttons->button(QDialogButtonBox::Ok)->setEnabled(!name_->text().trimmed().isEmpty());
    };
    connect(name_, &QLineEdit::textChanged, this, enable);
    enable();
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::accepted, this, [this] { emit wanted(name_->text().trimmed()); });
}

} // namespace gui

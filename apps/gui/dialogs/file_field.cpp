#include "gui/dialogs/file_field.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

namespace gui {

FileField::FileField(Kind kind, const QString& title, const QString& filter, QWidget* parent)
    : QWidget(parent), kind_(kind), title_(title), filter_(filter), edit_(new QLineEdit) {
    constexpr int kWide = 260;
    edit_->setMinimumWidth(kWide);
    edit_->setAccessibleName(title);
    auto* button = new QPushButton(tr("Browse…"));
    button->setAccessibleName(tr("Browse: %1").arg(title));
    button->setAutoDefault(false); // Enter is for the dialog
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(edit_, 1);
    row->addWidget(button);
    setFocusProxy(edit_);
    setFocusPolicy(Qt::StrongFocus); // else the mnemonic of its label does nothing
    connect(button, &QPushButton::clicked, this, &FileField::browse);
    connect(edit_, &QLineEdit::textChanged, this, &FileField::pathChanged);
}

QString FileField::path() const {
    const QString text = edit_->text().trimmed();
    return text.isEmpty() ? QString() : QFileInfo(text).absoluteFilePath();
}

void FileField::setPath(const QString& path) { edit_->setText(path); }

void FileField::browse() {
    auto* dialog = new QFileDialog(this, title_, path(), filter_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(kind_ == Kind::Save ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(kind_ == Kind::Open   ? QFileDialog::ExistingFile
                        : kind_ == Kind::Save ? QFileDialog::AnyFile
                                              : QFileDialog::Directory);
    if (kind_ != Kind::Folder && QFileInfo(path()).isFile()) dialog->selectFile(path());
    connect(dialog, &QFileDialog::fileSelected, this, &FileField::setPath);
    dialog->open();
}

} // namespace gui

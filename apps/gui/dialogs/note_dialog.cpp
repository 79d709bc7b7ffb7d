#include "gui/dialogs/note_dialog.h"

#include "gui/dialogs/fields.h"
#include "gui/view/plain_widgets.h"

#include "rtcore/scene/scene_note.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QShortcut>

namespace gui {

NoteDialog::NoteDialog(const QString& text, const QString& author, QWidget* parent)
    : QDialog(parent), text_(new QPlainTextEdit), author_(new QLineEdit), trouble_(wrappedLabel()) {
    constexpr int kLetters = 44, kLines = 6;
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(text.isEmpty() ? tr("Add a note") : tr("Edit the note"));
    text_->setAccessibleName(tr("Text"));
    text_->setTabChangesFocus(true);
    text_->setMinimumSize(kLetters * text_->fontMetrics().averageCharWidth(),
                          kLines * text_->fontMetrics().lineSpacing());
    text_->setPlainText(text);
    author_->setAccessibleName(tr("Author"));
    author_->setPlaceholderText(tr("None"));
    author_->setToolTip(tr("Kept with the note, and as a preference; may be empty"));
    author_->setMaxLength(static_cast<int>(rtcore::kMaxNoteAuthor));
    author_->setText(author);
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Text:"), text_);
    form->addRow(tr("&Author:"), author_);
    form->addRow(trouble_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    keep_ = buttons->addButton(tr("&Keep"), QDialogButtonBox::AcceptRole);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &NoteDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(text_, &QPlainTextEdit::textChanged, this, &NoteDialog::check);
    auto* enter = new QShortcut(Qt::CTRL | Qt::Key_Return, this);
    connect(enter, &QShortcut::activated, keep_, &QPushButton::click);
    check();
}

void NoteDialog::check() {
    const rtcore::SceneNote note{
        .point = {}, .text = rtcore::noteText(text_->toPlainText().toStdString()), .view = {}};
    const bool tooLong = !note.text.empty() && problemOf(note).has_value();
    keep_->setEnabled(!note.text.empty() && !tooLong);
    trouble_->setText(tooLong ? tr("A note has at most %1 characters.").arg(rtcore::kMaxNoteText)
                              : QString());
    trouble_->setVisible(tooLong);
}

void NoteDialog::finish() {
    emit written(QString::fromStdString(rtcore::noteText(text_->toPlainText().toStdString())),
                 QString::fromStdString(rtcore::noteAuthor(author_->text().toStdString())));
    accept();
}

} // namespace gui

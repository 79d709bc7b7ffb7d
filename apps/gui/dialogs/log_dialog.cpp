#include "gui/dialogs/log_dialog.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>

namespace gui {

LogDialog::LogDialog(std::function<QString()> read, QWidget* parent)
    : QDialog(parent), read_(std::move(read)), text_(new QPlainTextEdit) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Server log"));
    text_->setReadOnly(true);
    text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    text_->setPlaceholderText(tr("Nothing yet."));
    text_->setAccessibleName(tr("Log"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* copy = buttons->addButton(tr("Co&py all"), QDialogButtonBox::ActionRole);
    auto* column = new QVBoxLayout(this);
    column->addWidget(text_);
    column->addWidget(buttons);
    constexpr QSize kSize(720, 360);
    resize(kSize);
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(text_->toPlainText()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(&timer_, &QTimer::timeout, this, &LogDialog::refresh);
    constexpr int kSecond = 1000;
    timer_.start(kSecond);
    refresh();
}

void LogDialog::refresh() {
    const QString now = read_();
    if (now == text_->toPlainText()) return;
    text_->setPlainText(now);
    text_->verticalScrollBar()->setValue(text_->verticalScrollBar()->maximum());
}

} // namespace gui

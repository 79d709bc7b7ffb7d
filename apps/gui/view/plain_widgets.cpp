#include "gui/view/plain_widgets.h"

#include "gui/models/plain_text.h"

#include <QCoreApplication>
#include <QEvent>
#include <QPushButton>

namespace gui {

PlainLabel::PlainLabel(const QString& text, QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setText(text);
}

void PlainLabel::setText(const QString& text) { QLabel::setText(plainText(text)); }

PlainLabel* headingLabel(const QString& text) {
    auto* label = new PlainLabel(text);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    return label;
}

QLabel* markupLabel(const QString& markup) {
    auto* label = new QLabel;
    label->setTextFormat(Qt::RichText);
    label->setText(markup);
    return label;
}

QMessageBox* plainBox(QMessageBox::Icon icon, const QString& title, const QString& text, QWidget* parent) {
    auto* box = new QMessageBox(icon, title, QString(), QMessageBox::NoButton, parent);
    box->setTextFormat(Qt::PlainText);
    box->setText(plainText(text));
    box->setAttribute(Qt::WA_DeleteOnClose);
    return box;
}

QMessageBox* plainQuestion(const QString& title, const QString& text, const QString& yes,
                           const std::function<void()>& act, QWidget* parent) {
    QMessageBox* box = plainBox(QMessageBox::Question, title, text, parent);
    QObject::connect(box->addButton(yes, QMessageBox::AcceptRole), &QPushButton::clicked, box, act);
    box->setDefaultButton(box->addButton(QMessageBox::Cancel));
    return box;
}

PlainLabels::PlainLabels(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

// Before it is laid out for the first time, which is when pictures would be read.
bool PlainLabels::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Polish) return false;
    auto* label = qobject_cast<QLabel*>(watched);
    const bool tip = label != nullptr && label->inherits("QTipLabel");
    if (label != nullptr && !tip && label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
    return false;
}

} // namespace gui

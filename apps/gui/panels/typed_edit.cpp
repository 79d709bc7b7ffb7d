#include "gui/panels/typed_edit.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSignalBlocker>

#include <type_traits>
#include <utility>

namespace gui {

namespace {

bool isEditing(const QKeyEvent& event) {
    const bool letter = !event.text().isEmpty() && event.text().at(0).isPrint();
    const bool shortcut = (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) != 0;
    return (letter && !shortcut) || event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Delete ||
           event.matches(QKeySequence::Paste);
}

bool isMovement(const QKeyEvent& event) {
    return event.key() == Qt::Key_Left || event.key() == Qt::Key_Right || event.key() == Qt::Key_Home ||
           event.key() == Qt::Key_End;
}

} // namespace

std::optional<QTime> timeOf(const QString& text) {
    static const QRegularExpression form(
        QStringLiteral("^\\s*(\\d{1,2})(?:\\s*[:.]\\s*(\\d{2})|(\\d{2}))?\\s*$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch()) return std::nullopt;
    const QTime time(match.captured(1).toInt(), (match.captured(2) + match.captured(3)).toInt());
    return time.isValid() ? std::optional(time) : std::nullopt;
}

std::optional<QDate> dateOf(const QString& text) {
    static const QRegularExpression parted(
        QStringLiteral("^\\s*(\\d{4})\\s*[-./ ]\\s*(\\d{1,2})\\s*[-./ ]\\s*(\\d{1,2})\\s*$")),
        digits(QStringLiteral("^\\s*(\\d{4})(\\d{2})(\\d{2})\\s*$"));
    QRegularExpressionMatch match = parted.match(text);
    if (!match.hasMatch()) match = digits.match(text);
    const QDate date(match.captured(1).toInt(), match.captured(2).toInt(), match.captured(3).toInt());
    return match.hasMatch() && date.isValid() ? std::optional(date) : std::nullopt;
}

template <typename Edit>
std::optional<QDateTime> TypedEdit<Edit>::read(const QString& text) const {
    QDateTime value = this->dateTime();
    if constexpr (std::is_same_v<Edit, QTimeEdit>) {
        const std::optional<QTime> time = timeOf(text);
        if (!time) return std::nullopt;
        value.setTime(*time);
    } else {
        const std::optional<QDate> date = dateOf(text);
        if (!date || *date < this->minimumDate() || *date > this->maximumDate()) return std::nullopt;
        value.setDate(*date);
    }
    return value;
}

template <typename Edit>
QValidator::State TypedEdit<Edit>::validate(QString& text, int& position) const {
    return typing_ ? QValidator::Acceptable : Edit::validate(text, position);
}

template <typename Edit>
QDateTime TypedEdit<Edit>::dateTimeFromText(const QString& text) const {
    return typing_ ? read(text).value_or(this->dateTime()) : Edit::dateTimeFromText(text);
}

template <typename Edit>
bool TypedEdit<Edit>::begins(const QKeyEvent& event) const {
    const QLineEdit* line = this->lineEdit();
    return isEditing(event) && line->hasSelectedText() && line->selectedText() == line->text();
}

// Esc gives up what is typed, before it leads out of the panel.
template <typename Edit>
bool TypedEdit<Edit>::event(QEvent* event) {
    const bool asks = event->type() == QEvent::ShortcutOverride;
    if (!typing_ || !asks || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
        return Edit::event(event);
    event->accept();
    return true;
}

// While something is typed, Qt's parts of the text would move the cursor and refuse letters.
template <typename Edit>
void TypedEdit<Edit>::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && std::exchange(typing_, false))
        return this->setDateTime(this->dateTime());
    typing_ = typing_ || begins(*event);
    if (typing_ && (isEditing(*event) || isMovement(*event) || event->matches(QKeySequence::SelectAll))) {
        const QSignalBlocker quiet(this->lineEdit());
        this->lineEdit()->event(event);
        return;
    }
    const bool modifier = event->key() == Qt::Key_Shift || event->key() == Qt::Key_Control;
    if (!modifier) take(); // Return, or a step from what was typed
    Edit::keyPressEvent(event);
}

template <typename Edit>
void TypedEdit<Edit>::focusOutEvent(QFocusEvent* event) {
    take();
    Edit::focusOutEvent(event);
}

// From what was typed to the next field, not to the next part.
template <typename Edit>
bool TypedEdit<Edit>::focusNextPrevChild(bool next) {
    if (!typing_) return Edit::focusNextPrevChild(next);
    take();
    return QWidget::focusNextPrevChild(next);
}

template <typename Edit>
void TypedEdit<Edit>::take() {
    if (!typing_) return;
    const QDateTime value = read(this->lineEdit()->text()).value_or(this->dateTime());
    typing_ = false;
    this->setDateTime(value); // shows it, too
}

template class TypedEdit<QTimeEdit>;
template class TypedEdit<QDateEdit>;

} // namespace gui

/// Fields for a time or a date into which one may also type all of it: Qt's own take text by its parts only,
/// and keep the old value where the whole was selected and written anew.
#pragma once

#include <QDateEdit>
#include <QTimeEdit>

#include <optional>

namespace gui {

/// "17:00", "7:05", "17.30", "1700", "705" or "17".
std::optional<QTime> timeOf(const QString& text);
/// Year, month and day: "2026-06-21", "2026/6/21", "20260621".
std::optional<QDate> dateOf(const QString& text);

/// Text typed over the whole old one, selected or deleted, is taken at Return, Tab or a click elsewhere;
/// where it is no value, and at Esc, the old value comes back.
template <typename Edit>
class TypedEdit : public Edit {
  public:
    using Edit::Edit;

    bool event(QEvent* event) override;

  protected:
    QValidator::State validate(QString& text, int& position) const override;
    QDateTime dateTimeFromText(const QString& text) const override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool focusNextPrevChild(bool next) override;

  private:
    bool begins(const QKeyEvent& event) const;
    std::optional<QDateTime> read(const QString& text) const;
    void take();

    bool typing_ = false; ///< the text is the user's alone
};

using TimeBox = TypedEdit<QTimeEdit>;
using DateBox = TypedEdit<QDateEdit>;

extern template class TypedEdit<QTimeEdit>;
extern template class TypedEdit<QDateEdit>;

} // namespace gui

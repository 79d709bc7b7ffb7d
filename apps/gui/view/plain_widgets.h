/// Widgets that show text as it is. QLabel and QMessageBox take what looks like markup for markup, read the
/// files that it names, and may not come back: all of the window are made here (scripts/check_plain_text.py).
#pragma once

#include <QLabel>
#include <QMessageBox>

#include <functional>

namespace gui {

/// A label whose text is plainText(), of whomever it is.
class PlainLabel : public QLabel {
  public:
    explicit PlainLabel(const QString& text = {}, QWidget* parent = nullptr);
    void setText(const QString& text);
};

/// The same in bold letters.
PlainLabel* headingLabel(const QString& text);

/// Markup of our own; nothing of others may be in it.
QLabel* markupLabel(const QString& markup);

/// A message whose text is plainText(). It deletes itself when it is closed; buttons are added by the caller.
QMessageBox* plainBox(QMessageBox::Icon icon, const QString& title, const QString& text, QWidget* parent);

/// A question as a plainBox() that can only be answered by the button `yes`, which does it, or by Cancel,
/// which Enter presses. Further buttons are added, and it is opened, by the caller.
QMessageBox* plainQuestion(const QString& title, const QString& text, const QString& yes,
                           const std::function<void()>& act, QWidget* parent);

/// Makes the labels plain, too, that Qt makes in dialogs and forms of its own, such as the question whether a
/// file may be replaced. An event filter of the application; tool tips are not its matter (plainTip()).
class PlainLabels : public QObject {
    Q_OBJECT

  public:
    /// Works until it is deleted.
    explicit PlainLabels(QObject* parent = nullptr);
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace gui

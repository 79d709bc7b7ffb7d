/// A button that shows a colour, and asks for another one by a dialog.
#pragma once

#include <QPushButton>

#include <array>

namespace gui {

class ColourButton : public QPushButton {
    Q_OBJECT

  public:
    /// `name`: of the button for screen readers, and the title of its dialog.
    explicit ColourButton(const QString& name, QWidget* parent = nullptr);

    /// Linear; shown as a display does. Emits nothing.
    void show(const std::array<float, 3>& linear);
    using QWidget::show;

  signals:
    /// While one is chosen in the dialog, and, where that is cancelled, the one before it.
    void edited(const std::array<float, 3>& linear);

  private:
    void ask();

    std::array<float, 3> linear_{};
};

} // namespace gui

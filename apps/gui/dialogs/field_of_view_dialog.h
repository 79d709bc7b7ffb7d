/// How much the camera sees: an angle, or the lens of a camera for film that has it.
#pragma once

#include <QDialog>

class QDoubleSpinBox;

namespace gui {

/// "62.4° (30 mm)".
QString fieldOfViewText(double degrees);

class FieldOfViewDialog : public QDialog {
    Q_OBJECT

  public:
    /// Degrees from the left to the right edge; 0 for a view without perspective.
    explicit FieldOfViewDialog(double degrees, QWidget* parent = nullptr);

    /// Shows the camera's current angle, in degrees. Emits nothing.
    void follow(double degrees);

  signals:
    void wanted(double degrees); ///< while a field is changed

  private:
    QDoubleSpinBox* angle_;
    QDoubleSpinBox* lens_;
};

} // namespace gui

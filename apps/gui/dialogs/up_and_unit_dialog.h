/// Which axis of the model is up, and how long a unit of it is.
#pragma once

#include <QDialog>
#include <QString>

class QComboBox;

namespace gui {

class ValueBox;

class UpAndUnitDialog : public QDialog {
    Q_OBJECT

  public:
    /// `up`: "+y".
    UpAndUnitDialog(const QString& up, float metresPerUnit, QWidget* parent = nullptr);

    /// Shows the server's current up axis and unit. Emits nothing.
    void follow(const QString& up, float metresPerUnit);

  signals:
    void upWanted(const QString& axis); ///< "+z"
    void unitWanted(float metres);
    void guessWanted(); ///< of both

  private:
    QComboBox* up_;
    QComboBox* unit_;
    ValueBox* metres_;
};

} // namespace gui

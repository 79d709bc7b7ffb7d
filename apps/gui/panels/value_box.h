/// A field for a number of any size: steps grow with the value, and every digit that the value needs is
/// shown.
#pragma once

#include <QDoubleSpinBox>

namespace gui {

class ValueBox : public QDoubleSpinBox {
    Q_OBJECT

  public:
    ValueBox(double minimum, double maximum, QWidget* parent = nullptr);

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
    /// A tenth of the value's power of ten.
    void stepBy(int steps) override;
    QSize sizeHint() const override;
    /// Sets it to the value with the digits that one reads; leaves it where it is that value but for the
    /// rounding of floats.
    void showRounded(double value);
    /// From where its digits and its steps count: 0 at first. Of coordinates on a national grid, the scene's.
    void setZero(double zero) { zero_ = zero; }
    /// It takes whole numbers alone; steps are of 1.
    void setWhole() { whole_ = true; }

  private:
    QString bare(const QString& text) const; ///< without the unit
    /// Whether it is the word for the minimum (specialValueText()), in any case.
    bool saysMinimum(const QString& text) const;

    double zero_ = 0;
    bool whole_ = false;
};

} // namespace gui

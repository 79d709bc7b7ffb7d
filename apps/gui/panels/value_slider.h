/// A slider for a number: by even steps, or by even factors where the range is of many orders.
#pragma once

#include <QSlider>

namespace gui {

class ValueSlider : public QSlider {
    Q_OBJECT

  public:
    /// From `min` to `max`; `whole`: over whole numbers only.
    ValueSlider(double min, double max, bool whole, QWidget* parent = nullptr);

    /// Moves it there, to an end where the value is beyond. Emits nothing.
    void showValue(double value);

  signals:
    /// By the user, to this value.
    void moved(double value);

  private:
    double valueAt(int position) const;
    int positionOf(double value) const;

    double min_, max_;
    bool whole_, byFactors_;
};

} // namespace gui

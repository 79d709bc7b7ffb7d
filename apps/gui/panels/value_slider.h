/// A slider for a number: by even steps, or by even factors where the range is of many orders.
#pragma once

#include <QSlider>

namespace gui {

class ValueSlider : public QSlider {
    Q_OBJECT

  public:
    /// From `least` to `most`; `whole`: over whole numbers only.
    ValueSlider(double least, double most, bool whole, QWidget* parent = nullptr);

    /// Moves it there, to an end where the value is beyond. Emits nothing.
    void showValue(double value);

  signals:
    /// By the user, to this value.
    void moved(double value);

  private:
    double valueAt(int position) const;
    int positionOf(double value) const;

    double least_, most_;
    bool whole_, byFactors_;
};

} // namespace gui

/// The server's statistics, as they change.
#pragma once

#include "gui/session/session.h"

#include <QDialog>
#include <QElapsedTimer>
#include <QTimer>

#include <functional>

class QFormLayout;

namespace gui {

class PlainLabel;

class StatisticsDialog : public QDialog {
    Q_OBJECT

  public:
    /// `session` must outlive it. `delay`: seconds from a frame's publication until it is on the screen;
    /// `origin`: how the image that is seen was made.
    StatisticsDialog(Session& session, std::function<double()> delay, std::function<QString()> origin,
                     QWidget* parent = nullptr);

  private:
    void addRow(QFormLayout& form, const QString& name, PlainLabel*& value);
    void refresh();
    QString stateName() const;

    Session& session_;
    std::function<double()> delay_;
    std::function<QString()> origin_;
    PlainLabel *server_, *state_, *frames_, *frameTime_, *shown_, *delayed_, *image_, *rays_, *resolution_,
        *indirect_, *polygons_, *mode_, *eye_, *exposure_;
    QTimer timer_;
    QElapsedTimer clock_;
    int received_ = 0; ///< frames since the clock's start
};

} // namespace gui

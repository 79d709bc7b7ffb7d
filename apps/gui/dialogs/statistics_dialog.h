/// The server's figures, as they change.
#pragma once

#include "gui/session/session.h"

#include <QDialog>
#include <QElapsedTimer>
#include <QTimer>

class QFormLayout;
class QLabel;

namespace gui {

class StatisticsDialog : public QDialog {
    Q_OBJECT

  public:
    /// `session` must outlive it.
    explicit StatisticsDialog(Session& session, QWidget* parent = nullptr);

  private:
    void addRow(QFormLayout& form, const QString& name, QLabel*& value);
    void refresh();
    QString stateName() const;

    Session& session_;
    QLabel *server_, *state_, *frames_, *frameTime_, *shown_, *rays_, *resolution_, *polygons_, *mode_, *eye_,
        *exposure_;
    QTimer timer_;
    QElapsedTimer clock_;
    int received_ = 0; ///< frames since the clock's start
};

} // namespace gui

/// Starts and stops the recording of every frame's camera. Stays open while the user walks.
#pragma once

#include "gui/session/session.h"

#include <QDialog>
#include <QElapsedTimer>

class QLabel;
class QPushButton;

namespace gui {

class FileField;

class RecordingDialog : public QDialog {
    Q_OBJECT

  public:
    /// `session` must outlive it. `folder` is where a name is proposed.
    RecordingDialog(Session& session, const QString& folder, QWidget* parent = nullptr);

  signals:
    /// The user wants the list that was recorded last as a film.
    void filmWanted(const QString& list);

  private:
    void toggle();
    void play();
    void tell(const Answer& answer);
    void refresh();
    void propose();

    Session& session_;
    QString folder_;
    FileField* path_;
    QPushButton *button_, *play_, *film_;
    QLabel* state_;
    QElapsedTimer clock_;
    bool recording_ = false;
    QString started_, recorded_; ///< lists of this dialog: being written, complete
};

} // namespace gui

/// Starts and stops the recording of the camera, and plays lists. Can be closed meanwhile: the server keeps
/// the state of the recording.
#pragma once

#include "gui/session/session.h"

#include <QDialog>
#include <QElapsedTimer>
#include <QTimer>

class QPushButton;

namespace gui {

class FileField;
class PlainLabel;

class RecordingDialog : public QDialog {
    Q_OBJECT

  public:
    /// `session` must outlive it. `folder` is where a name is proposed.
    RecordingDialog(Session& session, const QString& folder, QWidget* parent = nullptr);

  signals:
    /// The user wants this list as a film.
    void filmWanted(const QString& list);

  private:
    void toggle();
    void play();
    void tell(const Answer& answer);
    void onStatus();
    void ask();
    void take(const QString& text);
    void refresh();
    QString freeList(const QString& like) const;

    Session& session_;
    FileField* path_;
    QPushButton *button_, *play_, *film_;
    PlainLabel* state_;
    QTimer timer_; ///< while a recording runs: its time is shown
    QElapsedTimer clock_;
    bool live_ = false, recording_ = false;
    double before_ = 0; ///< seconds that were recorded when clock_ began
};

} // namespace gui

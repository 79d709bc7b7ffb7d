/// The dialog for a new server: its scene, camera and options.
#pragma once

#include "gui/models/preferences.h"
#include "gui/processes/server_process.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace gui {

class FileField;
class PlainLabel;

class StartServerDialog : public QDialog {
    Q_OBJECT

  public:
    /// `instance` is proposed, with a number if it is taken. `window`: pixels of the image when it is to
    /// fill the window.
    StartServerDialog(Preferences& preferences, const QString& instance, const QSize& window,
                      QWidget* parent = nullptr);

    /// As the fields are now.
    ServerRequest request() const;

  signals:
    void wanted(const gui::ServerRequest& request);

  private:
    void build(const QString& name);
    void check();
    void finish();
    QSize resolution() const;
    QStringList options() const;

    Preferences& preferences_;
    QSize window_;
    FileField *scene_, *camera_, *settings_;
    QLineEdit *instance_, *further_;
    QComboBox* size_;
    QSpinBox *width_, *height_, *threads_;
    QDoubleSpinBox* limit_;
    QCheckBox *smooth_, *keep_;
    PlainLabel* trouble_;
    QPushButton* start_;
};

} // namespace gui

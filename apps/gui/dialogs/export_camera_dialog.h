/// Where the camera is written to, and what else the file says.
#pragma once

#include "gui/models/preferences.h"

#include <QDialog>
#include <QSize>

class QSpinBox;

namespace gui {

class FileField;

struct CameraExport {
    QString path;
    QSize size; ///< of the image; empty: as it is now, and with the rest of it
    int antialiasing = 1;
    int bloom = 0;
};

class ExportCameraDialog : public QDialog {
    Q_OBJECT

  public:
    /// `path` and `size` are proposed.
    ExportCameraDialog(const QString& path, const QSize& size, Preferences& preferences,
                       QWidget* parent = nullptr);

  signals:
    void wanted(const gui::CameraExport& camera);

  private:
    void finish();

    Preferences& preferences_;
    FileField* path_;
    QSpinBox *width_, *height_, *antialiasing_, *bloom_;
};

} // namespace gui

/// Cameras and images as files: export, import, recording, screenshot, clipboard.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>
#include <QPointer>
#include <QString>

namespace gui {

struct CameraExport;
class RecordingDialog;

class CameraOperations : public QObject {
    Q_OBJECT

  public:
    CameraOperations(const GuiContext& context, QObject* parent);

  signals:
    /// This recorded list is to become a film.
    void filmWanted(const QString& list);

  private:
    void exportByDialog();
    void exportAtOnce(bool highQuality); ///< the keys E and H
    void exportCamera(const CameraExport& camera);
    void importCamera();
    void record();
    void takeScreenshot();
    void copyImage();
    void copy();
    void paste();
    QString cameraFolder() const;

    GuiContext context_;
    QPointer<RecordingDialog> recording_;
};

} // namespace gui

/// Which drawing to scale is made, and where it goes.
#pragma once

#include "gui/models/preferences.h"

#include <QDialog>
#include <QString>

#include <vector>

class QComboBox;
class QDoubleSpinBox;

namespace gui {

class FileField;

/// As the command `plan` takes it, and the Renderer.
struct PlanWish {
    QString path, side;
    double scale = 100;
    QString paper;
    int storey = 0;
    double height = 1.2;
    double dpi = 300;
    QString image = QStringLiteral("lines"); ///< of a PNG or TIFF, as Renderer's --plan-image
    /// The Renderer is needed.
    bool hasLight() const { return image != QLatin1String("lines"); }
};

class PlanDialog : public QDialog {
    Q_OBJECT

  public:
    /// `path` is proposed.
    PlanDialog(const QString& path, Preferences& preferences, QWidget* parent = nullptr);

    /// The floors of the storeys, metres, the lowest first: as soon as they are known.
    void setStoreys(const std::vector<double>& floors);

  signals:
    void wanted(const gui::PlanWish& plan);

  private:
    void finish();
    bool isImage() const;
    /// Storeys are of plans from above alone, resolutions of images.
    void enableFields();

    Preferences& preferences_;
    FileField* path_;
    QComboBox *side_, *storey_, *paper_, *image_;
    QDoubleSpinBox *height_, *scale_, *dpi_;
};

} // namespace gui

/// A model's kd-tree, built into a .bsp file.
#pragma once

#include "gui/dialogs/job_dialog.h"

class QCheckBox;
class QSpinBox;

namespace gui {

class FileField;

class BuildDialog : public JobDialog {
    Q_OBJECT

  public:
    /// `model` is proposed; may be empty.
    explicit BuildDialog(const QString& model, QWidget* parent = nullptr);

  signals:
    void wanted(const gui::JobRequest& request);

  protected:
    QStringList ownArguments() const override;
    QString missing() const override;
    void finish() override;

  private:
    void proposeOutput();

    FileField *input_, *output_;
    QCheckBox *fast_, *report_;
    QSpinBox *quality_, *histogram_;
    QString proposed_;
};

} // namespace gui

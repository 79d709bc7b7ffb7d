/// The name of a variant, to be kept or to be renamed.
#pragma once

#include <QDialog>
#include <QString>

class QLineEdit;

namespace gui {

class VariantNameDialog : public QDialog {
    Q_OBJECT

  public:
    /// `title` is text of our own, `name` what the field holds at first.
    VariantNameDialog(const QString& title, const QString& name, QWidget* parent = nullptr);

    QLineEdit& name() { return *name_; }

  signals:
    void wanted(const QString& name); ///< not empty; then it closes

  private:
    QLineEdit* name_;
};

} // namespace gui

/// The base of the dialogs for jobs: more options from the program's table, the command that will run, its
/// errors, and the buttons.
#pragma once

#include "gui/processes/job.h"

#include "common/cli/options.h"

#include <QDialog>

class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace gui {

class OptionFields;
class PlainLabel;

class JobDialog : public QDialog {
    Q_OBJECT

  public:
    /// As the fields are now. Paths of files that are only made when the job is wanted have their place
    /// already.
    QStringList arguments() const;

  protected:
    /// `own`: names of the options that have fields of their own, or none at all.
    JobDialog(const app::ProgramSpec& spec, const QStringList& own, QWidget* parent);

    /// Where the fields of the dialog go.
    QFormLayout& form() { return *form_; }
    /// Below them, once they are there.
    void addCommonParts(const QString& accept);
    /// After every change of a field.
    void check();
    const app::ProgramSpec& spec() const { return spec_; }
    /// All options without a field of their own.
    OptionFields& further() { return *further_; }

    /// Positionals and options by the fields of the dialog.
    virtual QStringList ownArguments() const = 0;
    /// The missing input, in words for the user; empty when nothing is missing.
    virtual QString missing() const = 0;
    virtual void finish() = 0;

  private:
    QWidget* makeCommand();
    QWidget* makeFurther();

    const app::ProgramSpec& spec_;
    QFormLayout* form_;
    OptionFields* further_;
    QLineEdit* command_;
    QLabel* commandLabel_ = nullptr;
    PlainLabel* trouble_;
    QPushButton* accept_ = nullptr;
};

} // namespace gui

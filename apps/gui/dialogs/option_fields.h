/// Fields made from a program's table of options: the dialog shows each option that is added to the table.
#pragma once

#include "common/cli/options.h"

#include <QList>
#include <QStringList>
#include <QWidget>

#include <functional>
#include <string>
#include <string_view>

class QFormLayout;

namespace gui {

class OptionFields : public QWidget {
    Q_OBJECT

  public:
    /// All options of `spec` but those of these names, and those that answer a question.
    OptionFields(const app::ProgramSpec& spec, const QStringList& without, QWidget* parent = nullptr);

    /// The options of the fields that differ from the default, as the program takes them.
    QStringList arguments() const;

    /// A field that is off is grey and gives no argument, whatever is in it.
    void setOptionEnabled(std::string_view name, bool on);

  signals:
    void changed();

  private:
    struct Field {
        std::string name;
        std::function<QStringList()> values; ///< one for each time that the option is given
        bool isSwitch = false;
        QWidget* widget = nullptr;
    };
    void addField(QFormLayout& form, const app::Option& option);
    QWidget* makeSwitch(const app::Option& option);
    QWidget* makeChoice(const app::Option& option);
    QWidget* makeFile(const app::Option& option);
    QWidget* makeLine(const app::Option& option);

    QList<Field> fields_;
};

} // namespace gui

/// One setting in a form: its label, the editor that suits it, a slider where its range has two ends, and the
/// button that leads back to its default; so does a double click on the label. Knows no server.
#pragma once

#include <QMap>
#include <QObject>
#include <QString>

class QFormLayout;
class QToolButton;
class QWidget;

namespace rtcore {
struct Setting;
}

namespace gui {

class ValueSlider;

class SettingRow : public QObject {
    Q_OBJECT

  public:
    /// A row at the end of `form`. `label`: as it is called there.
    SettingRow(const rtcore::Setting& setting, const QString& label, QFormLayout& form, QObject* parent);

    /// Shows the server's value; a setting that the server does not know is disabled. Emits nothing. The
    /// field in which the user is typing is left alone.
    void show(const QMap<QString, QString>& values);

    const QString& name() const { return name_; }
    QWidget* editor() const { return editor_; }
    QToolButton* reset() const { return reset_; }
    ValueSlider* slider() const { return slider_; } ///< null where it has none
    bool differs() const { return differs_; }       ///< from its default

  signals:
    void edited(const QString& name, const QString& value);

  private:
    QWidget* makeEditor(const rtcore::Setting& setting, const QString& label);
    ValueSlider* makeSlider(const rtcore::Setting& setting);
    QToolButton* makeReset(const rtcore::Setting& setting);
    void place(const rtcore::Setting& setting, const QString& label, QFormLayout& form);
    void showValue(const QString& value);
    void goBack();
    bool eventFilter(QObject* watched, QEvent* event) override;

    QString name_, usual_; ///< the default, as text
    QWidget *editor_, *label_ = nullptr;
    ValueSlider* slider_;
    QToolButton* reset_;
    bool differs_ = false;
};

} // namespace gui

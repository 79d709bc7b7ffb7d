/// All settings of the table, each with the editor that suits it. Knows no server.
#pragma once

#include <QHash>
#include <QMap>
#include <QWidget>

class QFormLayout;
class QPushButton;

namespace rtcore {
struct Setting;
}

namespace gui {

class SettingsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit SettingsPanel(QWidget* parent = nullptr);

    /// What the server has; settings that it does not know are disabled. Emits nothing. The field in which
    /// the user is typing is left alone.
    void show(const QMap<QString, QString>& values);
    using QWidget::show;
    /// The field of a setting, by name; null when there is none.
    QWidget* editor(const QString& name) const { return editors_.value(name); }

  signals:
    void edited(const QString& name, const QString& value);
    void defaultsWanted();

  private:
    QFormLayout* addGroup(const QString& title, QWidget& column);
    void addSetting(const rtcore::Setting& setting, QFormLayout& form);
    QWidget* makeEditor(const rtcore::Setting& setting);
    void showValue(QWidget& editor, const QString& value);
    bool eventFilter(QObject* watched, QEvent* event) override;

    QHash<QString, QWidget*> editors_;
    QPushButton* defaults_;
};

} // namespace gui

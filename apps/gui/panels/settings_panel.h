/// All settings of the table, each with the editor that suits it, in groups that fold up. One that differs
/// from its default has a button that leads back. Knows no server.
#pragma once

#include <QHash>
#include <QMap>
#include <QWidget>

class QFormLayout;
class QHBoxLayout;
class QPushButton;
class QToolButton;

namespace rtcore {
struct Setting;
}

namespace gui {

class FoldBox;

class SettingsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit SettingsPanel(QWidget* parent = nullptr);

    /// What the server has; settings that it does not know are disabled. Emits nothing. The field in which
    /// the user is typing is left alone.
    void show(const QMap<QString, QString>& values);
    using QWidget::show;
    /// The field of a setting, by name; null when there is none.
    QWidget* editor(const QString& name) const { return rows_.value(name).editor; }
    /// The button that leads back to the default; hidden where nothing differs, and for the image's size,
    /// which follows the window.
    QToolButton* resetButton(const QString& name) const { return rows_.value(name).reset; }
    /// By Setting::group.
    FoldBox* group(const QString& key) const { return groups_.value(key); }
    /// Those that are folded up, by their keys.
    void setFolded(const QStringList& keys);

  signals:
    void edited(const QString& name, const QString& value);
    void defaultsWanted();
    /// By the user: those that are folded up now.
    void foldedChanged(const QStringList& keys);

  private:
    struct Row {
        QWidget* editor = nullptr;
        QToolButton* reset = nullptr;
        QString group, usual; ///< the default, as text
    };
    QFormLayout* addGroup(const QString& key, const QString& title, QWidget& column);
    void addSetting(const rtcore::Setting& setting, const QString& group, QFormLayout& form);
    QWidget* makeEditor(const rtcore::Setting& setting);
    QToolButton* makeReset(const rtcore::Setting& setting, const QString& usual);
    void showValue(QWidget& editor, const QString& value);
    QStringList folded() const;
    bool eventFilter(QObject* watched, QEvent* event) override;

    QHash<QString, Row> rows_; ///< by name of the setting
    QHash<QString, FoldBox*> groups_;
    QPushButton* defaults_;
};

} // namespace gui

/// All settings of the table: first the quality as a whole, then those that most people change, and the rest
/// under a fold, in groups that fold up, too. Knows no server.
#pragma once

#include "gui/panels/setting_row.h"

#include <QHash>
#include <QList>
#include <QMap>
#include <QWidget>

class QFormLayout;
class QPushButton;

namespace gui {

class FoldBox;
class QualityBar;

class SettingsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit SettingsPanel(QWidget* parent = nullptr);

    /// Shows the server's values; settings that it does not know are disabled. Emits nothing. The field in
    /// which the user is typing is left alone.
    void show(const QMap<QString, QString>& values);
    using QWidget::show;
    /// One more row below those that most people change; takes it over.
    void addToMain(const QString& label, QWidget* field);

    QualityBar& quality() { return *quality_; }
    /// The field of a setting, by name; null when there is none.
    QWidget* editor(const QString& name) const;
    /// The button that leads back to the default; hidden where nothing differs, and for the image's size,
    /// which follows the window.
    QToolButton* resetButton(const QString& name) const;
    /// Null where it has none.
    ValueSlider* slider(const QString& name) const;
    /// By Setting::group; what most people change is in none.
    FoldBox* group(const QString& key) const { return groups_.value(key); }
    /// The box that holds the groups; folded up at first.
    FoldBox& advanced() { return *advanced_; }
    /// Those that are folded up, by their keys.
    void setFolded(const QStringList& keys);

  signals:
    void edited(const QString& name, const QString& value);
    void qualityWanted(const QString& name);
    void defaultsWanted();
    /// By the user: those that are folded up now.
    void foldedChanged(const QStringList& keys);

  private:
    QFormLayout* addGroup(const QString& key, const QString& title, QWidget& column);
    void addRows(QWidget& groups);
    QStringList folded() const;

    QualityBar* quality_;
    QFormLayout* main_;
    FoldBox* advanced_;
    QHash<QString, SettingRow*> rows_; ///< by name of the setting
    QHash<QString, FoldBox*> groups_;
    QHash<QString, QList<SettingRow*>> rowsOf_; ///< by group
    QPushButton* defaults_;
};

} // namespace gui

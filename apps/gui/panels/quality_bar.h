/// How much work an image may be: one of three steps, none of which is pressed where settings are as in none.
#pragma once

#include <QMap>
#include <QString>
#include <QWidget>

class QAbstractButton;
class QButtonGroup;

namespace gui {

class PlainLabel;

class QualityBar : public QWidget {
    Q_OBJECT

  public:
    explicit QualityBar(QWidget* parent = nullptr);

    /// By values of settings. Emits nothing.
    void show(const QMap<QString, QString>& values);
    using QWidget::show;
    /// The button of a quality, by one of rtcore::kQualityNames; null for other names.
    QAbstractButton* step(const QString& name) const;
    /// Whether it says that the settings are as in none.
    bool saysCustom() const;

  signals:
    void chosen(const QString& name);

  private:
    QButtonGroup* steps_;
    PlainLabel* custom_;
    int now_ = -1; ///< -1: none of them
};

} // namespace gui

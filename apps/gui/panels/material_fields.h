/// The fields of one material. Knows no server.
#pragma once

#include "gui/models/model_lists.h"

#include <QList>
#include <QWidget>

class QCheckBox;
class QPushButton;

namespace gui {

class ColourButton;
class ValueBox;

class MaterialFields : public QWidget {
    Q_OBJECT

  public:
    explicit MaterialFields(QWidget* parent = nullptr);

    /// Nothing: no material is chosen. Emits nothing.
    void show(const std::optional<MaterialState>& material);
    using QWidget::show;
    /// By its key in a [[material]]; null when there is none.
    ValueBox* number(const QString& key) const;
    QCheckBox* textures() const { return textures_; }
    QPushButton* reset() const { return reset_; }

  signals:
    void numberEdited(const QString& key, double value);
    void colourEdited(const QString& key, const std::array<float, 3>& linear);
    void switched(const QString& key, bool on);
    void resetWanted();

  private:
    struct Number {
        QString key;
        ValueBox* box;
        float MaterialState::*value;
    };
    void addNumber(const QString& key, const QString& text, float MaterialState::*value, double minimum,
                   double maximum);
    ColourButton* addColour(const QString& key, const QString& text);

    QList<Number> numbers_;
    ColourButton *colour_, *tint_;
    QCheckBox *textures_, *flip_;
    QPushButton* reset_;
    MaterialState state_;
};

} // namespace gui

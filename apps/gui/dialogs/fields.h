/// Small pieces of which dialogs are made.
#pragma once

#include <QString>

#include <initializer_list>
#include <string_view>

class QSpinBox;
class QWidget;

namespace gui {

class PlainLabel;

/// A field for a whole number.
QSpinBox* numberField(int minimum, int maximum, int value, const QString& accessibleName);

/// The most that a whole-numbered setting of the table takes.
int maxOf(std::string_view setting);

/// Fields side by side, as one row of a form; the first one takes the focus of the row's label.
QWidget* rowOfFields(std::initializer_list<QWidget*> fields);

/// A sign between two fields.
QWidget* sign(const QString& text);

/// Sentences, over as many lines as they take.
PlainLabel* wrappedLabel(const QString& text = {});

} // namespace gui

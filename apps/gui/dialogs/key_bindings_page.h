/// The table of key bindings, to change.
#pragma once

#include "gui/models/bindings.h"

#include <QWidget>

class QTableWidget;

namespace gui {

class PlainLabel;

class KeyBindingsPage : public QWidget {
    Q_OBJECT

  public:
    explicit KeyBindingsPage(QWidget* parent = nullptr);

    void setBindings(const QList<Binding>& bindings);
    /// Rows whose key is none are left out; see valid().
    QList<Binding> bindings() const;
    bool valid() const;

  signals:
    void changed();

  private:
    void addRow(const Binding& binding);
    void removeRow();
    void check();

    QTableWidget* table_;
    PlainLabel* trouble_;
    bool filling_ = false;
};

} // namespace gui

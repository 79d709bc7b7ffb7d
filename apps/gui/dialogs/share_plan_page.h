/// Who may come in and do what, chosen before a server is shared in web pages.
#pragma once

#include "gui/models/own_addresses.h"
#include "gui/processes/bridge_process.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace gui {

class FileField;
class PlainLabel;
class Preferences;

class SharePlanPage : public QWidget {
    Q_OBJECT

  public:
    /// Begins with this machine alone, whatever was chosen before.
    SharePlanPage(Preferences& preferences, const QList<OwnAddress>& addresses, QWidget* parent = nullptr);

    BridgeRequest request() const; ///< without the server's name
    bool complete() const;         ///< it can be started
    void remember();               ///< as preferences
    void tell(const QString& trouble);

  signals:
    void changed();

  private:
    void build();
    void check();
    bool outside() const;
    bool encrypted() const;
    bool takesCertificate() const;

    Preferences& preferences_;
    QComboBox* from_;
    QComboBox* encryption_;
    FileField* certificate_;
    FileField* key_;
    QCheckBox* drive_;
    QCheckBox* edit_;
    QCheckBox* note_;
    PlainLabel* hint_;
    PlainLabel* trouble_;
    QFormLayout* form_;
};

} // namespace gui

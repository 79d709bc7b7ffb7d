/// Addresses by which other machines reach this one.
#pragma once

#include <QList>
#include <QString>

namespace gui {

struct OwnAddress {
    QString address; ///< numeric
    QString network; ///< the system's name of the interface, such as "wlan0"
};

/// Those of networks that are up, IPv4 first; not those that count on one wire alone. Empty without a
/// network.
QList<OwnAddress> ownAddresses();

} // namespace gui

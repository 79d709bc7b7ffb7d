#include "gui/models/own_addresses.h"

#include <QNetworkInterface>

#include <algorithm>

namespace gui {

QList<OwnAddress> ownAddresses() {
    QList<OwnAddress> addresses;
    const QList<QNetworkInterface> networks = QNetworkInterface::allInterfaces();
    for (const QNetworkInterface& network : networks) {
        const QNetworkInterface::InterfaceFlags flags = network.flags();
        if (!flags.testFlag(QNetworkInterface::IsUp) || flags.testFlag(QNetworkInterface::IsLoopBack))
            continue;
        const QList<QNetworkAddressEntry> entries = network.addressEntries();
        for (const QNetworkAddressEntry& entry : entries) {
            const QHostAddress address = entry.ip();
            if (!address.isLinkLocal() && !address.isLoopback())
                addresses.append({address.toString(), network.humanReadableName()});
        }
    }
    std::stable_partition(addresses.begin(), addresses.end(),
                          [](const OwnAddress& each) { return !each.address.contains(QLatin1Char(':')); });
    return addresses;
}

} // namespace gui

/// The messages of a .ts file.
#pragma once

#include <gtest/gtest.h>

#include <QFile>
#include <QList>
#include <QString>
#include <QXmlStreamReader>

namespace test {

struct Message {
    QString context, source, translation;
    bool finished = false;
};

inline QList<Message> messages(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QList<Message> all;
    QString context;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement()) continue;
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.name() == QLatin1String("source")) {
            all.append({context, xml.readElementText(), {}, false});
        } else if (xml.name() == QLatin1String("translation")) {
            all.last().finished = !xml.attributes().hasAttribute(QLatin1String("type"));
            all.last().translation = xml.readElementText(QXmlStreamReader::IncludeChildElements);
            while (all.last().translation.endsWith(QLatin1Char('\n'))) all.last().translation.chop(1);
        }
    }
    EXPECT_FALSE(xml.hasError());
    return all;
}

} // namespace test

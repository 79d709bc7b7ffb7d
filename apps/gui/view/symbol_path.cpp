#include "gui/view/symbol_path.h"

#include <QFile>
#include <QHash>
#include <QRegularExpression>

#include <cmath>
#include <numbers>
#include <optional>

namespace gui {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// The numbers and letters of a drawing, one after the other.
class Reader {
  public:
    explicit Reader(const QString& text) : words_(kWord.globalMatch(text)) { step(); }

    bool ended() const { return word_.isEmpty(); }
    bool atLetter() const { return !ended() && word_[0].isLetter(); }
    QChar letter() {
        const QChar found = word_[0];
        step();
        return found;
    }
    double number() {
        const double found = atLetter() ? 0 : word_.toDouble();
        if (!atLetter()) step();
        return found;
    }
    QPointF point(const QPointF& from) {
        const double x = number(), y = number();
        return from + QPointF(x, y);
    }

  private:
    void step() { word_ = words_.hasNext() ? words_.next().captured() : QString(); }

    static const QRegularExpression kWord;
    QRegularExpressionMatchIterator words_;
    QString word_;
};

const QRegularExpression Reader::kWord{QStringLiteral("[A-Za-z]|[-+]?(?:\\d*\\.\\d+|\\d+)")};

struct Arc {
    double xRadius, yRadius;
    bool large, clockwise;
};

/// From where the path is. (SVG 2, appendix B.2.4, of an ellipse that is not turned.)
void addArc(QPainterPath& path, const Arc& arc, const QPointF& end) {
    const QPointF start = path.currentPosition();
    if (start == end || arc.xRadius <= 0 || arc.yRadius <= 0) return path.lineTo(end);
    // On the unit circle.
    const auto scaled = [&](const QPointF& p) { return QPointF(p.x() / arc.xRadius, p.y() / arc.yRadius); };
    const QPointF half = (scaled(start) - scaled(end)) / 2;
    const double square = QPointF::dotProduct(half, half);
    const double factor = square >= 1 ? 1 : 1 / std::sqrt(square); // of half to the radius
    const double size = square >= 1 ? std::sqrt(square) : 1;       // radii that are too small grow
    const double far = square >= 1 ? 0 : std::sqrt(1 - square) * factor;
    const double side = arc.large == arc.clockwise ? -far : far;
    const QPointF middle = (scaled(start) + scaled(end)) / 2 + side * QPointF(half.y(), -half.x());
    const auto angle = [&](const QPointF& p) {
        const QPointF from = scaled(p) - middle;
        return -std::atan2(from.y(), from.x()) * kDegrees; // Qt counts against the clock
    };
    double sweep = angle(end) - angle(start);
    if (arc.clockwise && sweep > 0) sweep -= 360;
    if (!arc.clockwise && sweep < 0) sweep += 360;
    const QPointF centre(middle.x() * arc.xRadius, middle.y() * arc.yRadius);
    const double width = arc.xRadius * size, height = arc.yRadius * size;
    path.arcTo(QRectF(centre.x() - width, centre.y() - height, 2 * width, 2 * height), angle(start), sweep);
}

/// One command and its numbers; false: it is none that is known.
bool addPart(QPainterPath& path, QChar command, Reader& reader) {
    const QPointF now = path.currentPosition();
    const QPointF from = command.isLower() ? now : QPointF();
    switch (command.toLower().unicode()) {
    case u'm':
        path.moveTo(reader.point(from));
        return true;
    case u'l':
        path.lineTo(reader.point(from));
        return true;
    case u'h':
        path.lineTo(from.x() + reader.number(), now.y());
        return true;
    case u'v':
        path.lineTo(now.x(), from.y() + reader.number());
        return true;
    case u'c': {
        const QPointF first = reader.point(from), second = reader.point(from);
        path.cubicTo(first, second, reader.point(from));
        return true;
    }
    case u'a': {
        Arc arc{};
        arc.xRadius = reader.number();
        arc.yRadius = reader.number();
        reader.number(); // turned by
        arc.large = reader.number() != 0;
        arc.clockwise = reader.number() != 0;
        addArc(path, arc, reader.point(from));
        return true;
    }
    case u'z':
        path.closeSubpath();
        return true;
    default:
        return false;
    }
}

QHash<QString, QPainterPath> readSymbols() {
    QFile file(QStringLiteral(":/symbols.html"));
    QHash<QString, QPainterPath> symbols;
    if (!file.open(QIODevice::ReadOnly)) return symbols;
    static const QRegularExpression kSymbol(QStringLiteral("<symbol id=\"i-(\\w+)\"[^>]*>(.*?)</symbol>"));
    static const QRegularExpression kShape(
        QStringLiteral("<path d=\"([^\"]*)\"|<circle cx=\"([\\d.]+)\" cy=\"([\\d.]+)\" r=\"([\\d.]+)\""));
    const QString text = QString::fromUtf8(file.readAll());
    for (const QRegularExpressionMatch& symbol : kSymbol.globalMatch(text)) {
        QPainterPath& path = symbols[symbol.captured(1)];
        for (const QRegularExpressionMatch& shape : kShape.globalMatch(symbol.captured(2))) {
            const auto number = [&](int group) { return shape.captured(group).toDouble(); };
            if (!shape.captured(1).isEmpty())
                path.addPath(pathOf(shape.captured(1)));
            else
                path.addEllipse(QPointF(number(2), number(3)), number(4), number(4));
        }
    }
    return symbols;
}

} // namespace

QPainterPath pathOf(const QString& drawing) {
    QPainterPath path;
    Reader reader(drawing);
    QChar command;
    while (!reader.ended()) {
        if (reader.atLetter()) {
            command = reader.letter();
        } else if (command.toLower() == QLatin1Char('m')) {
            command = command.isLower() ? QLatin1Char('l') : QLatin1Char('L'); // further points are lines
        } else if (command.toLower() == QLatin1Char('z')) {
            break; // takes no numbers
        }
        if (!addPart(path, command, reader)) break;
    }
    return path;
}

QPainterPath symbolPath(const QString& name) {
    static const QHash<QString, QPainterPath> kSymbols = readSymbols();
    return kSymbols.value(name);
}

} // namespace gui

#include "rtcore/io/import/scan/ply_rows.h"

#include "rtcore/io/import/scan/piece_reader.h"
#include "rtcore/io/import/scan/ply_elements.h"
#include "rtcore/io/import/scan/ply_numbers.h"
#include "rtcore/io/import/text/statement_pieces.h"
#include "rtcore/io/import/text/statement_text.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>

namespace rtcore {

namespace {

/// Numbers of a binary file.
class BinaryNumbers {
  public:
    BinaryNumbers(const InputFile& file, const PlyHeader& header, const std::function<void()>& alive)
        : in_(file, header.size, alive),
          swapped_(header.bigEndian != (std::endian::native == std::endian::big)) {}

    std::optional<double> next(PlyType type) {
        const std::size_t size = sizeOf(type);
        const auto bytes = in_.ahead(size);
        if (bytes.size() < size) return std::nullopt;
        const double number = withPlyType(type, [&](auto zero) {
            return static_cast<double>(plyNumber<decltype(zero)>(bytes.data(), swapped_));
        });
        in_.skip(size);
        return number;
    }
    bool hasRoomFor(double count) const { return count <= static_cast<double>(in_.left()); }

  private:
    PieceReader in_;
    bool swapped_;
};

/// Numbers of a line of text.
class LineNumbers {
  public:
    explicit LineNumbers(StatementText& in) : in_(in) {}
    std::optional<double> next(PlyType /*type*/) { return in_.preciseNumber(); }
    /// Words that are not there are missed soon enough.
    static bool hasRoomFor(double count) { return count <= 1e9; }

  private:
    StatementText& in_;
};

/// Values of one element; false where they end.
template <typename Numbers>
bool readRow(const PlyElement& element, std::uint64_t number, Numbers& numbers, PlyRow& row) {
    row.numbers.assign(element.properties.size(), 0);
    row.lists.resize(element.properties.size());
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        const auto first = numbers.next(property.listLength.value_or(property.type));
        if (!first) return false;
        row.numbers[i] = *first;
        if (!property.listLength) continue;
        row.lists[i].clear();
        if (!(*first >= 0) || !numbers.hasRoomFor(*first))
            refuseDamaged(say("its face {0} claims to have {1} corners", number,
                              static_cast<std::int64_t>(*first >= 0 ? std::min(*first, 9e18) : -1)));
        for (double k = 0; k < *first; ++k) {
            const auto member = numbers.next(property.type);
            if (!member) return false;
            row.lists[i].push_back(*member);
        }
    }
    return true;
}

class TextRows {
  public:
    TextRows(const PlyHeader& header, const UsePlyRow& use) : header_(header), use_(use) {}

    void read(std::string_view text) {
        StatementText in(text);
        for (; !in.atEnd(); in.endStatement()) {
            while (element_ < header_.elements.size() && row_ == header_.elements[element_].count)
                nextElement();
            if (element_ == header_.elements.size()) return;
            if (!in.hasWord()) continue;
            const PlyElement& element = header_.elements[element_];
            LineNumbers numbers(in);
            if (!readRow(element, row_, numbers, values_)) refuseCutOff(element, row_);
            use_(element, values_);
            ++row_;
        }
    }
    void finish() const {
        for (std::size_t e = element_; e < header_.elements.size(); ++e) {
            const std::uint64_t read = e == element_ ? row_ : 0;
            if (read < header_.elements[e].count) refuseCutOff(header_.elements[e], read);
        }
    }

  private:
    void nextElement() {
        ++element_;
        row_ = 0;
    }
    const PlyHeader& header_;
    const UsePlyRow& use_;
    std::size_t element_ = 0;
    std::uint64_t row_ = 0;
    PlyRow values_;
};

} // namespace

void readPlyRows(const InputFile& file, const PlyHeader& header, const std::function<void()>& alive,
                 const UsePlyRow& use) {
    if (header.isText) {
        TextRows rows(header, use);
        forEachStatements(
            file, alive, [&](std::string_view text, std::uint64_t) { rows.read(text); }, header.size);
        rows.finish();
        return;
    }
    BinaryNumbers numbers(file, header, alive);
    PlyRow row;
    for (const PlyElement& element : header.elements) {
        if (element.properties.empty()) continue;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (!readRow(element, i, numbers, row)) refuseCutOff(element, i);
            use(element, row);
        }
    }
}

} // namespace rtcore

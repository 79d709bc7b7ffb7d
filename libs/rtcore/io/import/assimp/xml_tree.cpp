#include "rtcore/io/import/assimp/xml_tree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rtcore::xml {

namespace {

using View = std::string_view;
constexpr View kBlanks = " \t\r\n";

/// What begins so is no element, and ends so.
constexpr std::array<std::pair<View, View>, 3> kPassedOver{
    {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}}};

class TreeReader {
  public:
    explicit TreeReader(View text) : text_(text) {}

    std::optional<std::vector<Node>> read() {
        for (std::size_t at = text_.find('<'); at != View::npos; at = text_.find('<', at)) {
            at = readMarkup(at);
            if (at == View::npos) return std::nullopt;
        }
        if (nodes_.empty() || !open_.empty()) return std::nullopt;
        return std::move(nodes_);
    }

  private:
    struct Open {
        std::uint32_t node, lastChild;
    };

    /// Where it goes on; npos where it cannot.
    std::size_t readMarkup(std::size_t at) {
        for (const auto& [begin, end] : kPassedOver) {
            if (text_.compare(at, begin.size(), begin) != 0) continue;
            const std::size_t last = text_.find(end, at + begin.size());
            return last == View::npos ? last : last + end.size();
        }
        const std::size_t close = endOfHead(text_, at);
        if (close == View::npos) return close;
        const View head = text_.substr(at + 1, close - at - 1);
        const bool sound = head.starts_with('!') || (head.starts_with('/') ? end(head) : begin(head));
        return sound ? close + 1 : View::npos;
    }

    bool begin(View head) {
        const bool isEmpty = head.ends_with('/');
        if (isEmpty) head.remove_suffix(1);
        const std::size_t name = std::min(head.find_first_of(kBlanks), head.size());
        const bool isSecondRoot = open_.empty() && !nodes_.empty();
        if (name == 0 || isSecondRoot || nodes_.size() >= kNoNode) return false;
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({head.substr(0, name), head.substr(name)});
        if (!open_.empty()) {
            Open& parent = open_.back();
            (parent.lastChild == kNoNode ? nodes_[parent.node].firstChild
                                         : nodes_[parent.lastChild].nextSibling) = number;
            parent.lastChild = number;
        }
        if (!isEmpty) open_.push_back({number, kNoNode});
        return true;
    }

    bool end(View head) {
        const View name = head.substr(1, std::min(head.find_first_of(kBlanks), head.size()) - 1);
        if (open_.empty() || nodes_[open_.back().node].name != name) return false;
        open_.pop_back();
        return true;
    }

    View text_;
    std::vector<Node> nodes_;
    std::vector<Open> open_;
};

} // namespace

std::size_t endOfHead(View text, std::size_t at) {
    char quote = 0;
    int brackets = 0;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '[' || c == ']') {
            brackets += c == '[' ? 1 : -1;
        } else if (c == '>' && brackets <= 0) {
            return at;
        }
    }
    return View::npos;
}

std::optional<Attribute> takeAttribute(View& attributes) {
    const std::size_t equals = attributes.find('=');
    const std::size_t open = attributes.find_first_of("\"'", equals == View::npos ? 0 : equals);
    if (equals == View::npos || open == View::npos) return std::nullopt;
    const std::size_t close = attributes.find(attributes[open], open + 1);
    if (close == View::npos) return std::nullopt;
    View name = attributes.substr(0, equals);
    name.remove_prefix(std::min(name.find_first_not_of(kBlanks), name.size()));
    name = name.substr(0, name.find_last_not_of(kBlanks) + 1);
    const Attribute attribute{name, attributes.substr(open + 1, close - open - 1)};
    attributes.remove_prefix(close + 1);
    return attribute;
}

View attributeOf(const Node& node, View name) {
    View rest = node.attributes;
    while (const auto attribute = takeAttribute(rest))
        if (attribute->name == name) return attribute->value;
    return {};
}

std::optional<std::vector<Node>> treeOf(View text) { return TreeReader(text).read(); }

} // namespace rtcore::xml

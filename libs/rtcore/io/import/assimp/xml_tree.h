/// The elements of an XML document, without a reader of XML.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore::xml {

inline constexpr std::uint32_t kNoNode = 0xFFFFFFFFU;

/// The `>` that ends the head of an element, or a document type, that begins at that `<`: none in quotes or
/// in brackets. npos where it does not end.
std::size_t endOfHead(std::string_view text, std::size_t begin);

/// Views into the text that it was found in.
struct Node {
    std::string_view name, attributes;
    std::uint32_t firstChild = kNoNode, nextSibling = kNoNode;
};

/// Value as it stands between its quotes, with entities.
struct Attribute {
    std::string_view name, value;
};

/// The next attribute, which is cut off `attributes`; nothing at the end, or where there is none.
std::optional<Attribute> takeAttribute(std::string_view& attributes);

/// "" where there is none.
std::string_view attributeOf(const Node& node, std::string_view name);

/// The outermost element is the first. Comments, instructions, the document type and text are passed over.
/// Nothing where an element does not end, or another one ends in its place.
std::optional<std::vector<Node>> treeOf(std::string_view text);

} // namespace rtcore::xml

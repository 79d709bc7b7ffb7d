/// Elements of XML found in its text, without a reader of XML.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rtcore::xml {

/// Views into the text that it was found in.
struct Element {
    std::string_view head; ///< with its attributes
    std::string_view body;
};

/// The next element of this name in `text`, which is cut behind it. Elements do not hold others of their
/// name.
std::optional<Element> takeElement(std::string_view& text, const std::string& name);

/// "" where there is none.
std::string attributeOf(std::string_view head, const std::string& name);

/// An element's attribute, as it stands in the text; empty where there is none.
std::string_view valueOf(const Element& element, std::string_view name);

/// "#id" without its mark.
std::string idOf(const std::string& url);

/// The text of a file without comments. Throws as openFileBytes() does.
std::string textWithoutComments(const std::filesystem::path& path);

/// Whether the file is Collada by its name.
bool isCollada(const std::filesystem::path& path);

} // namespace rtcore::xml

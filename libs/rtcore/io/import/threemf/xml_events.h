/// XML as it comes: beginnings and ends of elements.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rtcore::threemf {

/// A name in a space of names; both "" where there is none.
struct XmlName {
    std::string_view space, name;
};

/// The beginning of an element. Valid while it is told.
class XmlElement {
  public:
    /// Pairs of names and values, ended by a null pointer.
    XmlElement(XmlName name, const char* const* attributes) : name_(name), attributes_(attributes) {}
    std::string_view space() const { return name_.space; }
    std::string_view name() const { return name_.name; }
    /// One without a space of its own, by its name; nothing where there is none.
    std::optional<std::string_view> attribute(std::string_view name) const;
    /// One with the name, whatever its space.
    std::optional<std::string_view> anyAttribute(std::string_view name) const;
    std::string text(std::string_view name) const { return std::string(attribute(name).value_or("")); }

  private:
    XmlName name_;
    const char* const* attributes_;
};

class XmlEvents {
  public:
    XmlEvents() = default;
    virtual ~XmlEvents() = default;
    XmlEvents(const XmlEvents&) = delete;
    XmlEvents& operator=(const XmlEvents&) = delete;
    /// A prefix of names, before the element that declares it; "" for that of names without one.
    virtual void declare(std::string_view /*prefix*/, std::string_view /*space*/) {}
    virtual void begin(const XmlElement& element) = 0;
    virtual void end(XmlName name) = 0;
    virtual void text(std::string_view /*piece*/) {}
};

/// Reads a text piece by piece. Declarations of document types are refused, entities with them; text in
/// UTF-8, UTF-16 and Latin-1 is read.
class XmlReader {
  public:
    /// `events` must outlive the object. `part` is for messages.
    XmlReader(XmlEvents& events, std::string part);
    ~XmlReader();
    XmlReader(const XmlReader&) = delete;
    XmlReader& operator=(const XmlReader&) = delete;
    /// Both throw FileError BadData with the line of what is wrong, and what `events` throw.
    void read(std::span<const char> piece);
    void finish();

  private:
    struct Parser;
    void parse(std::span<const char> piece, bool last);
    std::unique_ptr<Parser> parser_;
};

} // namespace rtcore::threemf
